// SPDX-License-Identifier: MIT
// The store of all particles: tiles of W particles, grouped by home block.
//
// A tile holds one column after another, each W numbers wide (one cache line in single precision on AVX-512), and
// particles of one material only, so that material constants are scalars in the physics. Particles of a block are
// sorted by material and cell when the block is formed and may then drift up to one node distance out of it.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "solver/core/lanes.h"

namespace bake {

/// A buffer on a 64-byte boundary. It is zero at first.
template <class Real>
class AlignedBuffer {
 public:
  AlignedBuffer() = default;
  AlignedBuffer(const AlignedBuffer& other) {
    resize_and_forget(other.size_);
    if (size_ > 0) std::memcpy(data(), other.data(), size_ * sizeof(Real));
  }
  AlignedBuffer(AlignedBuffer&& other) noexcept { swap(other); }  // what is left there is empty
  AlignedBuffer& operator=(AlignedBuffer other) noexcept {
    swap(other);
    return *this;
  }
  void resize_and_forget(std::size_t count) {
    if (count > capacity_) data_.reset();  // before the larger one is there
    reserve(count);
    size_ = count;
  }
  /// Room for so many numbers, and a sixteenth more where it has to grow. Those that it has stay.
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    const std::size_t capacity = count + count / 16;
    auto* raw = static_cast<Real*>(std::aligned_alloc(64, (capacity * sizeof(Real) + 63) / 64 * 64));
    if (!raw) throw std::bad_alloc();
    const std::size_t kept = data_ ? size_ : 0;
    if (kept > 0) std::memcpy(raw, data(), kept * sizeof(Real));
    std::memset(raw + kept, 0, (capacity - kept) * sizeof(Real));
    data_.reset(raw);
    capacity_ = capacity;
  }
  Real* data() { return data_.get(); }
  const Real* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  std::size_t bytes() const { return capacity_ * sizeof(Real); }
  void swap(AlignedBuffer& other) {
    data_.swap(other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  struct Free {
    void operator()(Real* p) const { std::free(p); }
  };
  std::unique_ptr<Real[], Free> data_;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Integer coordinates of a 4x4x4 block of nodes in the domain's grid of blocks.
struct BlockIndex {
  int x, y, z;
  bool operator==(const BlockIndex&) const = default;
};

struct Tile {
  std::int32_t material;
  std::int32_t count;  ///< lanes that hold a particle; the others repeat the last one and are never scattered
};

/// A block of nodes that is the home of some particles.
struct HomeBlock {
  BlockIndex at;
  std::int32_t first_tile;
  std::int32_t tiles;
  std::int32_t neighbour[27];   ///< grid blocks around it, (dx + 1) * 9 + (dy + 1) * 3 + dz + 1
  bool at_face;                 ///< may its particles reach a face of the domain?
  std::int8_t low[3], high[3];  ///< tile nodes (0..7) that its particles touched at the last scatter
};

template <class Real>
struct ParticleStore {
  int columns = 0;
  AlignedBuffer<Real> data;  ///< [tile][column][W]
  std::vector<Tile> tiles;
  std::vector<HomeBlock> blocks;  ///< ordered by x, then y, then z

  static constexpr int width = k_width<Real>;
  std::size_t tile_size() const { return static_cast<std::size_t>(columns) * width; }
  Lanes<Real>* tile(std::size_t t) { return reinterpret_cast<Lanes<Real>*>(data.data() + t * tile_size()); }
  const Lanes<Real>* tile(std::size_t t) const { return reinterpret_cast<const Lanes<Real>*>(data.data() + t * tile_size()); }
  std::size_t particles() const {
    std::size_t n = 0;
    for (const Tile& t : tiles) n += static_cast<std::size_t>(t.count);
    return n;
  }
};

/// Columns 0..2 are the position and column 3 is the identity, which the engine needs. The effects name all other columns.
inline constexpr int k_position_column = 0;
inline constexpr int k_identity_column = 3;

/// The number that identifies a particle during the whole run; its bits are stored in a column.
template <class Real>
std::int64_t identity_of(const Lanes<Real>* columns, int lane) {
  const Real bits = columns[k_identity_column][lane];
  if constexpr (sizeof(Real) == 4) return std::bit_cast<std::int32_t>(bits);
  return static_cast<std::int64_t>(bits);
}
template <class Real>
Real identity_bits(std::int64_t identity) {
  if constexpr (sizeof(Real) == 4) return std::bit_cast<float>(static_cast<std::int32_t>(identity));
  return static_cast<Real>(identity);
}

}  // namespace bake

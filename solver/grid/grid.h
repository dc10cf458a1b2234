// SPDX-License-Identifier: MIT
// The grid: a box of nodes of which only the blocks around particles exist.
//
// Nodes are grouped in blocks of 4x4x4. Each node has two rows of numbers: what particles scattered to it, and the shorter row that the
// grid update makes of it and that particles gather. Only the 27 blocks around every home block of particles are stored.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/boundary/shape.h"
#include "solver/core/vector3.h"
#include "solver/grid/particle_store.h"

namespace bake {

inline constexpr int k_block_nodes = 64;
/// The surface measure mirrors dough into this many nodes beyond a face of the domain: dough reaches the first, and the area there depends
/// on the volume of three more.
inline constexpr int k_mirrored = 4;

/// How many packs of W nodes a block has.
template <class Real>
inline constexpr int k_packs = k_block_nodes / k_width<Real>;

/// The number of a node in its block, 0..63, from its coordinates 0..3.
constexpr int node_in_block(int x, int y, int z) { return (x * 4 + y) * 4 + z; }

/// Its inverse.
constexpr std::array<int, 3> coordinates_in_block(int node) { return {node / 16, node / 4 % 4, node % 4}; }

/// The position of a node [m] in a block whose first node is at `origin`.
inline Point node_position(const Point& origin, double dx, int node) {
  const auto [x, y, z] = coordinates_in_block(node);
  return origin + dx * Vector3{double(x), double(y), double(z)};
}

/// Where blocks and nodes are in space.
class GridGeometry {
 public:
  /// `low`, `high`: corners of the domain [m]. The lower corner is a node, eight nodes from the grid's first, so that a stencil at a
  /// face stays inside the grid. `periodic`: axes whose two faces are one, a multiple of 4 cells apart; blocks beyond a face are then those
  /// at the opposite one.
  GridGeometry(const Point& low, const Point& high, double dx, const std::array<bool, 3>& periodic = {})
      : dx_(dx), periodic_(periodic), any_periodic_(periodic[0] || periodic[1] || periodic[2]) {
    for (int d = 0; d < 3; ++d) {
      origin_[d] = low[d] - k_margin * dx;
      cells_[d] = std::max(1, static_cast<int>(std::ceil((high[d] - low[d]) / dx - 1e-6)));
      blocks_[d] = (cells_[d] + 2 * k_margin) / 4 + 2;
    }
  }
  static constexpr int k_margin = 8;

  double dx() const { return dx_; }
  int blocks(int axis) const { return blocks_[axis]; }
  std::size_t block_count() const { return static_cast<std::size_t>(blocks_[0]) * blocks_[1] * blocks_[2]; }
  std::size_t linear(const BlockIndex& b) const { return (static_cast<std::size_t>(b.x) * blocks_[1] + b.y) * blocks_[2] + b.z; }
  BlockIndex block(std::size_t linear) const {
    return {static_cast<int>(linear / blocks_[2] / blocks_[1]), static_cast<int>(linear / blocks_[2] % blocks_[1]),
            static_cast<int>(linear % blocks_[2])};
  }
  /// First node of a block [m].
  Point origin(const BlockIndex& b) const { return {origin_[0] + 4 * b.x * dx_, origin_[1] + 4 * b.y * dx_, origin_[2] + 4 * b.z * dx_}; }
  /// Position in node distances from the grid's first node.
  double in_nodes(double x, int axis) const { return (x - origin_[axis]) / dx_; }
  bool is_periodic(int axis) const { return periodic_[static_cast<std::size_t>(axis)]; }
  bool any_periodic() const { return any_periodic_; }
  /// Blocks from one periodic face to the other.
  int period(int axis) const { return cells_[axis] / 4; }
  /// The block between the periodic faces that is the same as `b`.
  BlockIndex wrapped(BlockIndex b) const {
    if (!any_periodic_) return b;
    int* const at[3] = {&b.x, &b.y, &b.z};
    for (int d = 0; d < 3; ++d)
      if (is_periodic(d)) *at[d] = k_margin / 4 + ((*at[d] - k_margin / 4) % period(d) + period(d)) % period(d);
    return b;
  }
  /// The place between the periodic faces that is the same as `x` [m].
  Point wrapped(Point x) const {
    for (int d = 0; d < 3; ++d) {
      if (!is_periodic(d)) continue;
      double& x_d = x[static_cast<std::size_t>(d)];
      const double low = origin_[static_cast<std::size_t>(d)] + k_margin * dx_, length = cells_[d] * dx_;
      if (x_d < low) x_d += length;
      if (x_d >= low + length) x_d -= length;
    }
    return x;
  }
  /// Calls visit(block) for all blocks of the grid that are the same as `b`, which lies between the periodic faces.
  template <class Visit>
  void for_each_image(const BlockIndex& b, Visit visit) const {
    const int at[3] = {b.x, b.y, b.z};
    int first[3], step[3];
    for (int d = 0; d < 3; ++d) {
      step[d] = is_periodic(d) ? period(d) : blocks_[d];
      first[d] = is_periodic(d) ? at[d] % step[d] : at[d];
    }
    for (int x = first[0]; x < blocks_[0]; x += step[0])
      for (int y = first[1]; y < blocks_[1]; y += step[1])
        for (int z = first[2]; z < blocks_[2]; z += step[2]) visit(BlockIndex{x, y, z});
  }
  /// The smallest number that no block beside it along that axis has: two in turn, and a third where an odd number of blocks closes to a
  /// ring.
  int colour(int block, int axis) const {
    const bool closes = is_periodic(axis) && period(axis) % 2 != 0 && period(axis) > 1 && block == k_margin / 4 + period(axis) - 1;
    return closes ? 2 : block & 1;
  }
  /// Is the point in the domain, its faces included?
  bool holds(const Point& x) const {
    for (int d = 0; d < 3; ++d)
      if (const double nodes = in_nodes(x[d], d); !(nodes >= low_face() && nodes <= high_face(d))) return false;
    return true;
  }
  /// The domain's faces, in node distances from the grid's first node.
  double low_face() const { return k_margin; }
  double high_face(int axis) const { return k_margin + cells_[axis]; }

 private:
  double dx_;
  Point origin_;
  int cells_[3], blocks_[3];
  std::array<bool, 3> periodic_;
  bool any_periodic_;
};

/// Which blocks exist, and in which order they are kept.
struct ActiveBlocks {
  std::vector<BlockIndex> at;
  std::vector<std::int32_t> slot_of;  ///< by linear block number; -1: not stored

  std::vector<std::array<std::int32_t, 27>> around;  ///< slots of a block's neighbours and its own, as in HomeBlock; -1: not stored
  std::vector<char> touched;                         ///< by slot: may something have been scattered to its nodes?

  /// Creates the 27 blocks around every home block, and those into which dough is mirrored at a face of the domain, in the order in which
  /// they are first used; writes the neighbour tables.
  void surround(std::vector<HomeBlock>& homes, const GridGeometry& geometry) {
    if (slot_of.size() != geometry.block_count()) slot_of.assign(geometry.block_count(), -1);
    for (const BlockIndex& b : at) geometry.for_each_image(b, [&](const BlockIndex& image) { slot_of[geometry.linear(image)] = -1; });
    at.clear();
    for (HomeBlock& home : homes) {
      for (int i = 0; i < 27; ++i) home.neighbour[i] = make(neighbour(home.at, i), geometry);
      make_mirrored(home.at, geometry);
    }
    around.resize(at.size());
    for (std::size_t s = 0; s < at.size(); ++s)
      for (int i = 0; i < 27; ++i) around[s][static_cast<std::size_t>(i)] = slot_at(neighbour(at[s], i), geometry);
  }
  /// Marks the blocks to which the particles of the homes scattered.
  void find_touched(const std::vector<HomeBlock>& homes) {
    touched.assign(at.size(), 0);
    for (const HomeBlock& home : homes) {
      const auto first = [&](int axis) { return (home.low[axis] + 3) / 4; };  // the tile begins one node before the home
      const auto last = [&](int axis) { return (home.high[axis] + 3) / 4; };
      for (int x = first(0); x <= last(0); ++x)
        for (int y = first(1); y <= last(1); ++y)
          for (int z = first(2); z <= last(2); ++z) touched[static_cast<std::size_t>(home.neighbour[x * 9 + y * 3 + z])] = 1;
    }
  }
  /// Slot of a block, or -1.
  std::int32_t slot_at(const BlockIndex& b, const GridGeometry& geometry) const {
    if (b.x < 0 || b.y < 0 || b.z < 0 || b.x >= geometry.blocks(0) || b.y >= geometry.blocks(1) || b.z >= geometry.blocks(2)) return -1;
    return slot_of[geometry.linear(b)];
  }

 private:
  std::int32_t make(const BlockIndex& b, const GridGeometry& geometry) {
    std::int32_t slot = slot_of[geometry.linear(b)];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(at.size());
      at.push_back(geometry.wrapped(b));
      geometry.for_each_image(at.back(), [&](const BlockIndex& image) { slot_of[geometry.linear(image)] = slot; });
    }
    return slot;
  }
  /// A home's particles reach its nodes -1 to 6; the images of those, up to k_mirrored nodes beyond a face (solver/engine/surface.cpp), may
  /// lie further than one block away.
  void make_mirrored(const BlockIndex& home, const GridGeometry& geometry) {
    const int first[3] = {4 * home.x, 4 * home.y, 4 * home.z};
    int low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};
    bool more = false;
    for (int d = 0; d < 3; ++d) {
      if (geometry.is_periodic(d)) continue;
      const int low_face = static_cast<int>(geometry.low_face()) - first[d], high_face = static_cast<int>(geometry.high_face(d)) - first[d];
      if (low_face + k_mirrored >= -1) low[d] = std::min(-1, (low_face - k_mirrored) >> 2);
      if (high_face - k_mirrored <= 6) high[d] = std::max(1, (high_face + k_mirrored) >> 2);
      more |= low[d] < -1 || high[d] > 1;
    }
    if (!more) return;
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z) make({home.x + x, home.y + y, home.z + z}, geometry);
  }
  static BlockIndex neighbour(const BlockIndex& b, int i) { return {b.x + i / 9 - 1, b.y + i / 3 % 3 - 1, b.z + i % 3 - 1}; }
};

}  // namespace bake

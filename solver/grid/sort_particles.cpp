// SPDX-License-Identifier: MIT
#include "solver/grid/sort_particles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "solver/core/parallel.h"
#include "solver/grid/tile.h"

namespace bake {

template <class Real>
Home<Real> find_home(const BlockIndex& block, const Real (&x)[3]) {
  Home<Real> home;
  int shift[3], cell[3];
  for (int d = 0; d < 3; ++d) {
    const int first = static_cast<int>(std::floor(x[d] - Real(0.5)));
    shift[d] = first >> 2;
    cell[d] = first & 3;
    home.x[d] = x[d] - Real(4 * shift[d]);
  }
  home.block = {block.x + shift[0], block.y + shift[1], block.z + shift[2]};
  home.cell = node_in_block(cell[0], cell[1], cell[2]);
  return home;
}

namespace {

/// Where a particle goes, by its number: that of its tile, through both sources one after the other, times W, and its lane.
struct SortKey {
  std::uint32_t block;  ///< linear number of its new home
  std::uint16_t cell;   ///< in that block
  std::uint16_t material;
};

constexpr std::uint32_t k_left_out = 0xffffffffu;

template <class Real>
void write_keys(const ParticleStore<Real>& from, std::uint32_t first_tile, const GridGeometry& geometry,
                const std::function<bool(std::int32_t, std::int32_t)>* leave_out, std::vector<SortKey>& keys) {
  constexpr int W = k_width<Real>;
  const auto blocks = static_cast<std::int64_t>(from.blocks.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t b = 0; b < blocks; ++b) {
    const HomeBlock& block = from.blocks[static_cast<std::size_t>(b)];
    for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
      const Tile& tile = from.tiles[static_cast<std::size_t>(t)];
      const auto* columns = from.tile(static_cast<std::size_t>(t));
      for (std::int32_t l = 0; l < W; ++l) {
        SortKey& key = keys[(first_tile + static_cast<std::uint32_t>(t)) * W + static_cast<std::uint32_t>(l)];
        key = {k_left_out, 0, static_cast<std::uint16_t>(tile.material)};
        if (l >= tile.count || (leave_out && (*leave_out)(t, l))) continue;
        const Real x[3] = {columns[0][l], columns[1][l], columns[2][l]};
        const Home<Real> home = find_home(block.at, x);
        key.block = static_cast<std::uint32_t>(geometry.linear(geometry.wrapped(home.block)));
        key.cell = static_cast<std::uint16_t>(home.cell);
      }
    }
  }
}

/// Blocks of the new order that are written side by side: from one to the next, and of the store's old tiles the first that these blocks or
/// later ones are made of.
struct Portion {
  std::size_t first, end;
  std::size_t oldest_needed;
};

/// Of some thousand tiles each. `oldest_of(b)`: the first of the store's old tiles that block b is made of.
template <class OldestOf>
std::vector<Portion> portions(const std::vector<HomeBlock>& blocks, OldestOf oldest_of) {
  constexpr std::int32_t k_tiles = 4096;
  std::vector<Portion> all;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (all.empty() || blocks[b].first_tile - blocks[all.back().first].first_tile >= k_tiles)
      all.push_back({b, b, std::numeric_limits<std::size_t>::max()});
    all.back().end = b + 1;
    all.back().oldest_needed = std::min(all.back().oldest_needed, oldest_of(b));
  }
  for (std::size_t i = all.size(); i-- > 1;) all[i - 1].oldest_needed = std::min(all[i - 1].oldest_needed, all[i].oldest_needed);
  return all;
}

/// Moves the old tiles back by `shift` tiles, so that none is overwritten before it is read.
template <class Real>
void move_back(ParticleStore<Real>& store, std::size_t shift, std::size_t new_tiles) {
  const std::size_t old = store.data.size(), gap = shift * store.tile_size();
  const std::size_t wanted = std::max(old + gap, new_tiles * store.tile_size());
  store.data.reserve(wanted);
  store.data.resize_and_forget(wanted);  // it fits: nothing is forgotten
  if (old > 0 && gap > 0) std::memmove(store.data.data() + gap, store.data.data(), old * sizeof(Real));
}

}  // namespace

bool may_reach_face(const BlockIndex& block, const GridGeometry& geometry) {
  const int first[3] = {4 * block.x, 4 * block.y, 4 * block.z};
  for (int d = 0; d < 3; ++d)
    if (!geometry.is_periodic(d) && (first[d] - 4 < geometry.low_face() || first[d] + 8 > geometry.high_face(d))) return true;
  return false;
}

template <class Real>
void sort_particles(ParticleStore<Real>& store, const ParticleStore<Real>* more, const GridGeometry& geometry,
                    const std::function<bool(std::int32_t, std::int32_t)>& leave_out) {
  constexpr int W = k_width<Real>;
  const std::size_t old_tiles = store.tiles.size(), tiles = old_tiles + (more ? more->tiles.size() : 0);
  std::vector<SortKey> keys(tiles * W);
  write_keys(store, 0, geometry, leave_out ? &leave_out : nullptr, keys);
  if (more) write_keys(*more, static_cast<std::uint32_t>(old_tiles), geometry, nullptr, keys);

  // counting sort by block
  std::vector<std::uint32_t> first(geometry.block_count() + 1, 0);
  for (const SortKey& t : keys)
    if (t.block != k_left_out) ++first[t.block + 1];
  std::vector<HomeBlock>& blocks = store.blocks;
  blocks.clear();
  for (std::size_t b = 0; b < geometry.block_count(); ++b) {
    if (first[b + 1] > 0) {
      HomeBlock block{};
      block.at = geometry.block(b);
      block.at_face = may_reach_face(block.at, geometry);
      for (int d = 0; d < 3; ++d)
        block.low[d] = 0, block.high[d] = k_tile_side - 1;  // all of it, until the first scatter tells what it touched
      blocks.push_back(block);
    }
    first[b + 1] += first[b];
  }
  std::vector<std::uint32_t> sorted(first.back());
  {
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (keys[i].block != k_left_out) sorted[next[keys[i].block]++] = static_cast<std::uint32_t>(i);
  }

  // within a block by material, then cell; a tile holds one material
  std::vector<std::vector<Tile>> tiles_of(blocks.size());
  std::vector<std::size_t> oldest_of(blocks.size(), std::numeric_limits<std::size_t>::max());
  for_each_parallel(blocks.size(), 8, [&](std::size_t b) {
    const std::size_t linear = geometry.linear(blocks[b].at);
    const auto begin = sorted.begin() + first[linear], end = sorted.begin() + first[linear + 1];
    std::stable_sort(begin, end, [&](std::uint32_t i, std::uint32_t j) {
      const SortKey &a = keys[i], &c = keys[j];
      return a.material != c.material ? a.material < c.material : a.cell < c.cell;
    });
    std::vector<Tile>& mine = tiles_of[b];
    for (auto i = begin; i != end; ++i) {
      const std::int32_t material = keys[*i].material;
      if (mine.empty() || mine.back().material != material || mine.back().count == W) mine.push_back({material, 0});
      ++mine.back().count;
      if (const std::size_t tile = *i / W; tile < old_tiles) oldest_of[b] = std::min(oldest_of[b], tile);
    }
  });
  keys = {};
  store.tiles.clear();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    blocks[b].first_tile = static_cast<std::int32_t>(store.tiles.size());
    blocks[b].tiles = static_cast<std::int32_t>(tiles_of[b].size());
    store.tiles.insert(store.tiles.end(), tiles_of[b].begin(), tiles_of[b].end());
  }

  // what a portion writes must lie before what it and later ones still read
  const std::vector<Portion> all = portions(blocks, [&](std::size_t b) { return oldest_of[b]; });
  std::size_t shift = 0;
  for (const Portion& portion : all) {
    const HomeBlock& last = blocks[portion.end - 1];
    const auto end = static_cast<std::size_t>(last.first_tile + last.tiles);
    if (end > portion.oldest_needed) shift = std::max(shift, end - portion.oldest_needed);
  }
  const std::size_t size = store.tile_size();
  move_back(store, shift, store.tiles.size());
  const Real* old = store.data.data() + shift * size;
  for (const Portion& portion : all)
    for_each_parallel(portion.end - portion.first, 8, [&](std::size_t i) {
      const HomeBlock& block = blocks[portion.first + i];
      std::size_t at = first[geometry.linear(block.at)];
      for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
        Real* target = store.data.data() + static_cast<std::size_t>(t) * size;
        const std::int32_t count = store.tiles[static_cast<std::size_t>(t)].count;
        for (std::int32_t l = 0; l < W; ++l) {
          const std::uint32_t number = sorted[at + static_cast<std::size_t>(std::min(l, count - 1))];
          const std::size_t tile = number / W, lane = number % W;
          const Real* origin = (tile < old_tiles ? old + tile * size : more->data.data() + (tile - old_tiles) * size) + lane;
          for (int c = 0; c < store.columns; ++c) target[c * W + l] = origin[c * W];
          // shifts the position to the new home by whole cells, to 0..3 on each axis; the fraction of a cell stays
          for (int d = 0; d < 3; ++d) {
            Real& x = target[d * W + l];
            x -= Real(4 * (static_cast<int>(std::floor(x - Real(0.5))) >> 2));
          }
        }
        at += static_cast<std::size_t>(count);
      }
    });
  store.data.resize_and_forget(store.tiles.size() * size);
}

template Home<float> find_home(const BlockIndex&, const float (&)[3]);
template Home<double> find_home(const BlockIndex&, const double (&)[3]);
template void sort_particles(ParticleStore<float>&, const ParticleStore<float>*, const GridGeometry&,
                             const std::function<bool(std::int32_t, std::int32_t)>&);
template void sort_particles(ParticleStore<double>&, const ParticleStore<double>*, const GridGeometry&,
                             const std::function<bool(std::int32_t, std::int32_t)>&);

}  // namespace bake

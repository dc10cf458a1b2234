// SPDX-License-Identifier: MIT
#include "solver/grid/sort_particles.h"

#include <algorithm>
#include <cmath>

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

/// Where a particle is now and where it goes.
struct SortKey {
  std::uint32_t block;  ///< linear number of its new home
  std::uint16_t cell;   ///< in that block
  std::uint16_t material;
  std::uint32_t tile;  ///< numbered through both sources, one after the other
  std::uint32_t lane;
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
        key = {k_left_out, 0, static_cast<std::uint16_t>(tile.material), first_tile + static_cast<std::uint32_t>(t),
               static_cast<std::uint32_t>(l)};
        if (l >= tile.count || (leave_out && (*leave_out)(t, l))) continue;
        const Real x[3] = {columns[0][l], columns[1][l], columns[2][l]};
        const Home<Real> home = find_home(block.at, x);
        key.block = static_cast<std::uint32_t>(geometry.linear(geometry.wrapped(home.block)));
        key.cell = static_cast<std::uint16_t>(home.cell);
      }
    }
  }
}

}  // namespace

bool may_reach_face(const BlockIndex& block, const GridGeometry& geometry) {
  const int first[3] = {4 * block.x, 4 * block.y, 4 * block.z};
  for (int d = 0; d < 3; ++d)
    if (!geometry.is_periodic(d) && (first[d] - 4 < geometry.low_face() || first[d] + 8 > geometry.high_face(d))) return true;
  return false;
}

template <class Real>
void sort_particles(const ParticleStore<Real>& from, const ParticleStore<Real>* more, const GridGeometry& geometry,
                    const std::function<bool(std::int32_t, std::int32_t)>& leave_out, ParticleStore<Real>& to) {
  constexpr int W = k_width<Real>;
  const std::size_t tiles = from.tiles.size() + (more ? more->tiles.size() : 0);
  std::vector<SortKey> keys(tiles * W);
  write_keys(from, 0, geometry, leave_out ? &leave_out : nullptr, keys);
  if (more) write_keys(*more, static_cast<std::uint32_t>(from.tiles.size()), geometry, nullptr, keys);

  // counting sort by block
  std::vector<std::uint32_t> first(geometry.block_count() + 1, 0);
  for (const SortKey& t : keys)
    if (t.block != k_left_out) ++first[t.block + 1];
  to.blocks.clear();
  for (std::size_t b = 0; b < geometry.block_count(); ++b) {
    if (first[b + 1] > 0) {
      HomeBlock block{};
      block.at = geometry.block(b);
      block.at_face = may_reach_face(block.at, geometry);
      for (int d = 0; d < 3; ++d)
        block.low[d] = 0, block.high[d] = k_tile_side - 1;  // all of it, until the first scatter tells what it touched
      to.blocks.push_back(block);
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
  const auto blocks = static_cast<std::int64_t>(to.blocks.size());
  std::vector<std::vector<Tile>> tiles_of(to.blocks.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t b = 0; b < blocks; ++b) {
    const std::size_t linear = geometry.linear(to.blocks[static_cast<std::size_t>(b)].at);
    const auto begin = sorted.begin() + first[linear], end = sorted.begin() + first[linear + 1];
    std::stable_sort(begin, end, [&](std::uint32_t i, std::uint32_t j) {
      const SortKey &a = keys[i], &c = keys[j];
      return a.material != c.material ? a.material < c.material : a.cell < c.cell;
    });
    auto& mine = tiles_of[static_cast<std::size_t>(b)];
    for (auto i = begin; i != end; ++i) {
      const std::int32_t material = keys[*i].material;
      if (mine.empty() || mine.back().material != material || mine.back().count == W) mine.push_back({material, 0});
      ++mine.back().count;
    }
  }
  to.tiles.clear();
  for (std::size_t b = 0; b < to.blocks.size(); ++b) {
    to.blocks[b].first_tile = static_cast<std::int32_t>(to.tiles.size());
    to.blocks[b].tiles = static_cast<std::int32_t>(tiles_of[b].size());
    to.tiles.insert(to.tiles.end(), tiles_of[b].begin(), tiles_of[b].end());
  }

  to.columns = from.columns;
  to.data.resize_and_forget(to.tiles.size() * to.tile_size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t b = 0; b < blocks; ++b) {
    const HomeBlock& block = to.blocks[static_cast<std::size_t>(b)];
    std::size_t at = first[geometry.linear(block.at)];
    for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
      Real* target = to.data.data() + static_cast<std::size_t>(t) * to.tile_size();
      const std::int32_t count = to.tiles[static_cast<std::size_t>(t)].count;
      for (std::int32_t l = 0; l < W; ++l) {
        const SortKey& key = keys[sorted[at + static_cast<std::size_t>(std::min(l, count - 1))]];
        const bool old = key.tile < from.tiles.size();
        const ParticleStore<Real>& source = old ? from : *more;
        const std::size_t tile = old ? key.tile : key.tile - from.tiles.size();
        const Real* origin = source.data.data() + tile * source.tile_size() + key.lane;
        for (int c = 0; c < to.columns; ++c) target[c * W + l] = origin[c * W];
        // shifts the position to the new home by whole cells, to 0..3 on each axis; the fraction of a cell stays
        for (int d = 0; d < 3; ++d) {
          Real& x = target[d * W + l];
          x -= Real(4 * (static_cast<int>(std::floor(x - Real(0.5))) >> 2));
        }
      }
      at += static_cast<std::size_t>(count);
    }
  }
}

template Home<float> find_home(const BlockIndex&, const float (&)[3]);
template Home<double> find_home(const BlockIndex&, const double (&)[3]);
template void sort_particles(const ParticleStore<float>&, const ParticleStore<float>*, const GridGeometry&,
                             const std::function<bool(std::int32_t, std::int32_t)>&, ParticleStore<float>&);
template void sort_particles(const ParticleStore<double>&, const ParticleStore<double>*, const GridGeometry&,
                             const std::function<bool(std::int32_t, std::int32_t)>&, ParticleStore<double>&);

}  // namespace bake

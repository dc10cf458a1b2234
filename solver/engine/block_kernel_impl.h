// SPDX-License-Identifier: MIT
// The fused transfers (G2P2G) of one block.
//
// The 8x8x8 nodes around a block (-1..6) are copied into a tile in the first-level cache. The particles are taken W at a time, and what
// they scatter is summed in a second tile, which is added to the grid at the end. Particles may drift one node distance out of their
// block and still find their stencil in the tile.
//
// A core makes two multiply-adds, two sums, two loads and one store per cycle. So the code shares products, replaces multiply-adds by sums,
// and stores seldom.
#pragma once

#include <algorithm>
#include <cstring>
#include <optional>

#include "solver/core/rows.h"
#include "solver/engine/block_kernel.h"
#include "solver/engine/block_tile.h"
#include "solver/grid/gather.h"
#include "solver/grid/scatter.h"

namespace bake {

template <class Real, KernelOrder order, int RS, int RG>
class BlockKernelOf final : public BlockKernel<Real> {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>;
  static constexpr int N = Kernel<order>::support;
  using FromTile = Gather<Real, order, RG>;
  using ToTile = Scatter<Real, order, RS>;

  /// 0, 1, 2, ...
  static inline const V k_lane_numbers = [] {
    V v{};
    for (int l = 0; l < W; ++l) v[l] = static_cast<Real>(l);
    return v;
  }();

 public:
  int scattered_row() const override { return RS; }
  int gathered_row() const override { return RG; }
  int particle_rows() const override { return ToTile::k_particle; }

  void advance(const BlockWork<Real>& work, int index, Scratch<Real>& scratch, BlockResult<Real>& result, bool totals) const override {
    HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    result = {};
    prepare(scratch);
    load_tile<FromTile, RG>(work.gathered, block, scratch.gather_tile.data());
    const HomeBlock* next = next_in_column(*work.store, index);
    Report<Real> report;
    report.totals_wanted = totals;
    std::optional<Expelling> expelling;
    const double near = 2 * static_cast<double>(work.step.dx);
    if (work.contacts->holds_temperature_near(block.at, near)) report.holding = work.contacts;
    if (work.contacts->expels_near(block.at, near)) {
      expelling.emplace(*work.contacts, work.given ? work.given + static_cast<std::size_t>(index) * work.givers : nullptr);
      report.obstacles = &*expelling;
    }
    const int corner[3] = {4 * block.at.x, 4 * block.at.y, 4 * block.at.z};
    for (int d = 0; d < 3; ++d) {
      report.origin[d] = work.origin[d] + work.step.dx * Real(corner[d]);
      if (work.open_low[d]) report.open_low[d] = lanes<Real>(work.low_face[d] - Real(corner[d]));
      if (work.open_high[d]) report.open_high[d] = lanes<Real>(work.high_face[d] - Real(corner[d]));
    }
    alignas(64) V gathered[4 * RG], scattered[4 * RS] = {};
    Touched touched;
    for (int t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
      const auto at = static_cast<std::size_t>(t);
      const int count = work.store->tiles[at].count;
      if (next) prefetch_part(work, *next, t - block.first_tile, block.tiles);
      report.alive = k_lane_numbers < lanes<Real>(static_cast<Real>(count)) ? lanes<Real>(1) : V{};
      V* columns = work.store->tile(at);
      const int lines = work.store->columns;
      const auto prefetch_next_tile = [&](int p) {  // a few lines at a time: all at once they wait for each other
        for (int c = lines * p / W; c < lines * (p + 1) / W; ++c) __builtin_prefetch(columns + lines + c, 1);
      };
      V x[3];
      load_position(columns, x);
      FromTile::particles(scratch.gather_tile.data(), S(x), 1 / work.step.dx, gathered, prefetch_next_tile);
      V sampled[9];  // Physics::sampled() at most
      work.physics->advance(columns, work.store->tiles[at].material, gathered, RG, scattered, RS, work.sampled ? sampled : nullptr,
                            work.step, report);
      if (work.sampled) keep_sample(work, columns, count, sampled);

      load_position(columns, x);
      const LaneMask<Real> gone = report.leaving(x);
      if (block.at_face) hold_inside(work, corner, x, columns, count, result);
      const S stencil(x);
      const LaneMask<Real> broken = not_finite(columns, work.physics->column_count);
      const LaneMask<Real> outside = stencil.outside() | gone | broken;
      touched.add(stencil, outside);
      alignas(64) Real rows[W * ToTile::k_particle];
      ToTile::coefficients_to_rows(stencil, scattered, work.physics->moment_channels, rows);
      ToTile::particles(stencil, rows, outside, count, scratch.scatter_tile.data());
      if (__builtin_expect(any(outside), 0))
        for (int l = 0; l < count; ++l)
          if (outside[l])
            result.migrants.push_back({index, t, l, gone[l] != 0, broken[l] != 0,
                                       std::vector<Real>(rows + l * ToTile::k_particle, rows + (l + 1) * ToTile::k_particle)});
    }
    touched.write(block);
    flush_tile<RS>(work.scattered, block, scratch.scatter_tile.data());
    collect(report, result);
  }

  void to_rows(const Physics<Real>& physics, const V (&x)[3], V* scattered, Real* rows) const override {
    ToTile::coefficients_to_rows(S(x), scattered, physics.moment_channels, rows);
  }

  void scatter_rows(const BlockWork<Real>& work, int index, const Real (&x)[3], const Real* rows) const override {
    const HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    const V lanes_x[3] = {lanes<Real>(x[0]), lanes<Real>(x[1]), lanes<Real>(x[2])};
    const S s(lanes_x);
    constexpr int slopes = ToTile::k_slopes;
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k)
        for (int l = 0; l < N; ++l) {
          const int at[3] = {static_cast<int>(s.base[0][0]) + j, static_cast<int>(s.base[1][0]) + k, static_cast<int>(s.base[2][0]) + l};
          const Real w = s.weight[0][j][0] * s.weight[1][k][0] * s.weight[2][l][0];
          Real* node = work.scattered + grid_row(block, at[0], at[1], at[2]) * RS;
          const Real *x_slopes = rows + RS, *y_slopes = x_slopes + slopes, *z_slopes = y_slopes + slopes;
          for (int c = 0; c < slopes; ++c)
            node[c] += w * (rows[c] + Real(j - 1) * x_slopes[c] + Real(k - 1) * y_slopes[c] + Real(l - 1) * z_slopes[c]);
          for (int c = slopes; c < RS; ++c) node[c] += w * rows[c];
        }
  }

  void push(const BlockWork<Real>& work, int index, int tile, const V (&impulse)[3]) const override {
    const HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    V x[3];
    load_position(work.store->tile(static_cast<std::size_t>(tile)), x);
    const S s(x);
    const LaneMask<Real> outside = s.outside();
    for (int p = 0; p < work.store->tiles[static_cast<std::size_t>(tile)].count; ++p) {
      if (outside[p]) continue;  // no step leaves a particle like this
      // as grid_row, each axis for itself
      int block_part[3][N], node_part[3][N];
      for (int d = 0; d < 3; ++d)
        for (int j = 0; j < N; ++j) {
          const int at = static_cast<int>(s.base[d][p]) + j + 4;
          block_part[d][j] = (at >> 2) * (d == 0 ? 9 : d == 1 ? 3 : 1);
          node_part[d][j] = (at & 3) * (d == 0 ? 16 : d == 1 ? 4 : 1);
        }
      using R = Row<Real, 4>;
      alignas(64) const Real numbers[4] = {impulse[0][p], impulse[1][p], impulse[2][p], 0};
      const R change = R::load(numbers);
      for (int j = 0; j < N; ++j)
        for (int k = 0; k < N; ++k) {
          const Real w_jk = s.weight[0][j][p] * s.weight[1][k][p];
          for (int l = 0; l < N; ++l) {
            const auto slot = static_cast<std::size_t>(block.neighbour[block_part[0][j] + block_part[1][k] + block_part[2][l]]);
            const auto node = static_cast<std::size_t>(node_part[0][j] + node_part[1][k] + node_part[2][l]);
            Real* row = work.scattered + (slot * k_block_nodes + node) * RS;
            R sum = R::load(row);
            sum.add(change, w_jk * s.weight[2][l][p]);
            sum.store(row);
          }
        }
    }
  }

  void take_nodes(Real* rows, V* channels) const override {
    rows_to_lanes<RS>(rows, channels);
    for (int l = 0; l < W; ++l) Row<Real, RS>::zero().store(rows + l * RS);
  }
  void put_nodes(const V* channels, Real* rows) const override { lanes_to_rows<RG>(channels, rows); }

 private:
  static void prepare(Scratch<Real>& scratch) {
    if (scratch.gather_tile.size() < k_tile_nodes * FromTile::k_row) scratch.gather_tile.resize_and_forget(k_tile_nodes * FromTile::k_row);
    if (scratch.scatter_tile.size() < k_tile_nodes * RS) scratch.scatter_tile.resize_and_forget(k_tile_nodes * RS);
  }

  static void keep_sample(const BlockWork<Real>& work, const V* columns, int count, const V* sampled) {
    const auto numbers = static_cast<std::size_t>(work.physics->sampled());
    for (int l = 0; l < count; ++l)
      for (std::size_t i = 0; i < numbers; ++i)
        work.sampled[static_cast<std::size_t>(identity_of<Real>(columns, l)) * numbers + i] = sampled[i][l];
  }

  BAKE_INLINE static void load_position(const V* columns, V (&x)[3]) {
    for (int d = 0; d < 3; ++d) x[d] = columns[k_position_column + d];
  }

  /// The home block two steps up the column (+z), which comes next as it touches no node of this one; null if no particles live there.
  static const HomeBlock* next_in_column(const ParticleStore<Real>& store, int index) {
    const BlockIndex at = store.blocks[static_cast<std::size_t>(index)].at;
    for (std::size_t next = static_cast<std::size_t>(index) + 1; next <= static_cast<std::size_t>(index) + 2 && next < store.blocks.size();
         ++next)
      if (store.blocks[next].at == BlockIndex{at.x, at.y, at.z + 2}) return &store.blocks[next];
    return nullptr;
  }

  /// Asks for a part of the grid rows that the next block will read and add to, while there is other work.
  /// Inlined by force: GCC takes a function that only prefetches for one without effect, and drops its calls.
  BAKE_INLINE static void prefetch_part(const BlockWork<Real>& work, const HomeBlock& next, int part, int parts) {
    for (int x = k_tile_side * part / parts; x < k_tile_side * (part + 1) / parts; ++x) {
      if (x < next.low[0] || x > next.high[0]) continue;
      for (int y = next.low[1]; y <= next.high[1]; ++y)
        for (const int z : {0, 2, 4}) {
          const std::size_t row = grid_row(next, x - 1, y - 1, z);
          prefetch_rows(work.scattered + row * RS, 2 * RS);
          prefetch_rows(work.gathered + row * RG, 2 * RG);
        }
    }
  }

  /// Lanes with a number in their state that is not finite. Several sums, since one would wait for itself.
  BAKE_INLINE static LaneMask<Real> not_finite(const V* columns, int count) {
    static_assert(k_position_column == 0 && k_identity_column == 3);
    V health[4] = {columns[0] * 0, columns[1] * 0, columns[2] * 0, V{}};
    int c = 4;
    for (; c + 4 <= count; c += 4)
      for (int i = 0; i < 4; ++i) health[i] += columns[c + i] * 0;
    for (; c < count; ++c) health[0] += columns[c] * 0;
    return (health[0] + health[1]) + (health[2] + health[3]) != V{};
  }

  /// The part of the tile that particles touched.
  struct Touched {
    V low[3], high[3];
    Touched() {
      for (int d = 0; d < 3; ++d) {
        low[d] = lanes<Real>(Kernel<order>::highest_base);
        high[d] = lanes<Real>(Kernel<order>::lowest_base);
      }
    }
    BAKE_INLINE void add(const S& stencil, LaneMask<Real> outside) {
      for (int d = 0; d < 3; ++d) {
        low[d] = min(low[d], outside ? low[d] : stencil.base[d]);
        high[d] = max(high[d], outside ? high[d] : stencil.base[d]);
      }
    }
    void write(HomeBlock& block) const {
      for (int d = 0; d < 3; ++d) {
        const int first = static_cast<int>(smallest_lane(low[d])) + 1, last = static_cast<int>(largest_lane(high[d])) + N;
        block.low[d] = static_cast<std::int8_t>(first);
        block.high[d] = static_cast<std::int8_t>(last);
      }
    }
  };

  /// Particles never leave the domain unseen: at a closed face they are held and counted, at an open one they retire.
  static void hold_inside(const BlockWork<Real>& work, const int (&corner)[3], V (&x)[3], V* columns, int count,
                          BlockResult<Real>& result) {
    for (int d = 0; d < 3; ++d) {
      const V low = lanes<Real>(work.low_face[d] - Real(corner[d])), high = lanes<Real>(work.high_face[d] - Real(corner[d]));
      const LaneMask<Real> below = x[d]<low, above = x[d]> high;
      for (int l = 0; l < count; ++l) result.clamped += (below[l] && !work.open_low[d]) || (above[l] && !work.open_high[d]);
      x[d] = below ? low : above ? high : x[d];
      columns[k_position_column + d] = x[d];
    }
  }
};

}  // namespace bake

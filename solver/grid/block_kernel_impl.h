// SPDX-License-Identifier: MIT
// How one block's transfers are done fast.
//
// A block's 8x8x8 nodes (-1..6 of the block) are copied into a tile in the first-level cache, particles are taken W at a
// time, and what they scatter is summed in a second tile that is added to the grid at the end. Particles may drift one
// node distance out of their block and still find their stencil in the tile.
//
// Gather, one particle at a time, register = one node row: sums along z, then y, then x carry the value and the three
// derivatives together. The result is transposed so that the physics sees lanes of particles.
// Scatter, one particle at a time: with a' the value at the reference node and B the coefficients of the node offsets, node
// (j, k, l) receives w_j w_k w_l (a' + j B_x + k B_y + l B_z).
#pragma once

#include <algorithm>
#include <cstring>

#include "solver/grid/block_kernel.h"
#include "solver/grid/kernel.h"

namespace bake {

/// R numbers in registers: one of R, or several of the machine's own width.
template <class Real, int R>
struct Row {
  static constexpr int k_chunk = R < k_width<Real> ? R : k_width<Real>;
  static constexpr int k_chunks = R / k_chunk;
  typedef Real Chunk __attribute__((vector_size(k_chunk * sizeof(Real)), may_alias));
  Chunk at[k_chunks];

  BAKE_INLINE static Row load(const Real* p) {
    Row r;
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) r.at[c] = reinterpret_cast<const Chunk*>(p)[c];
    return r;
  }
  BAKE_INLINE void store(Real* p) const {
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) reinterpret_cast<Chunk*>(p)[c] = at[c];
  }
  BAKE_INLINE static Row zero() {
    Row r;
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) r.at[c] = Chunk{};
    return r;
  }
  /// *this += a * s
  BAKE_INLINE void add(const Row& a, Real s) {
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) at[c] += a.at[c] * s;
  }
  BAKE_INLINE Row operator*(Real s) const {
    Row r;
#pragma GCC unroll 8
    for (int c = 0; c < k_chunks; ++c) r.at[c] = at[c] * s;
    return r;
  }
};

template <class Real, KernelOrder order, int RS, int RG>
class BlockKernelOf final : public BlockKernel<Real> {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>;
  static constexpr int N = Kernel<order>::support;

  /// 0, 1, 2, ...
  static inline const V k_lane_numbers = [] {
    V v{};
    for (int l = 0; l < W; ++l) v[l] = static_cast<Real>(l);
    return v;
  }();

  /// Stencil of W particles in memory, lane by lane.
  struct Weights {
    alignas(64) Real w[3][N][W];
    alignas(64) Real g[3][N][W];       ///< D^-1 w r: the gradient [1/m]
    alignas(64) std::int32_t node[W];  ///< where the first node's row starts in the tile

    /// `row`: numbers per row of the tile.
    BAKE_INLINE Weights(const S& s, Real per_dx, int row) {
      const Real scale = Kernel<order>::inverse_d * per_dx;
      for (int d = 0; d < 3; ++d)
        for (int j = 0; j < N; ++j) {
          *reinterpret_cast<V*>(w[d][j]) = s.weight[d][j];
          *reinterpret_cast<V*>(g[d][j]) = s.weight[d][j] * (Real(j - 1) - s.offset[d]) * scale;
        }
      const V first = (((s.base[0] + 1) * Real(k_tile_side) + (s.base[1] + 1)) * Real(k_tile_side) + (s.base[2] + 1)) * Real(row);
      const auto whole = __builtin_convertvector(first, LaneMask<Real>);
      for (int l = 0; l < W; ++l) node[l] = static_cast<std::int32_t>(whole[l]);
    }
  };

 public:
  int row_size() const override { return RS; }

  void advance(const BlockWork<Real>& work, int index, Scratch<Real>& scratch, BlockResult<Real>& result, bool totals) const override {
    HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    prepare(scratch);
    prefetch_ahead(work, index);
    load_tile(work.gathered, block, scratch.gather_tile.data());
    Report<Real> report;
    report.totals_wanted = totals;
    if (work.contacts->expels_near(block.at, 2 * static_cast<double>(work.step.dx))) report.obstacles = work.contacts;
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
      report.alive = k_lane_numbers < lanes<Real>(static_cast<Real>(count)) ? lanes<Real>(1) : V{};
      V* columns = work.store->tile(at);
      for (int c = 0; c < work.store->columns; ++c) __builtin_prefetch(columns + work.store->columns + c, 1);
      V x[3];
      load_position(columns, x);
      Weights weights(S(x), 1 / work.step.dx, RG);
      gather(scratch.gather_tile.data(), weights, gathered);
      V* velocity = work.velocity ? reinterpret_cast<V*>(work.velocity) + at * 3 : nullptr;
      work.physics->advance(columns, work.store->tiles[at].material, gathered, RG, scattered, RS, velocity, work.step, report);

      load_position(columns, x);
      const LaneMask<Real> gone = report.leaving(x);
      if (block.at_face) hold_inside(work, corner, x, columns, count, result);
      const S stencil(x);
      const LaneMask<Real> broken = not_finite(columns, work.physics->column_count);
      const LaneMask<Real> outside = stencil.outside() | gone | broken;
      touched.add(stencil, outside);
      alignas(64) Real rows[W * 4 * RS];
      coefficients_to_rows(stencil, scattered, work.physics->moment_channels, rows);
      weights = Weights(stencil, 1, RS);
      scatter(weights, rows, outside, count, scratch.scatter_tile.data());
      if (__builtin_expect(any(outside), 0))
        for (int l = 0; l < count; ++l)
          if (outside[l])
            result.escapes.push_back(
                {index, t, l, gone[l] != 0, broken[l] != 0, std::vector<Real>(rows + l * 4 * RS, rows + (l + 1) * 4 * RS)});
    }
    touched.write(block);
    flush(work.scattered, block, scratch.scatter_tile.data());
    collect(report, result);
  }

  void to_rows(const Physics<Real>& physics, const V (&x)[3], V* scattered, Real* rows) const override {
    coefficients_to_rows(S(x), scattered, physics.moment_channels, rows);
  }

  void scatter_rows(const BlockWork<Real>& work, int index, const Real (&x)[3], const Real* rows) const override {
    const HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    const V lanes_x[3] = {lanes<Real>(x[0]), lanes<Real>(x[1]), lanes<Real>(x[2])};
    const S s(lanes_x);
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k)
        for (int l = 0; l < N; ++l) {
          const int at[3] = {static_cast<int>(s.base[0][0]) + j, static_cast<int>(s.base[1][0]) + k, static_cast<int>(s.base[2][0]) + l};
          const Real w = s.weight[0][j][0] * s.weight[1][k][0] * s.weight[2][l][0];
          Real* node = work.scattered + grid_row(block, at[0], at[1], at[2]) * RS;
          for (int c = 0; c < RS; ++c)
            node[c] += w * (rows[c] + Real(j - 1) * rows[RS + c] + Real(k - 1) * rows[2 * RS + c] + Real(l - 1) * rows[3 * RS + c]);
        }
  }

  void conduct(const BlockWork<Real>& work, int index, Scratch<Real>& scratch) const override {
    HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    prepare(scratch);
    load_tile(work.gathered, block, scratch.gather_tile.data());
    for (int t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
      const auto at = static_cast<std::size_t>(t);
      V x[3];
      load_position(work.store->tile(at), x);
      const S stencil(x);
      Weights weights(stencil, 1 / work.step.dx, RG);
      alignas(64) V gathered[4 * RG], scattered[4 * RS] = {};
      gather(scratch.gather_tile.data(), weights, gathered);
      const V kappa_V = work.physics->conductance(work.store->tile(at), work.store->tiles[at].material);
      for (int axis = 0; axis < 3; ++axis)
        scattered[(1 + axis) * RS] = kappa_V * (work.step.inverse_d * work.step.dx) * gathered[(1 + axis) * RG];
      alignas(64) Real rows[W * 4 * RS];
      coefficients_to_rows(stencil, scattered, 1, rows);
      weights = Weights(stencil, 1, RS);
      scatter(weights, rows, LaneMask<Real>{}, work.store->tiles[at].count, scratch.scatter_tile.data());
    }
    flush(work.scattered, block, scratch.scatter_tile.data());
  }

 private:
  static void prepare(Scratch<Real>& scratch) {
    if (scratch.gather_tile.size() < k_tile_nodes * RG) scratch.gather_tile.resize_and_forget(k_tile_nodes * RG);
    if (scratch.scatter_tile.size() < k_tile_nodes * RS) scratch.scatter_tile.resize_and_forget(k_tile_nodes * RS);
  }

  BAKE_INLINE static void load_position(const V* columns, V (&x)[3]) {
    for (int d = 0; d < 3; ++d) x[d] = columns[k_position_column + d];
  }

  /// Row number of a block's node, coordinates -4..7 around the block.
  static std::size_t grid_row(const HomeBlock& block, int x, int y, int z) {
    x += 4, y += 4, z += 4;
    const int slot = block.neighbour[(x >> 2) * 9 + (y >> 2) * 3 + (z >> 2)];
    return static_cast<std::size_t>(slot) * k_block_nodes + node_in_block(x & 3, y & 3, z & 3);
  }

  /// Calls visit(tile row, grid row, count) for runs of nodes along z in the touched range of a block.
  template <class Visit>
  BAKE_INLINE static void for_each_run(const HomeBlock& block, Visit visit) {
    for (int x = block.low[0]; x <= block.high[0]; ++x)
      for (int y = block.low[1]; y <= block.high[1]; ++y) {
        const std::size_t tile_row = static_cast<std::size_t>((x * k_tile_side + y) * k_tile_side);
        const auto grid = [&](int z) { return grid_row(block, x - 1, y - 1, z - 1); };
        if (block.low[2] == 0) visit(tile_row, grid(0), 1);
        visit(tile_row + 1, grid(1), 4);
        visit(tile_row + 5, grid(5), block.high[2] - 4);
      }
  }

  /// Asks for the grid rows that this block will add to, and those that the next one will read, while there is other work. Only
  /// the block above (+z) is asked for: the others were touched by the block before in the column.
  /// Inlined by force: GCC takes a function that only prefetches for one without effect, and drops its calls.
  BAKE_INLINE static void prefetch_ahead(const BlockWork<Real>& work, int index) {
    const auto ask = [](const HomeBlock& block, const Real* grid, auto write) __attribute__((always_inline)) {
      constexpr int k_line = 64 / static_cast<int>(sizeof(Real));
      for (int x = block.low[0]; x <= block.high[0]; ++x)
        for (int y = block.low[1]; y <= block.high[1]; ++y) {
          const Real* first = grid + grid_row(block, x - 1, y - 1, 4) * RS;
          for (int i = 0; i < 2 * RS; i += k_line) __builtin_prefetch(first + i, decltype(write)::value, 2);
        }
    };
    const auto& blocks = work.store->blocks;
    ask(blocks[static_cast<std::size_t>(index)], work.scattered, std::true_type{});
    if (index + 1 < static_cast<int>(blocks.size())) ask(blocks[static_cast<std::size_t>(index) + 1], work.gathered, std::false_type{});
  }

  static void load_tile(const Real* grid, const HomeBlock& block, Real* tile) {
    for_each_run(block, [&](std::size_t tile_row, std::size_t grid_row, int count) {
      for (int i = 0; i < count; ++i) Row<Real, RG>::load(grid + (grid_row + i) * RS).store(tile + (tile_row + i) * RG);
    });
  }

  /// Adds the tile to the grid and clears it.
  static void flush(Real* grid, const HomeBlock& block, Real* tile) {
    using R = Row<Real, RS>;
    for_each_run(block, [&](std::size_t tile_row, std::size_t grid_row, int count) {
      for (int i = 0; i < count; ++i) {
        R sum = R::load(grid + (grid_row + i) * RS);
        sum.add(R::load(tile + (tile_row + i) * RS), 1);
        sum.store(grid + (grid_row + i) * RS);
        R::zero().store(tile + (tile_row + i) * RS);
      }
    });
  }

  /// Values and gradients of W particles, as lanes: values, d/dx, d/dy, d/dz, RG lanes each.
  BAKE_INLINE static void gather(const Real* tile, const Weights& weights, V* gathered) {
    alignas(64) Real rows[W][4 * RG];
    for (int p = 0; p < W; ++p) {
      if constexpr (2 * RG <= W)
        gather_paired(tile + weights.node[p], weights, p, rows[p]);
      else
        gather_row(tile + weights.node[p], weights, p, rows[p]);
    }
    for (int c = 0; c < 4 * RG; c += W) {
      V square[W];
      for (int p = 0; p < W; ++p) square[p] = *reinterpret_cast<const V*>(&rows[p][c]);
      transpose(square);
      for (int l = 0; l < W; ++l) gathered[c + l] = square[l];
    }
  }

  BAKE_INLINE static void gather_row(const Real* first, const Weights& weights, int p, Real* out) {
    using R = Row<Real, RG>;
    R value = R::zero(), gx = value, gy = value, gz = value;
#pragma GCC unroll 4
    for (int j = 0; j < N; ++j) {
      R value_j = R::zero(), gy_j = value_j, gz_j = value_j;
#pragma GCC unroll 4
      for (int k = 0; k < N; ++k) {
        const Real* node = first + (j * k_tile_side + k) * k_tile_side * RG;
        R a = R::zero(), g = a;
#pragma GCC unroll 4
        for (int l = 0; l < N; ++l) {
          const R n = R::load(node + l * RG);
          a.add(n, weights.w[2][l][p]);
          g.add(n, weights.g[2][l][p]);
        }
        value_j.add(a, weights.w[1][k][p]);
        gy_j.add(a, weights.g[1][k][p]);
        gz_j.add(g, weights.w[1][k][p]);
      }
      value.add(value_j, weights.w[0][j][p]);
      gx.add(value_j, weights.g[0][j][p]);
      gy.add(gy_j, weights.w[0][j][p]);
      gz.add(gz_j, weights.w[0][j][p]);
    }
    value.store(out);
    gx.store(out + RG);
    gy.store(out + 2 * RG);
    gz.store(out + 3 * RG);
  }

  /// The same where a register holds two rows: its halves carry the value and the derivative along z, so that one
  /// multiply-add serves both (54 instead of 93 for a quadratic stencil).
  BAKE_INLINE static void gather_paired(const Real* first, const Weights& weights, int p, Real* out) {
    using R = Row<Real, RG>;
    using P = Row<Real, 2 * RG>;
    P wz[N];
#pragma GCC unroll 4
    for (int l = 0; l < N; ++l) wz[l] = halves<P>(weights.w[2][l][p], weights.g[2][l][p], std::make_integer_sequence<int, 2 * RG>{});
    P value = P::zero(), gx = value, gy = value;  // upper half of value: d/dz; upper halves of the others are not used
#pragma GCC unroll 4
    for (int j = 0; j < N; ++j) {
      P value_j = P::zero(), gy_j = value_j;
#pragma GCC unroll 4
      for (int k = 0; k < N; ++k) {
        const Real* node = first + (j * k_tile_side + k) * k_tile_side * RG;
        P a = P::zero();
#pragma GCC unroll 4
        for (int l = 0; l < N; ++l) a.at[0] += twice<P>(R::load(node + l * RG)).at[0] * wz[l].at[0];
        value_j.add(a, weights.w[1][k][p]);
        gy_j.add(a, weights.g[1][k][p]);
      }
      value.add(value_j, weights.w[0][j][p]);
      gx.add(value_j, weights.g[0][j][p]);
      gy.add(gy_j, weights.w[0][j][p]);
    }
    lower(value).store(out);
    lower(gx).store(out + RG);
    lower(gy).store(out + 2 * RG);
    upper(value).store(out + 3 * RG);
  }

  template <int... I>
  using Indices = std::integer_sequence<int, I...>;
  template <class P, int... I>
  BAKE_INLINE static P twice(const Row<Real, RG>& r, Indices<I...>) {
    return {{__builtin_shufflevector(r.at[0], r.at[0], I % RG...)}};
  }
  template <class P>
  BAKE_INLINE static P twice(const Row<Real, RG>& r) {
    return twice<P>(r, std::make_integer_sequence<int, 2 * RG>{});
  }
  /// `low` in the lower half, `high` in the upper.
  template <class P, int... I>
  BAKE_INLINE static P halves(Real low, Real high, Indices<I...>) {
    const typename P::Chunk a = low - typename P::Chunk{}, b = high - typename P::Chunk{};
    return {{__builtin_shufflevector(a, b, (I < RG ? I : 2 * RG + I)...)}};
  }
  template <int first, int... I>
  BAKE_INLINE static Row<Real, RG> half(const Row<Real, 2 * RG>& p, Indices<I...>) {
    return {{__builtin_shufflevector(p.at[0], p.at[0], (first + I)...)}};
  }
  BAKE_INLINE static Row<Real, RG> lower(const Row<Real, 2 * RG>& p) { return half<0>(p, std::make_integer_sequence<int, RG>{}); }
  BAKE_INLINE static Row<Real, RG> upper(const Row<Real, 2 * RG>& p) { return half<RG>(p, std::make_integer_sequence<int, RG>{}); }

  /// From lanes of coefficients about the particles to one set of four rows per particle, about the reference node.
  BAKE_INLINE static void coefficients_to_rows(const S& s, V* coefficients, int moments, Real* rows) {
    for (int c = 0; c < moments; ++c)
      for (int axis = 0; axis < 3; ++axis) coefficients[c] -= coefficients[(1 + axis) * RS + c] * s.offset[axis];
    for (int c = 0; c < 4 * RS; c += W) {
      V square[W];
      for (int l = 0; l < W; ++l) square[l] = coefficients[c + l];
      transpose(square);
      for (int p = 0; p < W; ++p) *reinterpret_cast<V*>(rows + p * 4 * RS + c) = square[p];
    }
  }

  /// Adds the particles below `count` that are not `outside` to the tile. Neighbours in one cell (particles are sorted by cell)
  /// share one pass over their nodes: half the loads and stores.
  BAKE_INLINE static void scatter(const Weights& weights, const Real* rows, LaneMask<Real> outside, int count, Real* tile) {
    for (int p = 0; p < count; ++p) {
      if (outside[p]) continue;
      if (p + 1 < count && !outside[p + 1] && weights.node[p + 1] == weights.node[p]) {
        scatter_together<2>(weights, rows, p, tile);
        ++p;
      } else {
        scatter_together<1>(weights, rows, p, tile);
      }
    }
  }

  /// Particles p to p + many - 1, all of one cell.
  template <int many>
  BAKE_INLINE static void scatter_together(const Weights& weights, const Real* rows, int p, Real* tile) {
    using R = Row<Real, RS>;
    Real* first = tile + weights.node[p];
    const Real* mine = rows + p * 4 * RS;
#pragma GCC unroll 4
    for (int j = 0; j < N; ++j) {
#pragma GCC unroll 4
      for (int k = 0; k < N; ++k) {
        R value[many], slope[many];
#pragma GCC unroll 2
        for (int m = 0; m < many; ++m) {
          const Real* row = mine + m * 4 * RS;
          const Real w = weights.w[0][j][p + m] * weights.w[1][k][p + m];
          value[m] = R::load(row);
          value[m].add(R::load(row + RS), Real(j - 1));
          value[m].add(R::load(row + 2 * RS), Real(k - 1));
          value[m] = value[m] * w;
          slope[m] = R::load(row + 3 * RS) * w;
        }
        Real* node = first + (j * k_tile_side + k) * k_tile_side * RS;
#pragma GCC unroll 4
        for (int l = 0; l < N; ++l) {
          R sum = R::load(node + l * RS);
#pragma GCC unroll 2
          for (int m = 0; m < many; ++m) {
            const Real wl = weights.w[2][l][p + m];
            sum.add(value[m], wl);
            if (l != 1) sum.add(slope[m], wl * Real(l - 1));
          }
          sum.store(node + l * RS);
        }
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
        block.low[d] = static_cast<std::int8_t>(std::min(first, 1));
        block.high[d] = static_cast<std::int8_t>(std::max(last, 5));
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

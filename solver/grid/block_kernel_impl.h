// SPDX-License-Identifier: MIT
// How one block's transfers are done fast.
//
// A block's 8x8x8 nodes (-1..6 of the block) are copied into a tile in the first-level cache, particles are taken W at a
// time, and what they scatter is summed in a second tile that is added to the grid at the end. Particles may drift one
// node distance out of their block and still find their stencil in the tile.
//
// Gather, one particle at a time, register = one node row: sums along z, then y, then x carry the value and its three moments
// together. The result is transposed so that the physics sees lanes of particles.
// Scatter, one particle at a time: with a' the value at the reference node and B the coefficients of the node offsets, node
// (j, k, l) receives w_j w_k w_l (a' + j B_x + k B_y + l B_z). Particles of a cell follow each other, and its sums wait in registers.
//
// A core makes two multiply-adds, two sums, two loads and one store a cycle: products are shared, sums replace multiply-adds, and
// stores are few.
#pragma once

#include <algorithm>
#include <cstring>

#include "solver/core/rows.h"
#include "solver/grid/block_kernel.h"
#include "solver/grid/kernel.h"

namespace bake {

template <class Real, KernelOrder order, int RS, int RG>
class BlockKernelOf final : public BlockKernel<Real> {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>;
  static constexpr int N = Kernel<order>::support;
  /// Where a register holds two gathered rows, the tile keeps each row twice, side by side: a multiply-add then serves the value with
  /// its lower half and the derivative along z with its upper.
  static constexpr bool k_twins = Row<Real, 2 * RG>::k_chunks == 1;
  static constexpr int k_gather_row = k_twins ? 2 * RG : RG;  ///< numbers per node in the gather's tile

  /// 0, 1, 2, ...
  static inline const V k_lane_numbers = [] {
    V v{};
    for (int l = 0; l < W; ++l) v[l] = static_cast<Real>(l);
    return v;
  }();

  /// Where in a tile with `row` numbers per node the first nodes' rows of W stencils start.
  BAKE_INLINE static void first_nodes(const S& s, int row, std::int32_t* node) {
    const V first = ((s.base[0] + 1) * Real(k_tile_plane) + (s.base[1] + 1) * Real(k_tile_side) + (s.base[2] + 1)) * Real(row);
    const auto whole = __builtin_convertvector(first, LaneMask<Real>);
    for (int l = 0; l < W; ++l) node[l] = static_cast<std::int32_t>(whole[l]);
  }

  /// Weights of W particles per axis, in memory, lane by lane.
  struct AxisWeights {
    alignas(64) Real w[3][N][W];
    alignas(64) Real z_moment[N][W];  ///< (l - 1) w_l along z
    alignas(64) std::int32_t node[W];

    BAKE_INLINE explicit AxisWeights(const S& s) {
      for (int d = 0; d < 3; ++d)
        for (int j = 0; j < N; ++j) *reinterpret_cast<V*>(w[d][j]) = s.weight[d][j];
      for (int l = 0; l < N; ++l) *reinterpret_cast<V*>(z_moment[l]) = Real(l - 1) * s.weight[2][l];
      first_nodes(s, k_gather_row, node);
    }
  };

  /// Weights of W particles per node of the stencil.
  struct NodeWeights {
    alignas(64) Real w[N][N][N][W];
    alignas(64) std::int32_t node[W];

    BAKE_INLINE explicit NodeWeights(const S& s) {
      for (int j = 0; j < N; ++j)
        for (int k = 0; k < N; ++k) {
          const V w_jk = s.weight[0][j] * s.weight[1][k];
          for (int l = 0; l < N; ++l) *reinterpret_cast<V*>(w[j][k][l]) = w_jk * s.weight[2][l];
        }
      first_nodes(s, RS, node);
    }
  };

 public:
  int scattered_row() const override { return RS; }
  int gathered_row() const override { return RG; }

  void advance(const BlockWork<Real>& work, int index, Scratch<Real>& scratch, BlockResult<Real>& result, bool totals) const override {
    HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    result = {};
    prepare(scratch);
    load_tile(work.gathered, block, scratch.gather_tile.data());
    const HomeBlock* above = block_above(*work.store, index);
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
      if (above) prefetch_part(work, *above, t - block.first_tile, block.tiles);
      report.alive = k_lane_numbers < lanes<Real>(static_cast<Real>(count)) ? lanes<Real>(1) : V{};
      V* columns = work.store->tile(at);
      for (int c = 0; c < work.store->columns; ++c) __builtin_prefetch(columns + work.store->columns + c, 1);
      V x[3];
      load_position(columns, x);
      gather(scratch.gather_tile.data(), S(x), 1 / work.step.dx, gathered);
      V* velocity = work.velocity ? reinterpret_cast<V*>(work.velocity) + at * 3 : nullptr;
      work.physics->advance(columns, work.store->tiles[at].material, gathered, RG, scattered, RS, velocity, work.step, report);

      load_position(columns, x);
      const LaneMask<Real> gone = report.leaving(x);
      if (block.at_face) hold_inside(work, corner, x, columns, count, result);
      const S stencil(x);
      const LaneMask<Real> broken = not_finite(columns, work.physics->column_count);
      const LaneMask<Real> outside = stencil.outside() | gone | broken;
      touched.add(stencil, outside);
      const NodeWeights weights(stencil);
      alignas(64) Real rows[W * 4 * RS];
      coefficients_to_rows(stencil, scattered, work.physics->moment_channels, rows);
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

  void take_nodes(Real* rows, V* channels) const override {
    rows_to_lanes<RS>(rows, channels);
    for (int l = 0; l < W; ++l) Row<Real, RS>::zero().store(rows + l * RS);
  }
  void put_nodes(const V* channels, Real* rows) const override { lanes_to_rows<RG>(channels, rows); }

  void conduct(const BlockWork<Real>& work, int index, Scratch<Real>& scratch) const override {
    HomeBlock& block = work.store->blocks[static_cast<std::size_t>(index)];
    prepare(scratch);
    load_tile(work.gathered, block, scratch.gather_tile.data());
    for (int t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
      const auto at = static_cast<std::size_t>(t);
      V x[3];
      load_position(work.store->tile(at), x);
      const S stencil(x);
      alignas(64) V gathered[4 * RG], scattered[4 * RS] = {};
      gather(scratch.gather_tile.data(), stencil, 1 / work.step.dx, gathered);
      const V kappa_V = work.physics->conductance(work.store->tile(at), work.store->tiles[at].material);
      for (int axis = 0; axis < 3; ++axis)
        scattered[(1 + axis) * RS] = kappa_V * (work.step.inverse_d * work.step.dx) * gathered[(1 + axis) * RG];
      alignas(64) Real rows[W * 4 * RS];
      coefficients_to_rows(stencil, scattered, 1, rows);
      scatter(NodeWeights(stencil), rows, LaneMask<Real>{}, work.store->tiles[at].count, scratch.scatter_tile.data());
    }
    flush(work.scattered, block, scratch.scatter_tile.data());
  }

 private:
  static void prepare(Scratch<Real>& scratch) {
    if (scratch.gather_tile.size() < k_tile_nodes * k_gather_row) scratch.gather_tile.resize_and_forget(k_tile_nodes * k_gather_row);
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
        const std::size_t tile_row = static_cast<std::size_t>(x * k_tile_plane + y * k_tile_side);
        const auto grid = [&](int z) { return grid_row(block, x - 1, y - 1, z - 1); };
        if (block.low[2] == 0) visit(tile_row, grid(0), 1);
        visit(tile_row + 1, grid(1), 4);
        visit(tile_row + 5, grid(5), block.high[2] - 4);
      }
  }

  /// The home block one step up the column (+z), if particles live there.
  static const HomeBlock* block_above(const ParticleStore<Real>& store, int index) {
    const auto next = static_cast<std::size_t>(index) + 1;
    if (next >= store.blocks.size()) return nullptr;
    const BlockIndex &at = store.blocks[next - 1].at, &other = store.blocks[next].at;
    return other == BlockIndex{at.x, at.y, at.z + 1} ? &store.blocks[next] : nullptr;
  }

  /// Asks for a part of the grid rows that the block above will read and add to, while there is other work: those of the upper half of
  /// its nodes and beyond, since this block has touched the others.
  /// Inlined by force: GCC takes a function that only prefetches for one without effect, and drops its calls.
  BAKE_INLINE static void prefetch_part(const BlockWork<Real>& work, const HomeBlock& above, int part, int parts) {
    constexpr int k_line = 64 / static_cast<int>(sizeof(Real));
    for (int x = k_tile_side * part / parts; x < k_tile_side * (part + 1) / parts; ++x) {
      if (x < above.low[0] || x > above.high[0]) continue;
      for (int y = above.low[1]; y <= above.high[1]; ++y)
        for (const int z : {2, 4}) {
          const std::size_t row = grid_row(above, x - 1, y - 1, z);
          for (int i = 0; i < 2 * RS; i += k_line) __builtin_prefetch(work.scattered + row * RS + i, 1, 3);
          for (int i = 0; i < 2 * RG; i += k_line) __builtin_prefetch(work.gathered + row * RG + i, 0, 3);
        }
    }
  }

  static void load_tile(const Real* grid, const HomeBlock& block, Real* tile) {
    for_each_run(block, [&](std::size_t tile_row, std::size_t grid_row, int count) {
      for (int i = 0; i < count; ++i) {
        const auto row = Row<Real, RG>::load(grid + (grid_row + i) * RG);
        for (int twin = 0; twin < k_gather_row; twin += RG) row.store(tile + (tile_row + i) * k_gather_row + twin);
      }
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
  /// The nodes give sum w n and sum w o n with their whole offsets o; the gradient is D^-1 (sum w o n - f sum w n).
  BAKE_INLINE static void gather(const Real* tile, const S& stencil, Real per_dx, V* gathered) {
    const AxisWeights weights(stencil);
    alignas(64) Real rows[W][4 * RG];
    for (int p = 0; p < W; ++p) gather_one(tile + weights.node[p], weights, p, rows[p]);
    rows_to_lanes<4 * RG>(rows[0], gathered);
    const Real scale = Kernel<order>::inverse_d * per_dx;
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < RG; ++c) {
        V& slope = gathered[(1 + axis) * RG + c];
        slope = scale * (slope - stencil.offset[axis] * gathered[c]);
      }
  }

  template <class R>
  struct Moments {
    R value, moment;
  };
  /// sum w_i a_i and sum (i - 1) w_i a_i: products are shared, sums leave the multipliers to others.
  template <class R>
  BAKE_INLINE static Moments<R> moments(const R (&a)[N], const Real (*w)[W], int p) {
    const R first = a[0] * w[0][p], third = a[2] * w[2][p];
    Moments<R> sums{first.plus(1, third), third.plus(-1, first)};
    if constexpr (N == 4) {
      const R last = a[3] * w[3][p];
      sums = {sums.value.plus(1, last), sums.moment.plus(2, last)};
    }
    sums.value.add(a[1], w[1][p]);
    return sums;
  }

  /// One particle's sums, from its first node on: values, then moments along x, y and z. A line of nodes along z becomes a double row,
  /// its value in the lower half and its moment in the upper, so that the sums along y and x serve both.
  BAKE_INLINE static void gather_one(const Real* first, const AxisWeights& weights, int p, Real* out) {
    using R = Row<Real, RG>;
    using P = Row<Real, 2 * RG>;
    P lines[N], lines_y[N], along_z[N];
    if constexpr (k_twins)
#pragma GCC unroll 4
      for (int l = 0; l < N; ++l) along_z[l] = halves(weights.w[2][l][p], weights.z_moment[l][p]);
#pragma GCC unroll 4
    for (int j = 0; j < N; ++j) {
      P line[N];
#pragma GCC unroll 4
      for (int k = 0; k < N; ++k) {
        const Real* node = first + (j * k_tile_plane + k * k_tile_side) * k_gather_row;
        if constexpr (k_twins) {
          line[k] = P::zero();
#pragma GCC unroll 4
          for (int l = 0; l < N; ++l) line[k].at[0] += P::load(node + l * 2 * RG).at[0] * along_z[l].at[0];
        } else {
          R row[N];
#pragma GCC unroll 4
          for (int l = 0; l < N; ++l) row[l] = R::load(node + l * RG);
          const auto sums = moments(row, weights.w[2], p);
          line[k] = joined(sums.value, sums.moment);
        }
      }
      const auto along_y = moments(line, weights.w[1], p);
      lines[j] = along_y.value;
      lines_y[j] = along_y.moment;
    }
    const auto along_x = moments(lines, weights.w[0], p);
    P y = lines_y[0] * weights.w[0][0][p];
#pragma GCC unroll 4
    for (int j = 1; j < N; ++j) y.add(lines_y[j], weights.w[0][j][p]);
    lower(along_x.value).store(out);
    lower(along_x.moment).store(out + RG);
    lower(y).store(out + 2 * RG);
    upper(along_x.value).store(out + 3 * RG);
  }

  template <int... I>
  using Indices = std::integer_sequence<int, I...>;
  /// `low` in the lower half, `high` in the upper.
  template <int... I>
  BAKE_INLINE static Row<Real, 2 * RG> halves(Real low, Real high, Indices<I...>) {
    typedef typename Row<Real, 2 * RG>::Chunk Chunk;
    const Chunk a = low - Chunk{}, b = high - Chunk{};
    return {{__builtin_shufflevector(a, b, (I < RG ? I : 2 * RG + I)...)}};
  }
  BAKE_INLINE static Row<Real, 2 * RG> halves(Real low, Real high) { return halves(low, high, std::make_integer_sequence<int, 2 * RG>{}); }
  BAKE_INLINE static Row<Real, 2 * RG> joined(const Row<Real, RG>& low, const Row<Real, RG>& high) {
    Row<Real, 2 * RG> both;
#pragma GCC unroll 8
    for (int c = 0; c < low.k_chunks; ++c) both.at[c] = low.at[c], both.at[low.k_chunks + c] = high.at[c];
    return both;
  }
  template <int first, int... I>
  BAKE_INLINE static Row<Real, RG> half(const Row<Real, 2 * RG>& p, Indices<I...>) {
    if constexpr (Row<Real, 2 * RG>::k_chunks == 1) {
      return {{__builtin_shufflevector(p.at[0], p.at[0], (first + I)...)}};
    } else {
      Row<Real, RG> r;
#pragma GCC unroll 8
      for (int c = 0; c < r.k_chunks; ++c) r.at[c] = p.at[first / r.k_chunk + c];
      return r;
    }
  }
  BAKE_INLINE static Row<Real, RG> lower(const Row<Real, 2 * RG>& p) { return half<0>(p, std::make_integer_sequence<int, RG>{}); }
  BAKE_INLINE static Row<Real, RG> upper(const Row<Real, 2 * RG>& p) { return half<RG>(p, std::make_integer_sequence<int, RG>{}); }

  /// From lanes of coefficients about the particles to one set of four rows per particle, about the reference node.
  BAKE_INLINE static void coefficients_to_rows(const S& s, V* coefficients, int moments, Real* rows) {
    for (int c = 0; c < moments; ++c)
      for (int axis = 0; axis < 3; ++axis) coefficients[c] -= coefficients[(1 + axis) * RS + c] * s.offset[axis];
    lanes_to_rows<RS>(coefficients, rows, 4 * RS);
    for (int axis = 1; axis < 4; ++axis) {
      V slopes[RS];
      for (int c = 0; c < RS; ++c) slopes[c] = c < k_most_moments ? coefficients[axis * RS + c] : V{};  // which leaves out shuffles
      lanes_to_rows<RS>(slopes, rows + axis * RS, 4 * RS);
    }
  }

  /// Adds the particles below `count` that are not `outside` to the tile. Neighbours are often of one cell (particles are sorted): the
  /// sums of a cell's nodes stay in registers until another cell's particle comes, for stores are what the scatter has most of.
  BAKE_INLINE static void scatter(const NodeWeights& weights, const Real* rows, LaneMask<Real> outside, int count, Real* tile) {
    constexpr int k_sums = k_register_bytes == 64 ? 27 : 9;  // registers for them
    constexpr int k_line = N * Row<Real, RS>::k_chunks;
    constexpr int J = N * N * k_line <= k_sums ? N : 1, K = N * k_line <= k_sums ? N : 1;
    int begin = 0;
    while (begin < count) {
      if (outside[begin]) {
        ++begin;
        continue;
      }
      int end = count;
      if (__builtin_expect(any(outside), 0))
        for (end = begin + 1; end < count && !outside[end];) ++end;
      scatter_all_lines<J, K>(weights, rows, begin, end, tile, std::make_integer_sequence<int, (N / J) * (N / K)>{});
      begin = end;
    }
  }
  template <int J, int K, int... I>
  BAKE_INLINE static void scatter_all_lines(const NodeWeights& weights, const Real* rows, int begin, int end, Real* tile, Indices<I...>) {
    (scatter_lines<I / (N / K) * J, J, I % (N / K) * K, K>(weights, rows, begin, end, tile), ...);
  }
  /// Of the stencils' lines of nodes along z, those j_0 to j_0 + J - 1 in x, k_0 to k_0 + K - 1 in y.
  template <int j_0, int J, int k_0, int K>
  BAKE_INLINE static void scatter_lines(const NodeWeights& weights, const Real* rows, int begin, int end, Real* tile) {
    using R = Row<Real, RS>;
    R sum[J][K][N];
    const auto for_each_node = [&](Real * first, auto visit) __attribute__((always_inline)) {
#pragma GCC unroll 4
      for (int j = 0; j < J; ++j)
#pragma GCC unroll 4
        for (int k = 0; k < K; ++k)
#pragma GCC unroll 4
          for (int l = 0; l < N; ++l) visit(sum[j][k][l], first + ((j_0 + j) * k_tile_plane + (k_0 + k) * k_tile_side + l) * RS);
    };
    Real* nodes = tile + weights.node[begin];
    for_each_node(
        nodes, [](R & s, const Real* node) __attribute__((always_inline)) { s = R::load(node); });
    for (int p = begin;; ++p) {
      const Real* mine = rows + p * 4 * RS;
#pragma GCC unroll 4
      for (int j = 0; j < J; ++j) {
        const R at_j = R::load(mine).plus(j_0 + j - 1, R::load(mine + RS));
#pragma GCC unroll 4
        for (int k = 0; k < K; ++k) {
          const R at_jk = at_j.plus(k_0 + k - 1, R::load(mine + 2 * RS));
#pragma GCC unroll 4
          for (int l = 0; l < N; ++l) sum[j][k][l].add(at_jk.plus(l - 1, R::load(mine + 3 * RS)), weights.w[j_0 + j][k_0 + k][l][p]);
        }
      }
      const bool last = p + 1 == end;
      if (!last && weights.node[p + 1] == weights.node[p]) continue;
      for_each_node(
          nodes, [](const R& s, Real* node) __attribute__((always_inline)) { s.store(node); });
      if (last) break;
      nodes = tile + weights.node[p + 1];
      for_each_node(
          nodes, [](R & s, const Real* node) __attribute__((always_inline)) { s = R::load(node); });
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

// SPDX-License-Identifier: MIT
// The scatter (particles to grid, P2G): from particles to a tile's nodes, one particle at a time. Node (j, k, l) receives
// w_j w_k w_l (a' + j B_x + k B_y + l B_z), where a' is the value at the reference node and B holds the coefficients of the node offsets.
#pragma once

#include <algorithm>

#include "solver/core/rows.h"
#include "solver/grid/tile.h"

namespace bake {

/// The widest rows that are compiled: how many numbers they have, and how many of these may have coefficients of the node offsets.
inline constexpr int k_most_channels = 32, k_most_moments = 8;

/// Rows of RS numbers. A particle has one of values, and one of slopes for each axis: as many numbers as there can be moments, or fill a
/// register.
template <class Real, KernelOrder order, int RS>
class Scatter {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>;
  static constexpr int N = Kernel<order>::support;

 public:
  static constexpr int k_slopes = std::min(RS, std::max(k_most_moments, W));
  static constexpr int k_particle = RS + 3 * k_slopes;  ///< numbers of a particle

  /// Turns lanes of coefficients about the particles, four rows with RS lanes each, into rows of W particles about the reference node.
  BAKE_INLINE static void coefficients_to_rows(const S& s, V* coefficients, int moments, Real* rows) {
    for (int c = 0; c < moments; ++c)
      for (int axis = 0; axis < 3; ++axis) coefficients[c] -= coefficients[(1 + axis) * RS + c] * s.offset[axis];
    lanes_to_rows<RS>(coefficients, rows, k_particle);
    for (int axis = 0; axis < 3; ++axis) {
      V slopes[k_slopes];
      for (int c = 0; c < k_slopes; ++c) slopes[c] = c < k_most_moments ? coefficients[(1 + axis) * RS + c] : V{};  // spares shuffles
      lanes_to_rows<k_slopes>(slopes, rows + RS + axis * k_slopes, k_particle);
    }
  }

  /// Adds the particles below `count` that are not `outside` to the tile. Particles are sorted, so neighbours often share a cell.
  BAKE_INLINE static void particles(const S& stencil, const Real* rows, LaneMask<Real> outside, int count, Real* tile) {
    const NodeWeights weights(stencil);
    int begin = 0;
    while (begin < count) {
      if (outside[begin]) {
        ++begin;
        continue;
      }
      int end = count;
      if (__builtin_expect(any(outside), 0))
        for (end = begin + 1; end < count && !outside[end];) ++end;
      if (k_lines_y > 1 || weights.share_a_cell(begin, end))
        by_cells(weights, rows, begin, end, tile, std::make_integer_sequence<int, (N / k_lines_x) * (N / k_lines_y)>{});
      else
        for (int p = begin; p < end; ++p) one_by_one(weights, rows, p, tile + weights.node[p]);
      begin = end;
    }
  }

 private:
  /// The weights of W particles for each node of the stencil.
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
    /// Are the particles from begin to end, at least one, in one cell?
    BAKE_INLINE bool share_a_cell(int begin, int end) const {
      int others = 0;
      for (int p = begin + 1; p < end; ++p) others |= node[p] ^ node[begin];
      return others == 0;
    }
  };

  /// Calls visit(j, k, l, what particle p gives to that node) for the lines of nodes along z from j_0 to j_0 + J - 1 in x and from k_0 to
  /// k_0 + K - 1 in y.
  template <int j_0, int J, int k_0, int K, class Visit>
  BAKE_INLINE static void for_each_node(const Real* rows, int p, Visit visit) {
    using R = Row<Real, RS>;
    using Slopes = Row<Real, k_slopes>;
    const Real *mine = rows + p * k_particle, *slopes = mine + RS;
#pragma GCC unroll 4
    for (int j = j_0; j < j_0 + J; ++j) {
      const R at_j = R::load(mine).plus(j - 1, Slopes::load(slopes));
#pragma GCC unroll 4
      for (int k = k_0; k < k_0 + K; ++k) {
        const R at_jk = at_j.plus(k - 1, Slopes::load(slopes + k_slopes));
#pragma GCC unroll 4
        for (int l = 0; l < N; ++l) visit(j, k, l, at_jk.plus(l - 1, Slopes::load(slopes + 2 * k_slopes)));
      }
    }
  }
  static constexpr int k_sums = k_register_bytes == 64 ? 27 : 9;  ///< as many as the registers hold
  static constexpr int k_line = N * Row<Real, RS>::k_chunks;      ///< those of a line
  static constexpr int k_lines_x = N * N * k_line <= k_sums ? N : 1, k_lines_y = N * k_line <= k_sums ? N : 1;
  static constexpr int from_first(int j, int k, int l) { return (j * k_tile_plane + k * k_tile_side + l) * RS; }

  /// Where the registers hold the sums of a single line, particles that change cells go one by one: their stores cost less than wrong
  /// guesses, line by line, of where the next cell begins (gather and scatter of a cookie that bakes, 16 registers of 8: 0.85 of the time).
  BAKE_INLINE static void one_by_one(const NodeWeights& weights, const Real* rows, int p, Real* nodes) {
    using R = Row<Real, RS>;
    for_each_node<0, N, 0, N>(
        rows, p, [&](int j, int k, int l, const R& given) __attribute__((always_inline)) {
          Real* node = nodes + from_first(j, k, l);
          R sum = R::load(node);
          sum.add(given, weights.w[j][k][l][p]);
          sum.store(node);
        });
  }

  /// The sums of a cell's nodes, of as many lines as the registers hold, stay there until a particle of another cell comes. This saves
  /// stores, which limit the scatter.
  template <int... I>
  BAKE_INLINE static void by_cells(const NodeWeights& weights, const Real* rows, int begin, int end, Real* tile,
                                   std::integer_sequence<int, I...>) {
    constexpr int J = k_lines_x, K = k_lines_y;
    (lines<I / (N / K) * J, J, I % (N / K) * K, K>(weights, rows, begin, end, tile), ...);
  }
  template <int j_0, int J, int k_0, int K>
  BAKE_INLINE static void lines(const NodeWeights& weights, const Real* rows, int begin, int end, Real* tile) {
    using R = Row<Real, RS>;
    R sum[J][K][N];
    const auto for_each_sum = [&](Real * nodes, auto visit) __attribute__((always_inline)) {
#pragma GCC unroll 4
      for (int j = 0; j < J; ++j)
#pragma GCC unroll 4
        for (int k = 0; k < K; ++k)
#pragma GCC unroll 4
          for (int l = 0; l < N; ++l) visit(sum[j][k][l], nodes + from_first(j_0 + j, k_0 + k, l));
    };
    const auto load = [](R & s, const Real* node) __attribute__((always_inline)) { s = R::load(node); };
    const auto store = [](const R& s, Real* node) __attribute__((always_inline)) { s.store(node); };
    Real* nodes = tile + weights.node[begin];
    for_each_sum(nodes, load);
    for (int p = begin;; ++p) {
      for_each_node<j_0, J, k_0, K>(
          rows, p, [&](int j, int k, int l, const R& given) __attribute__((always_inline)) {
            sum[j - j_0][k - k_0][l].add(given, weights.w[j][k][l][p]);
          });
      const bool last = p + 1 == end;
      if (!last && weights.node[p + 1] == weights.node[p]) continue;
      for_each_sum(nodes, store);
      if (last) break;
      nodes = tile + weights.node[p + 1];
      for_each_sum(nodes, load);
    }
  }
};

}  // namespace bake

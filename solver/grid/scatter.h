// SPDX-License-Identifier: MIT
// The scatter (particles to grid, P2G): from particles to a tile's nodes, one particle at a time. Node (j, k, l) receives
// w_j w_k w_l (a' + j B_x + k B_y + l B_z), where a' is the value at the reference node and B holds the coefficients of the node offsets.
#pragma once

#include "solver/core/rows.h"
#include "solver/grid/tile.h"

namespace bake {

/// The widest rows that are compiled: how many numbers they have, and how many of these may have coefficients of the node offsets.
inline constexpr int k_most_channels = 32, k_most_moments = 8;

/// Rows of RS numbers.
template <class Real, KernelOrder order, int RS>
class Scatter {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>;
  static constexpr int N = Kernel<order>::support;

 public:
  /// Turns lanes of coefficients about the particles into one set of four rows per particle, about the reference node.
  BAKE_INLINE static void coefficients_to_rows(const S& s, V* coefficients, int moments, Real* rows) {
    for (int c = 0; c < moments; ++c)
      for (int axis = 0; axis < 3; ++axis) coefficients[c] -= coefficients[(1 + axis) * RS + c] * s.offset[axis];
    lanes_to_rows<RS>(coefficients, rows, 4 * RS);
    for (int axis = 1; axis < 4; ++axis) {
      V slopes[RS];
      for (int c = 0; c < RS; ++c) slopes[c] = c < k_most_moments ? coefficients[axis * RS + c] : V{};  // spares shuffles
      lanes_to_rows<RS>(slopes, rows + axis * RS, 4 * RS);
    }
  }

  /// Adds the particles below `count` that are not `outside` to the tile. Particles are sorted, so neighbours often share a cell: the sums
  /// of a cell's nodes stay in registers until a particle of another cell comes. This saves stores, which limit the scatter.
  BAKE_INLINE static void particles(const S& stencil, const Real* rows, LaneMask<Real> outside, int count, Real* tile) {
    const NodeWeights weights(stencil);
    constexpr int k_sums = k_register_bytes == 64 ? 27 : 9;  // as many as the registers hold
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
      all_lines<J, K>(weights, rows, begin, end, tile, std::make_integer_sequence<int, (N / J) * (N / K)>{});
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
  };

  template <int J, int K, int... I>
  BAKE_INLINE static void all_lines(const NodeWeights& weights, const Real* rows, int begin, int end, Real* tile,
                                    std::integer_sequence<int, I...>) {
    (lines<I / (N / K) * J, J, I % (N / K) * K, K>(weights, rows, begin, end, tile), ...);
  }
  /// Scatters to a part of the stencil: its lines of nodes along z from j_0 to j_0 + J - 1 in x and from k_0 to k_0 + K - 1 in y.
  template <int j_0, int J, int k_0, int K>
  BAKE_INLINE static void lines(const NodeWeights& weights, const Real* rows, int begin, int end, Real* tile) {
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
};

}  // namespace bake

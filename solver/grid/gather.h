// SPDX-License-Identifier: MIT
// The gather (grid to particles, G2P): from a tile's nodes to particles, one particle at a time. A register holds one node's row. Sums
// along z, then y, then x carry the value and its three moments together. The result is transposed, so that the physics sees lanes of
// particles.
#pragma once

#include "solver/core/rows.h"
#include "solver/grid/tile.h"

namespace bake {

/// Rows of RG numbers.
template <class Real, KernelOrder order, int RG>
class Gather {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>;
  static constexpr int N = Kernel<order>::support;
  /// Where a register holds two rows, the tile keeps each row twice, side by side. The lower half of a multiply-add then computes the
  /// value, the upper half the derivative along z.
  static constexpr bool k_twins = RowPair<Real, RG>::k_chunks == 1;

 public:
  static constexpr int k_row = k_twins ? 2 * RG : RG;  ///< numbers per node in the tile

  /// Copies one node's row from the grid into the tile.
  BAKE_INLINE static void load(const Real* grid, Real* tile) {
    const auto row = Row<Real, RG>::load(grid);
    for (int twin = 0; twin < k_row; twin += RG) row.store(tile + twin);
  }

  /// Values and gradients of W particles, as lanes: values, d/dx, d/dy, d/dz, RG lanes each.
  /// The nodes give sum w n and sum w o n with their whole offsets o; the gradient is D^-1 (sum w o n - f sum w n).
  /// `meanwhile(p)` is called after each particle p, to prefetch.
  template <class Meanwhile>
  BAKE_INLINE static void particles(const Real* tile, const S& stencil, Real per_dx, V* gathered, Meanwhile meanwhile) {
    const AxisWeights weights(stencil);
    alignas(64) Real rows[W][4 * RG];
    for (int p = 0; p < W; ++p) {
      one_particle(tile + weights.node[p], weights, p, rows[p]);
      meanwhile(p);
    }
    rows_to_lanes<4 * RG>(rows[0], gathered);
    const Real scale = Kernel<order>::inverse_d * per_dx;
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < RG; ++c) {
        V& slope = gathered[(1 + axis) * RG + c];
        slope = scale * (slope - stencil.offset[axis] * gathered[c]);
      }
  }

 private:
  /// The weights of W particles for each axis, stored lane by lane.
  struct AxisWeights {
    alignas(64) Real w[3][N][W];
    alignas(64) Real z_moment[N][W];  ///< (l - 1) w_l along z
    alignas(64) std::int32_t node[W];

    BAKE_INLINE explicit AxisWeights(const S& s) {
      for (int d = 0; d < 3; ++d)
        for (int j = 0; j < N; ++j) *reinterpret_cast<V*>(w[d][j]) = s.weight[d][j];
      for (int l = 0; l < N; ++l) *reinterpret_cast<V*>(z_moment[l]) = Real(l - 1) * s.weight[2][l];
      first_nodes(s, k_row, node);
    }
  };

  template <class R>
  struct Moments {
    R value, moment;
  };
  /// sum w_i a_i and sum (i - 1) w_i a_i: products are shared, and sums leave the multipliers free.
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

  /// The sums of one particle, from its first node on: values, then moments along x, y and z. A line of nodes along z becomes a double row,
  /// its value in the lower half and its moment in the upper, so that the sums along y and x serve both.
  BAKE_INLINE static void one_particle(const Real* first, const AxisWeights& weights, int p, Real* out) {
    using R = Row<Real, RG>;
    using P = RowPair<Real, RG>;
    P lines[N], lines_y[N], along_z[N];
    if constexpr (k_twins)
#pragma GCC unroll 4
      for (int l = 0; l < N; ++l) along_z[l] = halves<RG>(weights.w[2][l][p], weights.z_moment[l][p]);
#pragma GCC unroll 4
    for (int j = 0; j < N; ++j) {
      P line[N];
#pragma GCC unroll 4
      for (int k = 0; k < N; ++k) {
        const Real* node = first + (j * k_tile_plane + k * k_tile_side) * k_row;
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
    lower<RG>(along_x.value).store(out);
    lower<RG>(along_x.moment).store(out + RG);
    lower<RG>(y).store(out + 2 * RG);
    upper<RG>(along_x.value).store(out + 3 * RG);
  }
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// Conduction as an operator on nodal temperatures, K theta = sum_p V kappa G_p G_p^T theta with the gradient G_p = D^-1 w r of a particle,
// without a matrix. A node is one number here, so a line of nodes along z fills a register; what particles share of their stencils is
// computed for W of them at a time.
#pragma once

#include <cstring>

#include "solver/core/rows.h"
#include "solver/engine/block_tile.h"
#include "solver/engine/physics.h"

namespace bake {

/// The conduction of W particles of one home block.
template <class Real, KernelOrder order>
class Conducting {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  static constexpr int W = k_width<Real>, N = Kernel<order>::support;
  /// Four nodes along z, wherever they begin.
  typedef Real Line __attribute__((vector_size(4 * sizeof(Real)), aligned(sizeof(Real)), may_alias));

 public:
  /// The tile's nodes, and room for a line that begins at the last ones.
  struct Tile {
    alignas(64) Real node[k_tile_nodes + 4] = {};
  };

  explicit Conducting(const S& s) {
    V along_z[2][4] = {};
    for (int l = 0; l < N; ++l) {
      for (int d = 0; d < 3; ++d) {
        weight_[d][l] = s.weight[d][l];
        moment_[d][l] = s.weight[d][l] * (Real(l - 1) - s.offset[d]);
      }
      along_z[0][l] = weight_[2][l];
      along_z[1][l] = moment_[2][l];
    }
    lanes_to_rows<4>(along_z[0], weights_z_[0], 4);
    lanes_to_rows<4>(along_z[1], moments_z_[0], 4);
    first_nodes(s, 1, first_);
  }

  /// sum_i w_i r_i theta_i, in node distances.
  void gather(const Tile& theta, int count, V (&gradient)[3]) const {
    alignas(64) Real rows[W][16] = {};  // lines along z of the sums over x and y
    for (int p = 0; p < count; ++p) {
      Line sum_x{}, sum_y{}, sum_z{};
#pragma GCC unroll 4
      for (int j = 0; j < N; ++j) {
        Line value{}, moment{};
#pragma GCC unroll 4
        for (int k = 0; k < N; ++k) {
          const Line nodes = *reinterpret_cast<const Line*>(theta.node + first_node(p, j, k));
          value += weight_[1][k][p] * nodes;
          moment += moment_[1][k][p] * nodes;
        }
        sum_x += moment_[0][j][p] * value;
        sum_y += weight_[0][j][p] * moment;
        sum_z += weight_[0][j][p] * value;
      }
      Line* row = reinterpret_cast<Line*>(rows[p]);
      row[0] = sum_x, row[1] = sum_y, row[2] = sum_z;
    }
    V columns[16];
    rows_to_lanes<16>(rows[0], columns);
    for (int d = 0; d < 3; ++d) {
      gradient[d] = V{};
      for (int l = 0; l < N; ++l) gradient[d] += (d == 2 ? moment_ : weight_)[2][l] * columns[4 * d + l];
    }
  }

  /// Adds w_i r_i . flux to the nodes.
  void scatter(const V (&flux)[3], int count, Tile& sum) const {
    V of_weight[N][N], of_moment[N][N];  // what multiplies w and w r along z
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k) {
        of_weight[j][k] = flux[0] * moment_[0][j] * weight_[1][k] + flux[1] * weight_[0][j] * moment_[1][k];
        of_moment[j][k] = flux[2] * weight_[0][j] * weight_[1][k];
      }
    for (int p = 0; p < count; ++p) {
      const Line w = *reinterpret_cast<const Line*>(weights_z_[p]), m = *reinterpret_cast<const Line*>(moments_z_[p]);
#pragma GCC unroll 4
      for (int j = 0; j < N; ++j)
#pragma GCC unroll 4
        for (int k = 0; k < N; ++k)
          *reinterpret_cast<Line*>(sum.node + first_node(p, j, k)) += of_weight[j][k][p] * w + of_moment[j][k][p] * m;
    }
  }

 private:
  BAKE_INLINE int first_node(int p, int j, int k) const { return first_[p] + j * k_tile_plane + k * k_tile_side; }

  V weight_[3][N], moment_[3][N];  ///< w, and w times the distance from the particle
  alignas(64) Real weights_z_[W][4], moments_z_[W][4];
  alignas(64) std::int32_t first_[W];
};

/// Adds K theta of the particles of home block `index` to `sum` [W]. `theta`, `sum`: one number per node of the grid.
template <class Real, KernelOrder order>
void conduct(const ParticleStore<Real>& store, const Physics<Real>& physics, Real dx, int index, const Real* theta, Real* sum) {
  const HomeBlock& block = store.blocks[static_cast<std::size_t>(index)];
  typename Conducting<Real, order>::Tile from, to;
  for_each_run(block, [&](std::size_t tile_row, std::size_t row, int count) {
    std::memcpy(from.node + tile_row, theta + row, static_cast<std::size_t>(count) * sizeof(Real));
  });
  const Real per_dx = Kernel<order>::inverse_d / dx;
  for (int t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
    const auto at = static_cast<std::size_t>(t);
    const int count = store.tiles[at].count;
    const Lanes<Real>* columns = store.tile(at);
    const Lanes<Real> x[3] = {columns[k_position_column], columns[k_position_column + 1], columns[k_position_column + 2]};
    const Conducting<Real, order> particles{Stencil<Real, order>(x)};
    Lanes<Real> flux[3];
    particles.gather(from, count, flux);
    for (auto& component : flux) component *= physics.conductance(columns, store.tiles[at].material) * (per_dx * per_dx);
    particles.scatter(flux, count, to);
  }
  for_each_run(block, [&](std::size_t tile_row, std::size_t row, int count) {
    for (int i = 0; i < count; ++i) sum[row + static_cast<std::size_t>(i)] += to.node[tile_row + static_cast<std::size_t>(i)];
  });
}

}  // namespace bake

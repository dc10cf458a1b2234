// SPDX-License-Identifier: MIT
// The free surface from its boundary particles, as printed.
#include <cmath>

#include "solver/core/vector3.h"
#include "solver/engine/surface.h"
#include "solver/grid/kernel.h"

namespace bake {

template <class Real>
template <KernelOrder order>
void FreeSurfaceMeasure<Real>::measure_published(const ParticleStore<Real>& store, const Real* rows, int row_size, int volume_channel,
                                                 int ratio_column, int volume_column, const ActiveBlocks& active,
                                                 const GridGeometry& geometry, const Contacts& contacts, const Air& air) {
  const std::size_t n = active.at.size();
  published_.assign(n, {});
  published_givers_.resize(n);
  const auto filled = [&](std::size_t slot, int node) {
    return rows[(slot * k_block_nodes + static_cast<std::size_t>(node)) * static_cast<std::size_t>(row_size) +
                static_cast<std::size_t>(volume_channel)] > 0;
  };
  // a node with mass and a neighbour without
  const auto at_boundary = [&](std::size_t slot, int node) {
    if (!filled(slot, node)) return false;
    const int at[3] = {node / 16, node / 4 % 4, node % 4};
    for (int d = 0; d < 3; ++d)
      for (const int step : {-1, 1}) {
        int near[3] = {at[0], at[1], at[2]}, block[3] = {1, 1, 1};
        near[d] += step;
        block[d] += near[d] < 0 ? -1 : near[d] > 3 ? 1 : 0;
        near[d] &= 3;
        const int toward = block[0] * 9 + block[1] * 3 + block[2];
        const std::int32_t neighbour = active.around[slot][static_cast<std::size_t>(toward)];
        if (neighbour < 0 || !filled(static_cast<std::size_t>(neighbour), node_in_block(near[0], near[1], near[2]))) return true;
      }
    return false;
  };
  struct Nearest {
    double distance2 = k_infinity;
    std::size_t tile = 0;
    int lane = 0;
  };
  std::vector<char> boundary(n * k_block_nodes);
  for (std::size_t i = 0; i < boundary.size(); ++i) boundary[i] = at_boundary(i / k_block_nodes, static_cast<int>(i % k_block_nodes));

  // visit(node number, weight, distance^2) for the nodes of a particle's stencil
  const auto for_each_node = [&](const HomeBlock& home, const Lanes<Real>* columns, int l, auto visit) {
    constexpr int N = Kernel<order>::support;
    const Lanes<Real> x[3] = {columns[k_position_column], columns[k_position_column + 1], columns[k_position_column + 2]};
    const Stencil<Real, order> stencil(x);
    for (int j = 0; j < N * N * N; ++j) {
      const int o[3] = {j / (N * N), j / N % N, j % N};
      double weight = 1, distance2 = 0;
      int at[3];
      for (int d = 0; d < 3; ++d) {
        const int node = static_cast<int>(stencil.base[d][l]) + o[d];
        weight *= static_cast<double>(stencil.weight[d][o[d]][l]);
        at[d] = node + 4;
        const double r = node - static_cast<double>(x[d][l]);  // NOLINT(clang-analyzer-core*): it does not follow lanes
        distance2 += r * r;
      }
      const std::int32_t slot = home.neighbour[(at[0] >> 2) * 9 + (at[1] >> 2) * 3 + (at[2] >> 2)];
      visit(static_cast<std::size_t>(slot) * k_block_nodes + static_cast<std::size_t>(node_in_block(at[0] & 3, at[1] & 3, at[2] & 3)),
            weight, distance2);
    }
  };
  const auto for_each_particle = [&](auto visit) {
    for (const HomeBlock& home : store.blocks)
      for (std::int32_t t = home.first_tile; t < home.first_tile + home.tiles; ++t)
        for (int l = 0; l < store.tiles[static_cast<std::size_t>(t)].count; ++l) visit(home, static_cast<std::size_t>(t), l);
  };
  std::vector<Nearest> nearest(n * k_block_nodes);
  for_each_particle([&](const HomeBlock& home, std::size_t t, int l) {
    for_each_node(home, store.tile(t), l, [&](std::size_t node, double, double distance2) {
      if (boundary[node] && distance2 < nearest[node].distance2) nearest[node] = {distance2, t, l};
    });
  });
  std::vector<char> chosen(store.tiles.size() * k_width<Real>);
  for (std::size_t node = 0; node < boundary.size(); ++node)
    if (boundary[node] && nearest[node].distance2 < k_infinity)
      chosen[nearest[node].tile * k_width<Real> + static_cast<std::size_t>(nearest[node].lane)] = 1;

  for_each_particle([&](const HomeBlock& home, std::size_t t, int l) {
    if (!chosen[t * k_width<Real> + static_cast<std::size_t>(l)]) return;
    const auto* columns = store.tile(t);
    const double V =
        static_cast<double>(columns[volume_column][l]) * (ratio_column < 0 ? 1 : static_cast<double>(columns[ratio_column][l]));
    const double S = std::cbrt(9 * M_PI / 16 * V * V);  // pi r^2 of the sphere of volume V
    for_each_node(home, columns, l, [&](std::size_t node, double weight, double) {
      published_[node / k_block_nodes].area[node % k_block_nodes] += static_cast<Real>(weight * S);
    });
  });
  for (std::size_t s = 0; s < n; ++s) {
    const bool near_contact = contacts.near(active.at[s], geometry.dx()) || contacts.cover_near(active.at[s], geometry.dx());
    BlockSurroundings<Real>& out = published_[s];
    for (int k = 0; k < k_block_nodes; ++k) {
      const Point x = node_position(geometry.origin(active.at[s]), geometry.dx(), k);
      const auto cover = near_contact && out.area[k] > 0 ? contacts.cover_within(x, geometry.dx()) : std::nullopt;
      const Real A = out.area[k];
      published_givers_[s][static_cast<std::size_t>(k)] = cover ? cover->giver : -1;
      if (cover) out.contact_area[k] = A, out.area[k] = 0;
      out.heat_transfer[k] = A * static_cast<Real>(cover ? cover->heat_transfer_coefficient : air.heat_transfer_coefficient);
      out.heat_transfer_source[k] = A * static_cast<Real>(cover ? cover->heat_transfer_coefficient * cover->temperature
                                                                : air.heat_transfer_coefficient * air.temperature);
      if (cover) out.heat_transfer_source[k] += A * static_cast<Real>(cover->flux);
    }
  }
}

#define BAKE_INSTANTIATE(Real, order)                                                                                           \
  template void FreeSurfaceMeasure<Real>::measure_published<order>(const ParticleStore<Real>&, const Real*, int, int, int, int, \
                                                                   const ActiveBlocks&, const GridGeometry&, const Contacts&, const Air&);
BAKE_INSTANTIATE(float, KernelOrder::quadratic)
BAKE_INSTANTIATE(float, KernelOrder::cubic)
BAKE_INSTANTIATE(double, KernelOrder::quadratic)
BAKE_INSTANTIATE(double, KernelOrder::cubic)
#undef BAKE_INSTANTIATE

}  // namespace bake

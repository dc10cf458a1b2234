// SPDX-License-Identifier: MIT
#include "solver/grid/surface.h"

#include <cmath>

#include "solver/boundary/vector3.h"
#include "solver/grid/kernel.h"

namespace bake {

namespace {

constexpr int k_halo = 6;  // a block and one node around it
template <class Real>
using Halo = Real[k_halo][k_halo][k_halo];

/// Copies the nodes of a block and those around it; zero where there is no block.
template <class Real, class FieldOf>
void load_halo(const std::array<std::int32_t, 27>& around, FieldOf field_of, Halo<Real>& out) {
  const auto nodes = [&](int column, int z) -> const Real* {
    const std::int32_t slot = around[static_cast<std::size_t>(column * 3 + z)];
    return slot < 0 ? nullptr : field_of(static_cast<std::size_t>(slot)).data();
  };
  for (int x = 0; x < k_halo; ++x)
    for (int y = 0; y < k_halo; ++y) {
      const int gx = x + 3, gy = y + 3;  // 4 is the block's first node
      const int column = (gx >> 2) * 3 + (gy >> 2), line = node_in_block(gx & 3, gy & 3, 0);
      const Real *below = nodes(column, 0), *mine = nodes(column, 1), *above = nodes(column, 2);
      Real* to = out[x][y];
      to[0] = below ? below[line + 3] : Real(0);
      for (int z = 0; z < 4; ++z) to[1 + z] = mine ? mine[line + z] : Real(0);
      to[5] = above ? above[line] : Real(0);
    }
}

/// (1, 2, 1)/4 along each axis, from a halo to the block's nodes.
template <class Real>
void blur(const Halo<Real>& in, std::array<Real, k_block_nodes>& out) {
  Real a[4][k_halo][k_halo], b[4][4][k_halo];
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < k_halo; ++y)
      for (int z = 0; z < k_halo; ++z) a[x][y][z] = Real(0.25) * (in[x][y][z] + 2 * in[x + 1][y][z] + in[x + 2][y][z]);
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < k_halo; ++z) b[x][y][z] = Real(0.25) * (a[x][y][z] + 2 * a[x][y + 1][z] + a[x][y + 2][z]);
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z)
        out[static_cast<std::size_t>(node_in_block(x, y, z))] = Real(0.25) * (b[x][y][z] + 2 * b[x][y][z + 1] + b[x][y][z + 2]);
}

/// Differences over two nodes along each axis, smoothed by (1, 6, 1)/8 along the other two.
template <class Real>
void gradients(const Halo<Real>& psi, Real (&out)[3][k_block_nodes]) {
  const auto smooth = [](Real a, Real b, Real c) { return Real(0.125) * (a + c) + Real(0.75) * b; };
  Real along_z[k_halo][k_halo][4], smooth_z[k_halo][k_halo][4];  // the difference along z, and the smoothed value
  for (int x = 0; x < k_halo; ++x)
    for (int y = 0; y < k_halo; ++y)
      for (int z = 0; z < 4; ++z) {
        along_z[x][y][z] = psi[x][y][z + 2] - psi[x][y][z];
        smooth_z[x][y][z] = smooth(psi[x][y][z], psi[x][y][z + 1], psi[x][y][z + 2]);
      }
  Real along_z_smooth_y[k_halo][4][4], smooth_zy[k_halo][4][4], along_y[k_halo][4][4];
  for (int x = 0; x < k_halo; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) {
        along_z_smooth_y[x][y][z] = smooth(along_z[x][y][z], along_z[x][y + 1][z], along_z[x][y + 2][z]);
        smooth_zy[x][y][z] = smooth(smooth_z[x][y][z], smooth_z[x][y + 1][z], smooth_z[x][y + 2][z]);
        along_y[x][y][z] = smooth_z[x][y + 2][z] - smooth_z[x][y][z];
      }
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) {
        const int k = node_in_block(x, y, z);
        out[0][k] = smooth_zy[x + 2][y][z] - smooth_zy[x][y][z];
        out[1][k] = smooth(along_y[x][y][z], along_y[x + 1][y][z], along_y[x + 2][y][z]);
        out[2][k] = smooth(along_z_smooth_y[x][y][z], along_z_smooth_y[x + 1][y][z], along_z_smooth_y[x + 2][y][z]);
      }
}

/// Node coordinates within the lattice.
struct NodeIndex {
  int at[3];
};

/// Faces of the domain are mirrors, not surfaces: the volume of the mirrored dough is added.
template <class Real, class VolumeAt>
Real mirrored(NodeIndex n, int axis, const Lattice& lattice, VolumeAt volume_at) {
  if (axis == 3) return volume_at(n);
  Real sum = mirrored<Real>(n, axis + 1, lattice, volume_at);
  const int i = n.at[axis];
  for (const int face : {static_cast<int>(lattice.low_face()), static_cast<int>(lattice.high_face(axis))})
    if (std::abs(i - face) <= k_mirrored) {
      n.at[axis] = 2 * face - i;
      sum += mirrored<Real>(n, axis + 1, lattice, volume_at);
      n.at[axis] = i;
    }
  return sum;
}

bool near_face(const BlockIndex& b, const Lattice& lattice) {
  const int first[3] = {4 * b.x, 4 * b.y, 4 * b.z};
  for (int d = 0; d < 3; ++d)
    if (first[d] <= lattice.low_face() + k_mirrored || first[d] + 3 >= lattice.high_face(d) - k_mirrored) return true;
  return false;
}

}  // namespace

template <class Real>
void FreeSurfaceMeasure<Real>::measure(const Real* rows, int row_size, int volume_channel, const ActiveBlocks& active,
                                       const Lattice& lattice, const Contacts& contacts, const Air& air) {
  const std::size_t n = active.at.size();
  volume_.resize(n);
  phi_.resize(n);
  smooth_.resize(n);
  density_.resize(n);
  surroundings_.resize(n);
  has_density_.assign(n, 0);
  has_surface_.assign(n, 0);
  full_.assign(n, 0);
  const double dx = lattice.dx();
  const Real per_cell = static_cast<Real>(1 / (dx * dx * dx));
  const auto blocks = static_cast<std::int64_t>(n);

#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    for (std::size_t k = 0; k < k_block_nodes; ++k)
      volume_[s][k] = rows[(s * k_block_nodes + k) * static_cast<std::size_t>(row_size) + static_cast<std::size_t>(volume_channel)];
  }

#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    if (!near_face(active.at[s], lattice)) {
      for (std::size_t k = 0; k < k_block_nodes; ++k) phi_[s][k] = per_cell * volume_[s][k];
      continue;
    }
    const BlockIndex b = active.at[s];
    const auto volume_at = [&](const NodeIndex& node) {
      const std::int32_t slot = active.slot_at({node.at[0] >> 2, node.at[1] >> 2, node.at[2] >> 2}, lattice);
      return slot < 0 ? Real(0)
                      : volume_[static_cast<std::size_t>(slot)]
                               [static_cast<std::size_t>(node_in_block(node.at[0] & 3, node.at[1] & 3, node.at[2] & 3))];
    };
    for (int k = 0; k < k_block_nodes; ++k)
      phi_[s][static_cast<std::size_t>(k)] =
          per_cell * mirrored<Real>({{4 * b.x + k / 16, 4 * b.y + k / 4 % 4, 4 * b.z + k % 4}}, 0, lattice, volume_at);
  }

#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    Halo<Real> halo;
    load_halo<Real>(
        active.around[s], [&](std::size_t slot) -> const Nodes& { return phi_[slot]; }, halo);
    blur(halo, smooth_[s]);
    bool full = true;
    for (const Real phi : smooth_[s]) full &= phi >= Real(0.8);
    full_[s] = full;
  }

#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    const BlockIndex b = active.at[s];
    bool inside = true;  // full all around: no gradient
    for (const std::int32_t slot : active.around[s]) inside &= slot >= 0 && full_[static_cast<std::size_t>(slot)];
    if (inside) continue;
    Halo<Real> psi;
    load_halo<Real>(
        active.around[s], [&](std::size_t slot) -> const Nodes& { return smooth_[slot]; }, psi);
    for (auto& plane : psi)
      for (auto& line : plane)
        for (Real& value : line) value = std::min(std::max((value - Real(0.2)) / Real(0.6), Real(0)), Real(1));
    const bool near_contact = contacts.near(b, 4 * dx);
    const Point origin = lattice.origin(b);
    auto& density = density_[s];
    for (auto& field : density) field.fill(0);
    Real gradient[3][k_block_nodes];
    gradients(psi, gradient);
    bool any = false;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z) {
          const auto k = static_cast<std::size_t>(node_in_block(x, y, z));
          if (smooth_[s][k] < Real(1e-3)) continue;
          const Real g[3] = {gradient[0][k], gradient[1][k], gradient[2][k]};
          const Real norm = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
          if (norm == 0) continue;
          any = true;
          const Real r = norm / static_cast<Real>(2 * dx) / smooth_[s][k];
          std::optional<ContactHeat> cover;
          if (near_contact)
            cover = contacts.covering(origin + dx * Vector3{double(x), double(y), double(z)},
                                      (-1 / static_cast<double>(norm)) * Vector3{double(g[0]), double(g[1]), double(g[2])}, 2.5 * dx);
          if (cover) {
            density[1][k] = r;
            density[2][k] = r * static_cast<Real>(cover->exchange);
            density[3][k] = r * static_cast<Real>(cover->exchange * cover->temperature);
          } else {
            density[0][k] = r;
          }
        }
    has_density_[s] = any;
  }

#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    bool any = false;
    for (const std::int32_t slot : active.around[s]) any |= slot >= 0 && has_density_[static_cast<std::size_t>(slot)];
    has_surface_[s] = any;
    if (!any) continue;
    static const Nodes none{};
    std::array<Nodes, 4> smoothed;
    for (std::size_t field = 0; field < 4; ++field) {
      Halo<Real> halo;
      load_halo<Real>(
          active.around[s], [&](std::size_t slot) -> const Nodes& { return has_density_[slot] ? density_[slot][field] : none; }, halo);
      blur(halo, smoothed[field]);
    }
    BlockSurroundings<Real>& out = surroundings_[s];
    for (std::size_t k = 0; k < k_block_nodes; ++k) {
      const Real V = volume_[s][k];
      out.area[k] = V * smoothed[0][k];
      out.contact_area[k] = V * smoothed[1][k];
      out.exchange[k] = V * (smoothed[0][k] * static_cast<Real>(air.exchange) + smoothed[2][k]);
      out.exchange_source[k] = V * (smoothed[0][k] * static_cast<Real>(air.exchange * air.temperature) + smoothed[3][k]);
    }
  }
}

template <class Real>
template <KernelOrder order>
void FreeSurfaceMeasure<Real>::measure_published(const ParticleStore<Real>& store, const Real* rows, int row_size, int volume_channel,
                                                 int ratio_column, int volume_column, const ActiveBlocks& active, const Lattice& lattice,
                                                 const Contacts& contacts, const Air& air) {
  const std::size_t n = active.at.size();
  surroundings_.assign(n, {});
  has_surface_.assign(n, 1);
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
        const std::int32_t neighbour = active.around[slot][static_cast<std::size_t>(block[0] * 9 + block[1] * 3 + block[2])];
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
        const double r = node - static_cast<double>(x[d][l]);
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
      surroundings_[node / k_block_nodes].area[node % k_block_nodes] += static_cast<Real>(weight * S);
    });
  });
  for (std::size_t s = 0; s < n; ++s) {
    const bool near_contact = contacts.near(active.at[s], lattice.dx());
    BlockSurroundings<Real>& out = surroundings_[s];
    for (int k = 0; k < k_block_nodes; ++k) {
      const Point x = lattice.origin(active.at[s]) + lattice.dx() * Vector3{double(k / 16), double(k / 4 % 4), double(k % 4)};
      const auto cover = near_contact && out.area[k] > 0 ? contacts.covering(x, std::nullopt, lattice.dx()) : std::nullopt;
      const Real A = out.area[k];
      if (cover) out.contact_area[k] = A, out.area[k] = 0;
      out.exchange[k] = A * static_cast<Real>(cover ? cover->exchange : air.exchange);
      out.exchange_source[k] = A * static_cast<Real>(cover ? cover->exchange * cover->temperature : air.exchange * air.temperature);
    }
  }
}

template class FreeSurfaceMeasure<float>;
template class FreeSurfaceMeasure<double>;
#define BAKE_INSTANTIATE(Real, order)                                                                                           \
  template void FreeSurfaceMeasure<Real>::measure_published<order>(const ParticleStore<Real>&, const Real*, int, int, int, int, \
                                                                   const ActiveBlocks&, const Lattice&, const Contacts&, const Air&);
BAKE_INSTANTIATE(float, KernelOrder::quadratic)
BAKE_INSTANTIATE(float, KernelOrder::cubic)
BAKE_INSTANTIATE(double, KernelOrder::quadratic)
BAKE_INSTANTIATE(double, KernelOrder::cubic)
#undef BAKE_INSTANTIATE

}  // namespace bake

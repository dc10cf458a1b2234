// SPDX-License-Identifier: MIT
#include "solver/grid/surface.h"

#include <cmath>

#include "solver/boundary/vector3.h"

namespace bake {

namespace {

constexpr int k_halo = 6;  // a block and one node around it
template <class Real>
using Halo = Real[k_halo][k_halo][k_halo];

/// Copies the nodes of a block and those around it; zero where there is no block.
template <class Real, class FieldOf>
void load_halo(const BlockIndex& b, const ActiveBlocks& active, const Lattice& lattice, FieldOf field_of, Halo<Real>& out) {
  std::int32_t slots[27];
  for (int i = 0; i < 27; ++i) slots[i] = active.near(b, i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1, lattice);
  for (int x = 0; x < k_halo; ++x)
    for (int y = 0; y < k_halo; ++y)
      for (int z = 0; z < k_halo; ++z) {
        const int gx = x + 3, gy = y + 3, gz = z + 3;  // 4 is the block's first node
        const std::int32_t slot = slots[(gx >> 2) * 9 + (gy >> 2) * 3 + (gz >> 2)];
        out[x][y][z] = slot < 0 ? Real(0) : field_of(static_cast<std::size_t>(slot))[static_cast<std::size_t>(node_in_block(gx & 3, gy & 3, gz & 3))];
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
    if (std::abs(i - face) <= 3) {
      n.at[axis] = 2 * face - i;
      sum += mirrored<Real>(n, axis + 1, lattice, volume_at);
      n.at[axis] = i;
    }
  return sum;
}

bool near_face(const BlockIndex& b, const Lattice& lattice) {
  const int first[3] = {4 * b.x, 4 * b.y, 4 * b.z};
  for (int d = 0; d < 3; ++d)
    if (first[d] <= lattice.low_face() + 3 || first[d] + 3 >= lattice.high_face(d) - 3) return true;
  return false;
}

}  // namespace

template <class Real>
void FreeSurfaceMeasure<Real>::measure(const Real* rows, int row_size, int volume_channel, const ActiveBlocks& active, const Lattice& lattice,
                                       const Contacts& contacts, const Air& air) {
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
      const BlockIndex home{node.at[0] >> 2, node.at[1] >> 2, node.at[2] >> 2};
      const std::int32_t slot = active.near(home, 0, 0, 0, lattice);
      return slot < 0 ? Real(0)
                      : volume_[static_cast<std::size_t>(slot)][static_cast<std::size_t>(node_in_block(node.at[0] & 3, node.at[1] & 3, node.at[2] & 3))];
    };
    for (int k = 0; k < k_block_nodes; ++k)
      phi_[s][static_cast<std::size_t>(k)] =
          per_cell * mirrored<Real>({{4 * b.x + k / 16, 4 * b.y + k / 4 % 4, 4 * b.z + k % 4}}, 0, lattice, volume_at);
  }

#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    Halo<Real> halo;
    load_halo<Real>(active.at[s], active, lattice, [&](std::size_t slot) -> const Nodes& { return phi_[slot]; }, halo);
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
    for (int k = 0; k < 27 && inside; ++k) {
      const std::int32_t slot = active.near(b, k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1, lattice);
      inside = slot >= 0 && full_[static_cast<std::size_t>(slot)];
    }
    if (inside) continue;
    Halo<Real> psi;
    load_halo<Real>(b, active, lattice, [&](std::size_t slot) -> const Nodes& { return smooth_[slot]; }, psi);
    for (auto& plane : psi)
      for (auto& line : plane)
        for (Real& value : line) value = std::min(std::max((value - Real(0.2)) / Real(0.6), Real(0)), Real(1));
    const bool near_contact = contacts.near(b, 4 * dx);
    const Point origin = lattice.origin(b);
    auto& density = density_[s];
    for (auto& field : density) field.fill(0);
    bool any = false;
    for (int x = 0; x < 4; ++x)
      for (int y = 0; y < 4; ++y)
        for (int z = 0; z < 4; ++z) {
          const auto k = static_cast<std::size_t>(node_in_block(x, y, z));
          if (smooth_[s][k] < Real(1e-3)) continue;
          static constexpr Real across[3] = {Real(0.125), Real(0.75), Real(0.125)};
          Real g[3] = {0, 0, 0};
          for (int a = 0; a < 3; ++a)
            for (int c = 0; c < 3; ++c) {
              const Real w = across[a] * across[c];
              g[0] += w * (psi[x + 2][y + a][z + c] - psi[x][y + a][z + c]);
              g[1] += w * (psi[x + a][y + 2][z + c] - psi[x + a][y][z + c]);
              g[2] += w * (psi[x + a][y + c][z + 2] - psi[x + a][y + c][z]);
            }
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
    const BlockIndex b = active.at[s];
    bool any = false;
    for (int k = 0; k < 27; ++k) {
      const std::int32_t slot = active.near(b, k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1, lattice);
      any |= slot >= 0 && has_density_[static_cast<std::size_t>(slot)];
    }
    has_surface_[s] = any;
    if (!any) continue;
    static const Nodes none{};
    std::array<Nodes, 4> smoothed;
    for (std::size_t field = 0; field < 4; ++field) {
      Halo<Real> halo;
      load_halo<Real>(
          b, active, lattice, [&](std::size_t slot) -> const Nodes& { return has_density_[slot] ? density_[slot][field] : none; }, halo);
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

template class FreeSurfaceMeasure<float>;
template class FreeSurfaceMeasure<double>;

}  // namespace bake

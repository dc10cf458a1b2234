// SPDX-License-Identifier: MIT
#include "solver/engine/surface.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "solver/core/parallel.h"
#include "solver/core/vector3.h"

namespace bake {

namespace {

// A block and one node around it, or two: 6 x 6 or 8 x 8 lines along z. A line has room for 8, so that one loop runs through all of them
// and vectorises; what it makes in between is not used.
constexpr int k_line = 8;
template <int side>
constexpr int k_plane = side* k_line;
template <int side>
constexpr int halo_index(int x, int y, int z) {
  return x * k_plane<side> + y * k_line + z;
}
/// Numbers up to the last that is of use: after a difference or sum along x, along x and y, along all three.
template <int side>
constexpr int k_after_x = (side - 2) * k_plane<side>;
template <int side>
constexpr int k_after_y = k_after_x<side> - 2 * k_line;
template <int side>
constexpr int k_after_z = halo_index<side>(side - 3, side - 3, side - 3) + 1;
constexpr int k_narrow = 6, k_wide = 8;  ///< sides of halos

template <class Real, int count>
struct alignas(64) Numbers {
  Real at[count];
};
template <class Real, int side>
using Halo = Numbers<Real, side * k_plane<side>>;

/// A block's line of nodes along z.
template <class Real>
struct Line {
  typedef Real Four __attribute__((vector_size(4 * sizeof(Real)), aligned(sizeof(Real)), may_alias));
  Four at;
  explicit Line(const Real* nodes) : at(*reinterpret_cast<const Four*>(nodes)) {}
  /// The last `tail` nodes of this line and the first of the next.
  template <int tail>
  void store_across(const Line& next, Real* to) const {
    *reinterpret_cast<Four*>(to) = __builtin_shufflevector(at, next.at, 4 - tail, 5 - tail, 6 - tail, 7 - tail);
  }
};

/// Copies the nodes of a block and those around it. `nodes_of(slot)` points to those of a block, or is null if all of them are zero. False,
/// and nothing done, if it is null for every block.
template <int side, class Real, class NodesOf>
bool load_halo(const std::array<std::int32_t, 27>& around, NodesOf nodes_of, Halo<Real, side>& out) {
  constexpr int k_margin = (side - 4) / 2;
  static constexpr Real none[k_block_nodes] = {};
  const Real* block[27];
  bool any = false;
  for (std::size_t i = 0; i < 27; ++i) {
    const std::array<Real, k_block_nodes>* nodes = around[i] < 0 ? nullptr : nodes_of(static_cast<std::size_t>(around[i]));
    any |= nodes != nullptr;
    block[i] = nodes ? nodes->data() : none;
  }
  if (!any) return false;
#pragma GCC unroll 8
  for (int x = 0; x < side; ++x)
#pragma GCC unroll 8
    for (int y = 0; y < side; ++y) {
      const int gx = x + 4 - k_margin, gy = y + 4 - k_margin;  // 4 is the block's first node
      const Real* const* column = block + (gx >> 2) * 9 + (gy >> 2) * 3;
      const int line = node_in_block(gx & 3, gy & 3, 0);
      const Line<Real> below(column[0] + line), own(column[1] + line), above(column[2] + line);
      Real* to = out.at + halo_index<side>(x, y, 0);
      below.template store_across<k_margin>(own, to);
      own.template store_across<k_margin>(above, to + 4);
    }
  return true;
}

/// Sums of three, weighted (1, centre, 1), along x, y or z if the stride is that of a plane, of a line or 1.
template <int stride, class Real, int from, int count>
void sum(const Numbers<Real, from>& in, Real centre, Numbers<Real, count>& out) {
  static_assert(count + 2 * stride <= from);
  for (int i = 0; i < count; ++i) out.at[i] = in.at[i] + centre * in.at[i + stride] + in.at[i + 2 * stride];
}
template <int stride, class Real, int from, int count>
void difference(const Numbers<Real, from>& in, Numbers<Real, count>& out) {
  static_assert(count + 2 * stride <= from);
  for (int i = 0; i < count; ++i) out.at[i] = in.at[i + 2 * stride] - in.at[i];
}

/// The block's own nodes, times a factor.
template <class Real>
void pick(const Numbers<Real, k_after_z<k_narrow>>& in, Real factor, std::array<Real, k_block_nodes>& out) {
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) out[static_cast<std::size_t>(node_in_block(x, y, z))] = factor * in.at[halo_index<k_narrow>(x, y, z)];
}

/// (1, 2, 1)/4 along each axis, times a factor.
template <class Real>
void blur(const Halo<Real, k_narrow>& in, Real factor, std::array<Real, k_block_nodes>& out) {
  Numbers<Real, k_after_x<k_narrow>> x;
  Numbers<Real, k_after_y<k_narrow>> xy;
  Numbers<Real, k_after_z<k_narrow>> xyz;
  sum<k_plane<k_narrow>>(in, Real(2), x);
  sum<k_line>(x, Real(2), xy);
  sum<1>(xy, Real(2), xyz);
  pick(xyz, factor / 64, out);
}

/// 64 times the differences over two nodes along each axis, smoothed by (1, 6, 1)/8 along the other two.
template <class Real, int side>
struct Gradient {
  static constexpr int k_count = k_after_z<side>;
  Numbers<Real, k_count> along[3];
  explicit Gradient(const Halo<Real, side>& psi) {
    Numbers<Real, k_after_x<side>> smooth, d_x;
    Numbers<Real, k_after_y<side>> smooth_smooth, d_x_smooth, smooth_d_y;
    sum<k_plane<side>>(psi, Real(6), smooth);
    difference<k_plane<side>>(psi, d_x);
    sum<k_line>(smooth, Real(6), smooth_smooth);
    sum<k_line>(d_x, Real(6), d_x_smooth);
    difference<k_line>(smooth, smooth_d_y);
    sum<1>(d_x_smooth, Real(6), along[0]);
    sum<1>(smooth_d_y, Real(6), along[1]);
    difference<1>(smooth_smooth, along[2]);
  }
  Real squared(int i) const { return along[0].at[i] * along[0].at[i] + along[1].at[i] * along[1].at[i] + along[2].at[i] * along[2].at[i]; }
};

/// 128^2 times the second differences of phi over two nodes, smoothed as their gradient is.
template <class Real>
struct Hessian {
  static constexpr int k_x = k_after_z<k_wide> - 2 * k_plane<k_wide>, k_xy = k_x - 2 * k_line, k_xyz = k_xy - 2;
  static_assert(halo_index<k_wide>(3, 3, 3) < k_xyz);
  Numbers<Real, k_xyz> xx, xy, xz, yy, yz, zz;
  explicit Hessian(const Gradient<Real, k_wide>& g) {
    const auto& [along_x, along_y, along_z] = g.along;
    Numbers<Real, k_x> x;
    Numbers<Real, k_xy> y;
    difference<k_plane<k_wide>>(along_x, x);
    sum<k_line>(x, Real(6), y);
    sum<1>(y, Real(6), xx);
    sum<k_plane<k_wide>>(along_x, Real(6), x);
    difference<k_line>(x, y);
    sum<1>(y, Real(6), xy);
    sum<k_line>(x, Real(6), y);
    difference<1>(y, xz);
    sum<k_plane<k_wide>>(along_y, Real(6), x);
    difference<k_line>(x, y);
    sum<1>(y, Real(6), yy);
    sum<k_line>(x, Real(6), y);
    difference<1>(y, yz);
    sum<k_plane<k_wide>>(along_z, Real(6), x);
    sum<k_line>(x, Real(6), y);
    difference<1>(y, zz);
  }
};

/// dx (k_1 + k_2) = -dx div n, the sum of the principal curvatures of the levels of phi, positive on a ball; n = g / |g|, g = grad phi. As
/// -(tr H - n.H n) / |g|, which knows nothing of how fast phi changes along n: between the two faces of a sheet it is level. The slope
/// k_level keeps it finite there. Of the block's own nodes.
template <class Real>
void find_curvature(const Halo<Real, k_wide>& phi, std::array<Real, k_block_nodes>& out) {
  constexpr Real k_level = Real(0.02 * 128);
  const Gradient<Real, k_wide> gradient(phi);
  const Hessian<Real> H(gradient);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        const int at = halo_index<k_wide>(i, j, k), of_g = halo_index<k_wide>(i + 1, j + 1, k + 1);
        const Real x = gradient.along[0].at[of_g], y = gradient.along[1].at[of_g], z = gradient.along[2].at[of_g];
        const Real xx = H.xx.at[at], yy = H.yy.at[at], zz = H.zz.at[at];
        const Real across = (y * y + z * z) * xx + (x * x + z * z) * yy + (x * x + y * y) * zz -
                            2 * (x * y * H.xy.at[at] + x * z * H.xz.at[at] + y * z * H.yz.at[at]);
        const Real slope = std::sqrt(gradient.squared(of_g) + k_level * k_level);
        out[static_cast<std::size_t>(node_in_block(i, j, k))] = across / (slope * slope * slope) * Real(-1. / 128);
      }
}

/// Nodes of a block along one axis that are images of others in a face of the domain: node i is that of node[i] of `block`, or of
/// none (-1).
struct Images {
  int block;
  int node[4];
};

/// Is any node of the block an image?
bool has_images(const BlockIndex& b, const GridGeometry& geometry, const Contacts& contacts) {
  const int block[3] = {b.x, b.y, b.z};
  for (int f = 0; f < 6; ++f) {
    const int axis = f / 2, first = 4 * block[axis];
    const double face = f % 2 ? geometry.high_face(axis) : geometry.low_face();
    if (first - k_mirrored <= face && face <= first + 3 + k_mirrored && contacts.is_mirror(f)) return true;
  }
  return false;
}

constexpr int k_most_images = 16;

/// A block's own nodes along an axis, and what they are images of: through one face, or to and fro through both where these are near each
/// other. Returns how many.
int find_images(int block, int axis, const GridGeometry& geometry, const Contacts& contacts, Images (&found)[k_most_images]) {
  const int low = static_cast<int>(geometry.low_face()), high = static_cast<int>(geometry.high_face(axis)), width = high - low;
  const bool at_low = contacts.is_mirror(2 * axis), at_high = contacts.is_mirror(2 * axis + 1);
  int count = 0;
  found[count++] = {block, {0, 1, 2, 3}};
  const auto add = [&](int i, int image) {
    if (image < low - 1 || image > high + 1) return;  // dough reaches no further
    int k = 1;
    while (k < count && (found[k].block != image >> 2 || found[k].node[i] >= 0)) ++k;
    if (k == count) found[count++] = {image >> 2, {-1, -1, -1, -1}};
    found[k].node[i] = image & 3;
  };
  for (int i = 0; i < 4; ++i) {
    const int node = 4 * block + i;
    if (node < low - k_mirrored || node > high + k_mirrored) continue;
    if (at_low) add(i, 2 * low - node);
    if (at_high) add(i, 2 * high - node);
    if (!at_low || !at_high) continue;
    for (int shift = 2 * width; shift <= width + k_mirrored + 2; shift += 2 * width)
      for (const int image : {node - shift, node + shift, 2 * low - node - shift, 2 * high - node + shift}) add(i, image);
  }
  return count;
}

/// Are all of its numbers equal?
template <class Real, int count>
bool is_constant(const Numbers<Real, count>& in) {
  int others = 0;
  for (const Real value : in.at) others += value != in.at[0];
  return others == 0;
}

/// What smoothing took off the area of a curved surface. Smoothing with the variance sigma^2 per axis moves a level by sigma^2 (k_1 +
/// k_2)/2 towards the centre, which leaves 1 - sigma^2/2 (k_1 + k_2)^2 of its area. Bounded where the surface bends within a cell.
/// An edge bends within less than K is averaged over, and shows by how much K varies there: the loss goes with the integral of that
/// variance. Taken off it are the noise of particles, 0.01, and what levels one within the other vary by: 2/r on a ball, dK/dr = -K^2/2,
/// over a third of dx. The factor is fitted to right angles (paper/surface.md: cubes and cylinders at any angle and size).
template <class Real>
Real unrounded(Real r, Real bend, Real edge, double half_variance) {
  constexpr Real k_most = Real(0.5), k_edge = Real(9), k_noise = Real(0.01), k_levels = Real(0.03), k_edge_most = Real(1);
  const Real inverse = r > 0 ? 1 / r : Real(0), K = bend * inverse, K2 = K * K;
  const Real varies = std::max(edge * inverse - K2 - k_noise - k_levels * K2 * K2, Real(0));
  return 1 + std::min(static_cast<Real>(half_variance) * K2, k_most) + std::min(k_edge * varies, k_edge_most);
}

template <class Nodes>
bool any_positive(const Nodes& nodes) {
  return std::any_of(nodes.begin(), nodes.end(), [](auto value) { return value > 0; });
}

}  // namespace

template <class Real>
void FreeSurfaceMeasure<Real>::measure(const Rows& rows, const SurfaceLayer<Real>& layer, double rounding, const ActiveBlocks& active,
                                       const GridGeometry& geometry, const Contacts& contacts) {
  layer_ = layer;
  rounding_ = rounding;
  take_volumes(rows, active);
  find(active, geometry, contacts);
}

template <class Real>
void FreeSurfaceMeasure<Real>::follow(const Rows& rows, const ActiveBlocks& active) {
  take_volumes(rows, active);
  find_areas(active);
}

template <class Real>
void FreeSurfaceMeasure<Real>::measure_again(std::vector<Nodes> volumes, const SurfaceLayer<Real>& layer, double rounding,
                                             const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts) {
  layer_ = layer;
  rounding_ = rounding;
  volume_ = std::move(volumes);
  blocks_.resize(volume_.size());
  for (std::size_t s = 0; s < blocks_.size(); ++s) blocks_[s].has_volume = any_positive(volume_[s]);
  find(active, geometry, contacts);
}

template <class Real>
void FreeSurfaceMeasure<Real>::take_volumes(const Rows& rows, const ActiveBlocks& active) {
  const std::size_t n = active.at.size();
  volume_.resize(n);
  conductivity_.resize(rows.conductivity_channel < 0 ? 0 : n);
  blocks_.resize(n);
  for_each_parallel(n, 16, [&](std::size_t s) {
    const auto take = [&](int channel, Nodes& to) {
      for (std::size_t k = 0; k < k_block_nodes; ++k)
        to[k] = rows.numbers[(s * k_block_nodes + k) * static_cast<std::size_t>(rows.size) + static_cast<std::size_t>(channel)];
    };
    if (active.touched[s]) {
      take(rows.volume_channel, volume_[s]);
      if (!conductivity_.empty()) take(rows.conductivity_channel, conductivity_[s]);
    } else {
      volume_[s].fill(0);
    }
    blocks_[s].has_volume = any_positive(volume_[s]);
  });
}

/// A_i / V_i of air and covers, from the volumes.
template <class Real>
void FreeSurfaceMeasure<Real>::find(const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts) {
  const std::size_t n = active.at.size();
  for (auto* field : {&mirrored_, &smooth_, &filled_, &density_, &bend_, &edge_}) field->resize(n);
  covers_.resize(n);
  shares_.resize(n);
  facing_.resize(n);
  for_each_parallel(n, 16, [&](std::size_t s) {
    blocks_[s] = {.has_volume = blocks_[s].has_volume};
    covers_[s].clear();
    shares_[s].clear();
  });
  for_each_parallel(n, 16, [&](std::size_t s) { mirror(s, active, geometry, contacts); });
  for_each_parallel(n, 16, [&](std::size_t s) { smooth(s, active, geometry, contacts); });
  for_each_parallel(n, 16, [&](std::size_t s) { find_density(s, active, geometry, contacts); });
  heats_.clear();
  for (const auto& covers : covers_)
    for (const Cover& cover : covers)
      if (std::find(heats_.begin(), heats_.end(), cover.heat) == heats_.end()) heats_.push_back(cover.heat);
  find_areas(active);
}

/// Of blocks with dough that have none yet: all after `find`, and later those into which it has come since.
template <class Real>
void FreeSurfaceMeasure<Real>::find_areas(const ActiveBlocks& active) {
  for_each_parallel(active.at.size(), 16, [&](std::size_t s) {
    if (blocks_[s].has_volume && !blocks_[s].has_area) find_area(s, active);
  });
}

/// Faces of the domain that pass no heat are mirrors, not surfaces: the volume of the mirrored dough is added.
template <class Real>
void FreeSurfaceMeasure<Real>::mirror(std::size_t s, const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts) {
  const BlockIndex& b = active.at[s];
  if (!has_images(b, geometry, contacts)) return;
  Images x[k_most_images], y[k_most_images], z[k_most_images];
  const int xs = find_images(b.x, 0, geometry, contacts, x), ys = find_images(b.y, 1, geometry, contacts, y),
            zs = find_images(b.z, 2, geometry, contacts, z);
  blocks_[s].is_mirrored = true;
  mirrored_[s].fill(0);
  const auto add = [&](const Images& ix, const Images& iy, const Images& iz) {
    const std::int32_t slot = active.slot_at({ix.block, iy.block, iz.block}, geometry);
    if (slot < 0 || !blocks_[static_cast<std::size_t>(slot)].has_volume) return;
    const Nodes& V = volume_[static_cast<std::size_t>(slot)];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        if (ix.node[i] < 0 || iy.node[j] < 0) continue;
        Real* line = &mirrored_[s][static_cast<std::size_t>(node_in_block(i, j, 0))];
        const Real* image = &V[static_cast<std::size_t>(node_in_block(ix.node[i], iy.node[j], 0))];
        for (int k = 0; k < 4; ++k)
          if (iz.node[k] >= 0) line[k] += image[iz.node[k]];
      }
  };
  for (int i = 0; i < xs; ++i)
    for (int j = 0; j < ys; ++j)
      for (int k = 0; k < zs; ++k) add(x[i], y[j], z[k]);
}

/// phi~, alone and over the room.
template <class Real>
void FreeSurfaceMeasure<Real>::smooth(std::size_t s, const ActiveBlocks& active, const GridGeometry& geometry, const Contacts& contacts) {
  Halo<Real, k_narrow> halo;
  const auto volumes = [&](std::size_t i) {
    return blocks_[i].is_mirrored ? &mirrored_[i] : blocks_[i].has_volume ? &volume_[i] : nullptr;
  };
  blocks_[s].is_empty = !load_halo<k_narrow>(active.around[s], volumes, halo);
  if (blocks_[s].is_empty) return;
  const double dx = geometry.dx();
  blur(halo, static_cast<Real>(1 / (dx * dx * dx)), smooth_[s]);
  int full = 0, empty = 0;
  for (const Real phi : smooth_[s]) full += phi >= k_full, empty += phi < k_no_dough;
  blocks_[s].is_full = full == k_block_nodes;
  blocks_[s].is_empty = empty == k_block_nodes;
  if (blocks_[s].is_empty || !contacts.cover_near(active.at[s], k_reach * dx)) return;
  blocks_[s].is_beside = true;
  for (std::size_t k = 0; k < k_block_nodes; ++k) {
    const Real phi = smooth_[s][k];
    filled_[s][k] = phi;
    if (phi < k_no_dough || phi >= 1) continue;
    const double room = std::max(contacts.room(Place(geometry, active.at[s], static_cast<int>(k))), k_least_room);
    filled_[s][k] = std::min(phi / static_cast<Real>(room), Real(1));
  }
}

/// r and r K, of the air or of the solid that covers the node.
template <class Real>
void FreeSurfaceMeasure<Real>::find_density(std::size_t s, const ActiveBlocks& active, const GridGeometry& geometry,
                                            const Contacts& contacts) {
  const auto is_full = [&](std::int32_t slot) { return slot >= 0 && blocks_[static_cast<std::size_t>(slot)].is_full; };
  if (blocks_[s].is_empty || std::all_of(active.around[s].begin(), active.around[s].end(), is_full)) return;
  const double dx = geometry.dx();
  // from phi of the nodes around; visit(node, solids in front of it) where there is a surface
  const auto measure = [&](auto phi_of, Nodes& r, Nodes& bend, auto visit) {
    Halo<Real, k_narrow> psi;
    load_halo<k_narrow>(active.around[s], phi_of, psi);
    constexpr Real k_outside = Real(0.2), k_slope = 1 / (k_full - k_outside);
    for (Real& value : psi.at) value = std::min(std::max((value - k_outside) * k_slope, Real(0)), Real(1));
    if (is_constant(psi)) return;
    const Gradient<Real, k_narrow> g(psi);
    Numbers<Real, k_after_z<k_narrow>> squared;
    for (int i = 0; i < g.k_count; ++i) squared.at[i] = g.squared(i);
    pick(squared, Real(1), r);
    const Real per_length = static_cast<Real>(1 / (64 * 2 * dx));
    const Nodes& own = *phi_of(s);
    for (std::size_t k = 0; k < k_block_nodes; ++k) r[k] = own[k] < k_no_dough ? Real(0) : std::sqrt(r[k]) * per_length / own[k];
    if (!any_positive(r)) return;
    Halo<Real, k_wide> phi;
    load_halo<k_wide>(active.around[s], phi_of, phi);
    for (Real& value : phi.at) value = value < k_no_dough ? Real(0) : value;  // as in blocks that are empty
    find_curvature(phi, bend);
    for (std::size_t k = 0; k < k_block_nodes; ++k) bend[k] *= r[k];
    if (!blocks_[s].is_beside) return;
    for (std::size_t k = 0; k < k_block_nodes; ++k) {
      if (r[k] == 0) continue;
      const auto [x, y, z] = coordinates_in_block(static_cast<int>(k));
      const int i = halo_index<k_narrow>(x, y, z);
      const Vector3 inward{double(g.along[0].at[i]), double(g.along[1].at[i]), double(g.along[2].at[i])};
      visit(k, contacts.covering(Place(geometry, active.at[s], static_cast<int>(k)), (-1 / length(inward)) * inward, k_reach * dx));
    }
  };
  Nodes &r = density_[s], &bend = bend_[s], &edge = edge_[s];
  r.fill(0);
  measure([&](std::size_t i) { return blocks_[i].is_empty    ? nullptr
                                      : blocks_[i].is_beside ? &filled_[i]
                                                             : &smooth_[i]; }, r, bend,
          [&](std::size_t k, const Covers& covers) {
            if (covers.count > 0) r[k] = bend[k] = 0;
          });
  blocks_[s].has_density = any_positive(r);
  if (blocks_[s].has_density)
    for (std::size_t k = 0; k < k_block_nodes; ++k) {
      const Real room = blocks_[s].is_beside && filled_[s][k] > 0 ? smooth_[s][k] / filled_[s][k] : Real(1);
      edge[k] = r[k] > 0 ? bend[k] * bend[k] / r[k] * std::max(1 - k_ends * (1 - room), Real(0)) : Real(0);
    }
  if (!blocks_[s].is_beside) return;
  Nodes covered{}, covered_bend;
  measure([&](std::size_t i) { return blocks_[i].is_empty ? nullptr : &smooth_[i]; }, covered, covered_bend,
          [&](std::size_t k, const Covers& covers) {
            for (const Covers::Solid& solid : covers) {
              const ContactHeat& heat = solid.heat;
              const Real part = static_cast<Real>(solid.share), r_of_it = part * covered[k];
              auto cover = std::find_if(covers_[s].begin(), covers_[s].end(), [&](const Cover& c) { return c.heat == heat; });
              if (cover == covers_[s].end()) cover = covers_[s].insert(cover, Cover{heat, {}, {}});
              cover->density[k] += r_of_it;
              cover->bend[k] += part * covered_bend[k];
              if (heat.giver < 0) continue;
              auto share = std::find_if(shares_[s].begin(), shares_[s].end(), [&](const Share& h) { return h.giver == heat.giver; });
              if (share == shares_[s].end()) share = shares_[s].insert(share, Share{heat.giver, heat, {}});
              share->density[k] += r_of_it;
            }
          });
}

/// Null if no solid with that heat covers the block.
template <class Real>
const typename FreeSurfaceMeasure<Real>::Nodes* FreeSurfaceMeasure<Real>::of_cover(std::size_t slot, const ContactHeat& heat,
                                                                                   Nodes Cover::*nodes) const {
  for (const Cover& cover : covers_[slot])
    if (cover.heat == heat) return &(cover.*nodes);
  return nullptr;
}

/// Averages a field of the blocks around. False, and nothing done, if there is none.
template <class Real>
template <class FieldOf>
bool FreeSurfaceMeasure<Real>::blurred(std::size_t s, const ActiveBlocks& active, FieldOf field_of, Nodes& out) const {
  Halo<Real, k_narrow> halo;
  if (!load_halo<k_narrow>(active.around[s], field_of, halo)) return false;
  blur(halo, Real(1), out);
  return true;
}

/// A_i / V_i of what faces the nodes: r, averaged, times what puts back the area that smoothing took off.
template <class Real>
void FreeSurfaceMeasure<Real>::find_area(std::size_t s, const ActiveBlocks& active) {
  const auto find = [&](auto density_of, auto bend_of, auto edge_of, Nodes& per_volume) {
    Nodes r, bend, edge{};
    if (!blurred(s, active, density_of, r)) return false;
    blurred(s, active, bend_of, bend);
    blurred(s, active, edge_of, edge);
    for (std::size_t k = 0; k < k_block_nodes; ++k) per_volume[k] = r[k] * unrounded(r[k], bend[k], edge[k], rounding_);
    return true;
  };
  const auto of_air = [&](const std::vector<Nodes>& field) {
    return [&](std::size_t i) { return blocks_[i].has_density ? &field[i] : nullptr; };
  };
  blocks_[s].has_area = true;
  blocks_[s].faces_air = find(of_air(density_), of_air(bend_), of_air(edge_), smooth_[s]);
  facing_[s].clear();
  for (const ContactHeat& heat : heats_) {
    Facing solid{heat, {}};
    const bool found = find([&](std::size_t i) { return of_cover(i, heat, &Cover::density); },
                            [&](std::size_t i) { return of_cover(i, heat, &Cover::bend); },
                            [](std::size_t) -> const Nodes* { return nullptr; }, solid.per_volume);
    if (found) facing_[s].push_back(solid);
  }
}

/// Node after node without branches, so that the loops vectorise.
template <class Real>
void FreeSurfaceMeasure<Real>::pass(std::size_t s, const ContactHeat& heat, const Nodes& per_volume, Passing& out) const {
  const bool resists = !conductivity_.empty();
  const Nodes &V = volume_[s], &kappa = resists ? conductivity_[s] : V;
  const auto beta = static_cast<Real>(heat.heat_transfer_coefficient), theta = static_cast<Real>(heat.temperature),
             flux = static_cast<Real>(heat.flux);
  for (std::size_t k = 0; k < k_block_nodes; ++k) out.area[k] = V[k] * per_volume[k];
  if (heat.heat_transfer_coefficient == k_infinity) {
    for (std::size_t k = 0; k < k_block_nodes; ++k)
      out.transfer[k] = out.area[k] > 0 && resists ? out.area[k] * layer_.conductance(kappa[k], V[k]) : Real(0);
  } else if (resists) {
    for (std::size_t k = 0; k < k_block_nodes; ++k)
      out.transfer[k] = beta * (out.area[k] * layer_.share_that_passes(beta * V[k], kappa[k]));
  } else {
    for (std::size_t k = 0; k < k_block_nodes; ++k) out.transfer[k] = beta * out.area[k];
  }
  for (std::size_t k = 0; k < k_block_nodes; ++k) out.source[k] = out.transfer[k] * theta + out.area[k] * flux;
}

template <class Real>
bool FreeSurfaceMeasure<Real>::surround(std::size_t s, const Air& air, BlockSurroundings<Real>& out) const {
  if (!published_.empty()) {
    out = published_[s];
    return true;
  }
  if (!blocks_[s].has_volume || !(blocks_[s].faces_air || !facing_[s].empty())) return false;
  out = {};
  const auto add = [&](const Nodes& per_volume, const ContactHeat& heat, Real(&area)[k_block_nodes]) {
    Passing passing;
    pass(s, heat, per_volume, passing);
    for (std::size_t k = 0; k < k_block_nodes; ++k) {
      area[k] += passing.area[k];
      out.heat_transfer[k] += passing.transfer[k];
      out.heat_transfer_source[k] += passing.source[k];
    }
  };
  if (blocks_[s].faces_air) add(smooth_[s], ContactHeat{air.heat_transfer_coefficient, air.temperature}, out.area);
  for (const Facing& solid : facing_[s]) add(solid.per_volume, solid.heat, out.contact_area);
  return true;
}

/// Of all covers with the same heat a giver has the share that its r has of theirs.
template <class Real>
void FreeSurfaceMeasure<Real>::tell(std::size_t s, const ActiveBlocks& active,
                                    const std::function<void(int, int, double, double)>& visit) const {
  if (!published_.empty()) {
    for (std::size_t k = 0; k < k_block_nodes; ++k)
      if (const int giver = published_givers_[s][k]; giver >= 0)
        visit(giver, static_cast<int>(k), double(published_[s].heat_transfer[k]), double(published_[s].heat_transfer_source[k]));
    return;
  }
  if (!blocks_[s].has_volume) return;
  std::vector<std::pair<int, ContactHeat>> givers;  // in the order of their numbers
  for (const std::int32_t slot : active.around[s]) {
    if (slot < 0) continue;
    for (const Share& share : shares_[static_cast<std::size_t>(slot)]) {
      const auto at = std::find_if(givers.begin(), givers.end(), [&](const auto& giver) { return giver.first >= share.giver; });
      if (at == givers.end() || at->first != share.giver) givers.insert(at, {share.giver, share.heat});
    }
  }
  for (const auto& [giver, heat] : givers) {
    const auto of_giver = [&, number = giver](std::size_t i) -> const Nodes* {
      const auto share = std::find_if(shares_[i].begin(), shares_[i].end(), [&](const Share& h) { return h.giver == number; });
      return share == shares_[i].end() ? nullptr : &share->density;
    };
    Nodes all, own;
    if (!blurred(s, active, of_giver, own)) continue;
    blurred(
        s, active, [&, &heat = heat](std::size_t i) { return of_cover(i, heat, &Cover::density); }, all);
    const auto of_all = std::find_if(facing_[s].begin(), facing_[s].end(), [&, &heat = heat](const Facing& f) { return f.heat == heat; });
    Passing passing;
    pass(s, heat, of_all->per_volume, passing);
    for (std::size_t k = 0; k < k_block_nodes; ++k) {
      if (!(own[k] > 0)) continue;
      const double share = double(own[k] / all[k]);
      visit(giver, static_cast<int>(k), share * double(passing.transfer[k]), share * double(passing.source[k]));
    }
  }
}

template class FreeSurfaceMeasure<float>;
template class FreeSurfaceMeasure<double>;

}  // namespace bake

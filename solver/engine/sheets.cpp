// SPDX-License-Identifier: MIT
#include "solver/engine/sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "solver/core/elementary.h"
#include "solver/core/errors.h"
#include "solver/core/parallel.h"
#include "solver/core/vector3.h"
#include "solver/effects/skin_elements.h"

namespace bake {
namespace {

constexpr std::size_t k_chunk = 32;  ///< packs of elements that one thread does at a time
enum TriangleConstant { k_inverse, k_mu = 4, k_lambda, k_area, k_triangle_constants };
enum HingeConstant { k_stiffness, k_rest, k_edge_2, k_hinge_constants };

struct AtRest {
  double inverse[4];  ///< D_m^-1 by rows [1/m]
  double area;        ///< [m^2]
};

/// A triangle in its own plane, the first edge along the first axis.
AtRest at_rest(const Point& p, const Point& q, const Point& r) {
  const Vector3 a = q - p, b = r - p, n = cross(a, b);
  const double edge = length(a), area = length(n) / 2;
  const double b_1 = dot(a, b) / edge, b_2 = 2 * area / edge;  // D_m = [edge b_1; 0 b_2]
  return {{1 / edge, -b_1 / (edge * b_2), 0, 1 / b_2}, area};
}

/// The angle between the normals of two triangles that share the edge p q, with the tips r left and s right of it.
double angle_between(const Point& p, const Point& q, const Point& r, const Point& s) {
  const Vector3 e = q - p, n = cross(e, r - p), m = cross(s - p, e);
  const double sine = dot(cross(n, m), e) / length(e), cosine = dot(n, m);
  const double acute = sine == 0 && cosine == 0 ? 0 : elementary::angle(std::abs(sine), std::abs(cosine));
  return std::copysign(cosine < 0 ? std::numbers::pi - acute : acute, sine);
}

}  // namespace

template <class Real>
Sheets<Real>::Sheets(const Scene& scene, std::vector<SurfaceMesh> meshes, std::int64_t first_identity)
    : meshes_(std::move(meshes)), first_identity_(first_identity) {
  std::vector<std::vector<std::int32_t>> triangle_vertices, hinge_vertices;
  std::vector<std::vector<double>> triangle_constants, hinge_constants;
  for (std::size_t s = 0; s < meshes_.size(); ++s) {
    const Skin& skin = scene.skins[s];
    const SurfaceMesh& mesh = meshes_[s];
    const auto first = static_cast<std::int32_t>(position_.size());
    const double nu = skin.poisson_ratio, mu = skin.young_modulus_Pa / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - nu);  // plane stress
    const auto at = [&](std::int32_t v) { return mesh.points[static_cast<std::size_t>(v)]; };
    for (const SurfaceTriangle& t : mesh.triangles) {
      const AtRest rest = at_rest(at(t[0]), at(t[1]), at(t[2]));
      const double volume = rest.area * skin.thickness_m;
      triangle_vertices.push_back({first + t[0], first + t[1], first + t[2]});
      triangle_constants.push_back(
          {rest.inverse[0], rest.inverse[1], rest.inverse[2], rest.inverse[3], volume * mu, volume * lambda, rest.area});
    }
    for (const SurfaceHinge& h : hinges_of(mesh.triangles)) {
      const Point p = at(h.edge[0]), q = at(h.edge[1]), r = at(h.tips[0]), s_ = at(h.tips[1]);
      const double edge_2 = dot(q - p, q - p), areas = (length(cross(q - p, r - p)) + length(cross(q - p, s_ - p))) / 2;
      hinge_vertices.push_back({first + h.edge[0], first + h.edge[1], first + h.tips[0], first + h.tips[1]});
      hinge_constants.push_back({skin.bending_stiffness() * edge_2 / areas, angle_between(p, q, r, s_), edge_2});
    }
    position_.insert(position_.end(), mesh.points.begin(), mesh.points.end());
  }
  triangles_ = in_columns(triangle_vertices, triangle_constants);
  hinges_ = in_columns(hinge_vertices, hinge_constants);
  is_left_.assign(position_.size(), 1);
  force_.assign(3 * position_.size(), Real(0));
  give_slots();
}

/// The last pack is filled with elements without stiffness.
template <class Real>
typename Sheets<Real>::Elements Sheets<Real>::in_columns(const std::vector<std::vector<std::int32_t>>& vertices,
                                                         const std::vector<std::vector<double>>& constants) {
  Elements elements;
  elements.count = vertices.size();
  if (vertices.empty()) return elements;
  elements.corners = vertices.front().size();
  const std::size_t n = elements.padded();
  elements.vertex.resize(elements.corners * n);
  elements.constants.resize(constants.front().size() * n);
  for (std::size_t e = 0; e < n; ++e) {
    const std::size_t from = std::min(e, elements.count - 1);
    for (std::size_t k = 0; k < elements.corners; ++k) elements.vertex[k * n + e] = vertices[from][k];
    for (std::size_t c = 0; c < constants.front().size(); ++c)
      elements.constants[c * n + e] = e == from ? static_cast<Real>(constants[from][c]) : Real(c == k_edge_2 ? 1 : 0);
  }
  return elements;
}

/// A vertex has a slot for each corner that is at it: of triangles first, then of hinges, in their order.
template <class Real>
void Sheets<Real>::give_slots() {
  std::vector<std::size_t> next(position_.size() + 1, 0);
  const auto for_each_corner = [&](auto visit) {
    for (Elements* elements : {&triangles_, &hinges_})
      for (std::size_t e = 0; e < elements->count; ++e)
        for (std::size_t k = 0; k < elements->corners; ++k) visit(*elements, k * elements->padded() + e);
  };
  for (Elements* elements : {&triangles_, &hinges_}) elements->slot.assign(elements->vertex.size(), 0);
  for_each_corner([&](const Elements& elements, std::size_t corner) { ++next[static_cast<std::size_t>(elements.vertex[corner]) + 1]; });
  for (std::size_t v = 0; v < position_.size(); ++v) next[v + 1] += next[v];
  first_slot_ = next;
  // what only fills a pack writes behind them: triangles and hinges apart, since two threads may do so at once
  slots_.assign(3 * (first_slot_.back() + 2), Real(0));
  std::fill(triangles_.slot.begin(), triangles_.slot.end(), static_cast<std::int32_t>(first_slot_.back()));
  std::fill(hinges_.slot.begin(), hinges_.slot.end(), static_cast<std::int32_t>(first_slot_.back() + 1));
  for_each_corner([&](Elements& elements, std::size_t corner) {
    elements.slot[corner] = static_cast<std::int32_t>(next[static_cast<std::size_t>(elements.vertex[corner])]++);
  });
}

template <class Real>
std::size_t Sheets<Real>::vertices_left() const {
  return static_cast<std::size_t>(std::count(is_left_.begin(), is_left_.end(), 1));
}

template <class Real>
void Sheets<Real>::find_vertices(const ParticleStore<Real>& store) {
  std::vector<char> found(position_.size(), 0);
  tiles_.resize(store.blocks.size());
  for_each_parallel(store.blocks.size(), 16, [&](std::size_t b) {
    const HomeBlock& block = store.blocks[b];
    Tiles tiles{block.first_tile + block.tiles, block.first_tile + block.tiles};  // they are the last: materials rise
    while (tiles.first > block.first_tile &&
           identity_of<Real>(store.tile(static_cast<std::size_t>(tiles.first - 1)), 0) >= first_identity_ &&
           identity_of<Real>(store.tile(static_cast<std::size_t>(tiles.first - 1)), 0) <
               first_identity_ + static_cast<std::int64_t>(vertices()))
      --tiles.first;
    tiles_[b] = tiles;
    for (std::int32_t t = tiles.first; t < tiles.end; ++t)
      for (int l = 0; l < store.tiles[static_cast<std::size_t>(t)].count; ++l)
        found[static_cast<std::size_t>(identity_of<Real>(store.tile(static_cast<std::size_t>(t)), l) - first_identity_)] = 1;
  });
  if (found == is_left_) return;
  is_left_ = found;
  tear();
}

/// Elements without all of their corners have no stiffness.
template <class Real>
void Sheets<Real>::tear() {
  for (Elements* elements : {&triangles_, &hinges_})
    for (std::size_t e = 0; e < elements->count; ++e) {
      const std::size_t n = elements->padded();
      bool whole = true;
      for (std::size_t k = 0; k < elements->corners; ++k) whole &= is_left_[static_cast<std::size_t>(elements->vertex[k * n + e])] != 0;
      if (whole) continue;
      if (elements == &triangles_)
        for (const std::size_t c : {std::size_t(k_mu), std::size_t(k_lambda), std::size_t(k_area)}) elements->constants[c * n + e] = 0;
      else
        elements->constants[k_stiffness * n + e] = 0;
    }
}

/// From the first corner of W elements to the others. Subtracted in double, since positions are large.
template <class Real>
template <std::size_t corners>
BAKE_INLINE void Sheets<Real>::differences(const Elements& elements, std::size_t first, V (&d)[corners - 1][3]) const {
  const std::size_t n = elements.padded();
  for (std::size_t l = 0; l < W; ++l) {
    const Vector3& x_0 = position_[static_cast<std::size_t>(elements.vertex[first + l])];
    for (std::size_t k = 1; k < corners; ++k) {
      const Vector3& x = position_[static_cast<std::size_t>(elements.vertex[k * n + first + l])];
      for (std::size_t i = 0; i < 3; ++i) d[k - 1][i][l] = static_cast<Real>(x[i] - x_0[i]);
    }
  }
}

/// `force`: on all corners but the first, which has the opposite of their sum.
template <class Real>
template <std::size_t corners>
BAKE_INLINE void Sheets<Real>::put_forces(const Elements& elements, std::size_t first, const V (&force)[corners - 1][3]) {
  const std::size_t n = elements.padded();
  V of_first[3];
  for (int i = 0; i < 3; ++i) {
    of_first[i] = -force[0][i];
    for (std::size_t k = 1; k + 1 < corners; ++k) of_first[i] -= force[k][i];
  }
  for (std::size_t k = 0; k < corners; ++k)
    for (std::size_t l = 0; l < W; ++l) {
      Real* slot = &slots_[3 * static_cast<std::size_t>(elements.slot[k * n + first + l])];
      for (int i = 0; i < 3; ++i) slot[i] = k == 0 ? of_first[i][l] : force[k - 1][i][l];
    }
}

/// A constant of W elements.
template <class Real>
BAKE_INLINE typename Sheets<Real>::V Sheets<Real>::constants_of(const Elements& elements, std::size_t constant, std::size_t first) {
  V values;
  std::memcpy(&values, &elements.constants[constant * elements.padded() + first], sizeof(V));
  return values;
}

template <class Real>
void Sheets<Real>::act_triangles(std::size_t first, SkinSums* sums) {
  const auto constant = [&](std::size_t c) { return constants_of(triangles_, c, first); };
  V d[2][3], force[2][3];
  differences<3>(triangles_, first, d);
  const V inverse[4] = {constant(k_inverse), constant(k_inverse + 1), constant(k_inverse + 2), constant(k_inverse + 3)};
  const V energy = membrane(d[0], d[1], inverse, constant(k_mu), constant(k_lambda), force[0], force[1]);
  put_forces<3>(triangles_, first, force);
  if (!sums) return;
  V normal[3];
  cross_of(d[0], d[1], normal);
  const V area = Real(0.5) * sqrt(dot_of(normal, normal));
  sums->membrane += sum_lanes(energy);
  sums->area += sum_lanes(constant(k_area) > 0 ? area : 0 * area);
}

template <class Real>
void Sheets<Real>::act_hinges(std::size_t first, SkinSums* sums) {
  const auto constant = [&](std::size_t c) { return constants_of(hinges_, c, first); };
  V d[3][3], force[3][3];
  differences<4>(hinges_, first, d);
  const V energy = hinge(d[0], d[1], d[2], constant(k_stiffness), constant(k_rest), constant(k_edge_2), force[0], force[1], force[2]);
  put_forces<4>(hinges_, first, force);
  if (sums) sums->bending += sum_lanes(energy);
}

template <class Real>
void Sheets<Real>::find_forces(const ParticleStore<Real>& store, const GridGeometry& geometry, bool sums_wanted) {
  for_each_parallel(store.blocks.size(), 16, [&](std::size_t b) {
    const Point origin = geometry.origin(store.blocks[b].at);
    for (std::int32_t t = tiles_[b].first; t < tiles_[b].end; ++t) {
      const Lanes<Real>* columns = store.tile(static_cast<std::size_t>(t));
      for (int l = 0; l < store.tiles[static_cast<std::size_t>(t)].count; ++l) {
        Vector3& x = position_[static_cast<std::size_t>(identity_of<Real>(columns, l) - first_identity_)];
        for (std::size_t d = 0; d < 3; ++d)
          x[d] = origin[d] + geometry.dx() * static_cast<double>(columns[k_position_column + static_cast<int>(d)][l]);
      }
    }
  });
  const auto chunks_of = [](const Elements& elements) { return (elements.padded() / W + k_chunk - 1) / k_chunk; };
  const std::size_t triangle_chunks = chunks_of(triangles_), chunks = triangle_chunks + chunks_of(hinges_);
  partial_.assign(chunks, {});
  for_each_parallel(chunks, 1, [&](std::size_t c) {
    const bool of_triangles = c < triangle_chunks;
    const std::size_t begin = (of_triangles ? c : c - triangle_chunks) * k_chunk * W;
    const std::size_t end = std::min(begin + k_chunk * W, (of_triangles ? triangles_ : hinges_).padded());
    SkinSums* sums = sums_wanted ? &partial_[c] : nullptr;
    for (std::size_t first = begin; first < end; first += W) of_triangles ? act_triangles(first, sums) : act_hinges(first, sums);
  });
  for_each_parallel(vertices(), 1024, [&](std::size_t v) {
    Real sum[3] = {};
    for (std::size_t slot = first_slot_[v]; slot < first_slot_[v + 1]; ++slot)
      for (std::size_t i = 0; i < 3; ++i) sum[i] += slots_[3 * slot + i];
    std::copy(sum, sum + 3, &force_[3 * v]);
  });
  if (!sums_wanted) return;
  sums_ = {};
  for (const SkinSums& p : partial_) sums_.membrane += p.membrane, sums_.bending += p.bending, sums_.area += p.area;
}

template <class Real>
std::vector<SkinVertexState> Sheets<Real>::vertex_states() const {
  struct Parts {
    double area = 0, rest_area = 0, bent_2 = 0, weight = 0;
  };
  std::vector<Parts> parts(vertices());
  std::size_t first = 0;
  for (const SurfaceMesh& mesh : meshes_) {
    const auto now = [&](std::int32_t v) { return position_[first + static_cast<std::size_t>(v)]; };
    const auto then = [&](std::int32_t v) { return mesh.points[static_cast<std::size_t>(v)]; };
    const auto left = [&](std::int32_t v) { return is_left_[first + static_cast<std::size_t>(v)] != 0; };
    for (const SurfaceTriangle& t : mesh.triangles) {
      if (!left(t[0]) || !left(t[1]) || !left(t[2])) continue;
      const double area = length(cross(now(t[1]) - now(t[0]), now(t[2]) - now(t[0]))) / 2;
      for (const std::int32_t v : t) {
        parts[first + static_cast<std::size_t>(v)].area += area;
        parts[first + static_cast<std::size_t>(v)].rest_area += area_of(mesh, t);
      }
    }
    for (const SurfaceHinge& h : hinges_of(mesh.triangles)) {
      if (!left(h.edge[0]) || !left(h.edge[1]) || !left(h.tips[0]) || !left(h.tips[1])) continue;
      const auto angle = [&](auto at) { return angle_between(at(h.edge[0]), at(h.edge[1]), at(h.tips[0]), at(h.tips[1])); };
      const Vector3 e = then(h.edge[1]) - then(h.edge[0]);
      const double areas = (length(cross(e, then(h.tips[0]) - then(h.edge[0]))) + length(cross(e, then(h.tips[1]) - then(h.edge[0])))) / 2;
      const double bent = angle(now) - angle(then);
      for (const std::int32_t v : h.edge) {
        parts[first + static_cast<std::size_t>(v)].bent_2 += dot(e, e) / areas * bent * bent;
        parts[first + static_cast<std::size_t>(v)].weight += areas / 3;
      }
    }
    first += mesh.points.size();
  }
  std::vector<SkinVertexState> states(vertices());
  for (std::size_t v = 0; v < states.size(); ++v) {
    const Parts& p = parts[v];
    states[v] = {p.rest_area > 0 ? p.area / p.rest_area : 0, p.weight > 0 ? std::sqrt(p.bent_2 / p.weight) : 0};
  }
  return states;
}

template <class Real>
void Sheets<Real>::write(CheckpointWriter& out) const {
  std::vector<double> points;
  std::vector<std::int32_t> triangles;
  std::vector<std::int64_t> counts{first_identity_};
  for (const SurfaceMesh& mesh : meshes_) {
    for (const Point& x : mesh.points) points.insert(points.end(), x.begin(), x.end());
    for (const SurfaceTriangle& t : mesh.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
    counts.push_back(static_cast<std::int64_t>(mesh.points.size()));
    counts.push_back(static_cast<std::int64_t>(mesh.triangles.size()));
  }
  out.add("skin_points", std::span<const double>(points));
  out.add("skin_triangles", std::span<const std::int32_t>(triangles));
  out.add("skin_counts", std::span<const std::int64_t>(counts));
  std::vector<double> places;  // also of vertices that have left, which frames go on showing where they were last
  for (const Vector3& x : position_) places.insert(places.end(), x.begin(), x.end());
  out.add("skin_places", std::span<const double>(places));
  const double sums[] = {sums_.membrane, sums_.bending, sums_.area};
  out.add("skin_sums", std::span<const double>(sums));
}

template <class Real>
Sheets<Real> Sheets<Real>::read(const Scene& scene, const CheckpointReader& in) {
  const auto points = in.array<double>("skin_points"), places = in.array<double>("skin_places"), sums = in.array<double>("skin_sums");
  const auto triangles = in.array<std::int32_t>("skin_triangles");
  const auto counts = in.array<std::int64_t>("skin_counts");
  const auto expect = [](bool fits) {
    if (!fits) throw InputError("the checkpoint's skins do not fit the scene, allowed: a checkpoint written by the same version");
  };
  expect(counts.size() == 1 + 2 * scene.skins.size() && sums.size() == 3);
  std::vector<SurfaceMesh> meshes;
  std::size_t point = 0, triangle = 0;
  for (std::size_t s = 0; s < scene.skins.size(); ++s) {
    const std::int64_t vertices = counts[1 + 2 * s], faces = counts[2 + 2 * s];
    expect(vertices >= 0 && faces >= 0 && point + 3 * static_cast<std::size_t>(vertices) <= points.size() &&
           triangle + 3 * static_cast<std::size_t>(faces) <= triangles.size());
    SurfaceMesh mesh;
    for (std::int64_t v = 0; v < vertices; ++v, point += 3) mesh.points.push_back({points[point], points[point + 1], points[point + 2]});
    for (std::int64_t t = 0; t < faces; ++t, triangle += 3) {
      mesh.triangles.push_back({triangles[triangle], triangles[triangle + 1], triangles[triangle + 2]});
      for (const std::int32_t v : mesh.triangles.back()) expect(v >= 0 && v < vertices);
    }
    meshes.push_back(std::move(mesh));
  }
  expect(point == points.size() && triangle == triangles.size() && places.size() == points.size());
  Sheets sheets(scene, std::move(meshes), counts[0]);
  for (std::size_t v = 0; v < sheets.position_.size(); ++v) sheets.position_[v] = {places[3 * v], places[3 * v + 1], places[3 * v + 2]};
  sheets.sums_ = {sums[0], sums[1], sums[2]};
  return sheets;
}

template class Sheets<float>;
template class Sheets<double>;

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/tet_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "solver/core/errors.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

/// A face with its sorted vertices and its owner: 4 times the tetrahedron's number plus the opposite corner.
struct FaceEntry {
  std::int32_t middle, largest;
  std::int64_t half;
};

/// All faces, bucket by bucket of their smallest vertex: several times faster than one large sort.
struct FaceBuckets {
  std::vector<std::int64_t> starts;
  std::vector<FaceEntry> entries;
};

Triangle sorted_face(const Tet& tet, int k) {
  Triangle face{tet[k_faces[k][0]], tet[k_faces[k][1]], tet[k_faces[k][2]]};
  std::sort(face.begin(), face.end());
  return face;
}

FaceBuckets face_buckets(const std::vector<Tet>& tets, std::size_t vertices) {
  FaceBuckets buckets{std::vector<std::int64_t>(vertices + 1, 0), std::vector<FaceEntry>(4 * tets.size())};
  for (const Tet& tet : tets)
    for (int k = 0; k < 4; ++k) ++buckets.starts[sorted_face(tet, k)[0] + 1];
  for (std::size_t v = 0; v < vertices; ++v) buckets.starts[v + 1] += buckets.starts[v];
  std::vector<std::int64_t> next(buckets.starts.begin(), buckets.starts.end() - 1);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (int k = 0; k < 4; ++k) {
      const Triangle face = sorted_face(tets[t], k);
      buckets.entries[next[face[0]]++] = {face[1], face[2], static_cast<std::int64_t>(4 * t + k)};
    }
  }
  return buckets;
}

double dihedral(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vector3 e = b - a, n1 = cross(e, c - a), n2 = cross(e, d - a);
  return std::acos(std::clamp(dot(n1, n2) / (length(n1) * length(n2)), -1.0, 1.0)) * 180 / M_PI;
}

double least_dihedral(const std::vector<Point>& x, const Tet& t) {
  constexpr int k_edges[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
  double least = 180;
  for (const auto& e : k_edges) least = std::min(least, dihedral(x[t[e[0]]], x[t[e[1]]], x[t[e[2]]], x[t[e[3]]]));
  return least;
}

double relative_spread(const std::vector<double>& values) {
  if (values.empty()) return 0;
  double mean = 0, square = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) square += (v - mean) * (v - mean) / static_cast<double>(values.size());
  return std::sqrt(square) / mean;
}

}  // namespace

double tet_volume(const Point& a, const Point& b, const Point& c, const Point& d) { return dot(b - a, cross(c - a, d - a)) / 6; }

double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const Tet& tet : mesh.tets) sum += tet_volume(mesh.points, tet);
  return sum;
}

std::vector<double> vertex_volumes(const TetMesh& mesh) {
  std::vector<double> volumes(mesh.points.size(), 0);
  for (const Tet& tet : mesh.tets)
    for (const std::int32_t v : tet) volumes[v] += tet_volume(mesh.points, tet) / 4;
  return volumes;
}

std::vector<Tet> tet_neighbours(const std::vector<Tet>& tets, std::size_t vertices) {
  FaceBuckets buckets = face_buckets(tets, vertices);
  std::vector<Tet> neighbours(tets.size(), Tet{-1, -1, -1, -1});
  const auto link = [&](std::int64_t a, std::int64_t b) {
    neighbours[a / 4][a % 4] = static_cast<std::int32_t>(b / 4);
    neighbours[b / 4][b % 4] = static_cast<std::int32_t>(a / 4);
  };
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto first = buckets.entries.begin() + buckets.starts[v], last = buckets.entries.begin() + buckets.starts[v + 1];
    std::sort(first, last, [](const FaceEntry& a, const FaceEntry& b) {
      return std::tie(a.middle, a.largest, a.half) < std::tie(b.middle, b.largest, b.half);
    });
    const auto same = [](const FaceEntry& a, const FaceEntry& b) { return a.middle == b.middle && a.largest == b.largest; };
    for (auto f = first; f != last; ++f) {
      if (f + 1 == last || !same(f[0], f[1])) continue;
      if (f + 2 != last && same(f[0], f[2]))
        throw InputError(fmt::format("three tetrahedra share the face of vertices {}, {} and {}, allowed: two", v, f->middle, f->largest));
      link(f[0].half, f[1].half);
      ++f;
    }
  }
  return neighbours;
}

std::vector<Triangle> boundary_triangles(const std::vector<Tet>& tets, const std::vector<Tet>& neighbours) {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (int k = 0; k < 4; ++k)
      if (neighbours[t][k] < 0) triangles.push_back({tets[t][k_faces[k][0]], tets[t][k_faces[k][1]], tets[t][k_faces[k][2]]});
  return triangles;
}

std::size_t count_odd_edges(const std::vector<Triangle>& triangles) {
  std::vector<std::tuple<std::int32_t, std::int32_t, int>> edges;  // by vertices in rising order; +1 forwards, -1 backwards
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end());
  std::size_t odd = 0;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    int sum = 0;
    for (j = i; j < edges.size() && std::get<0>(edges[j]) == std::get<0>(edges[i]) && std::get<1>(edges[j]) == std::get<1>(edges[i]); ++j)
      sum += std::get<2>(edges[j]);
    odd += j - i != 2 || sum != 0;
  }
  return odd;
}

TetQuality tet_quality(const TetMesh& mesh) {
  const std::vector<Triangle> boundary = boundary_triangles(mesh.tets, tet_neighbours(mesh.tets, mesh.points.size()));
  std::vector<char> outer(mesh.points.size(), 0), used(mesh.points.size(), 0);
  for (const Triangle& t : boundary)
    for (const std::int32_t v : t) outer[v] = 1;
  TetQuality quality;
  quality.volume = volume(mesh);
  quality.least_angle = 180;
  for (const Tet& tet : mesh.tets) {
    for (const std::int32_t v : tet) used[v] = 1;
    quality.least_angle = std::min(quality.least_angle, least_dihedral(mesh.points, tet));
  }
  const std::vector<double> volumes = vertex_volumes(mesh);
  std::vector<double> inner;
  for (std::size_t v = 0; v < volumes.size(); ++v)
    if (used[v] && !outer[v]) inner.push_back(volumes[v]);
  quality.inner_spread = relative_spread(inner);
  quality.boundary = static_cast<std::size_t>(std::count(outer.begin(), outer.end(), 1));
  quality.loose = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  quality.odd_edges = count_odd_edges(boundary);
  return quality;
}

Mesh to_particles_mesh(const TetMesh& tets) {
  Mesh mesh;
  mesh.corners = 4;
  for (const Point& x : tets.points) mesh.points.insert(mesh.points.end(), x.begin(), x.end());
  for (const Tet& tet : tets.tets) mesh.cells.insert(mesh.cells.end(), tet.begin(), tet.end());
  mesh.fields.push_back({"volume", "m^3", 1, vertex_volumes(tets)});
  return mesh;
}

TetMesh to_tet_mesh(const Mesh& mesh) {
  if (mesh.corners != 4) throw InputError("found triangles, allowed: tetrahedra as `bake-mesh tets` writes them");
  TetMesh tets;
  tets.points.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < tets.points.size(); ++v)
    tets.points[v] = {mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2]};
  tets.tets.resize(mesh.cell_count());
  for (std::size_t t = 0; t < tets.tets.size(); ++t) {
    for (int k = 0; k < 4; ++k) tets.tets[t][k] = static_cast<std::int32_t>(mesh.cells[4 * t + k]);
    if (!(tet_volume(tets.points, tets.tets[t]) > 0)) throw InputError(fmt::format("tetrahedron {} has no positive volume", t));
  }
  return tets;
}

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/solid/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "solver/core/vector3.h"

namespace bake {

bool has_sharp_edges(const TriangleMesh& mesh) {
  std::vector<std::tuple<std::int32_t, std::int32_t, std::int32_t>> edges;  // with the triangle
  std::vector<Vector3> normals;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corner = mesh.triangles[t];
    const Point& a = mesh.points[corner[0]];
    normals.push_back(unit(cross(mesh.points[corner[1]] - a, mesh.points[corner[2]] - a)));
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corner[k], corner[(k + 1) % 3]);
      edges.emplace_back(low, high, static_cast<std::int32_t>(t));
    }
  }
  std::sort(edges.begin(), edges.end());
  const double least = std::cos(k_sharp_deg * M_PI / 180);
  for (std::size_t e = 0; e + 1 < edges.size(); e += 2)  // closed: every edge comes twice
    if (dot(normals[std::get<2>(edges[e])], normals[std::get<2>(edges[e + 1])]) < least) return true;
  return false;
}

double enclosed_volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += tet_volume(mesh.points[0], mesh.points[a], mesh.points[b], mesh.points[c]);
  return sum;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += 0.5 * length(cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
  return sum;
}

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/census.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "solver/core/union_find.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

std::int32_t an_owner(const CutNode& node) {
  int i = 0;
  while (!node.owns(i)) ++i;
  return node.vertices[i];
}

/// Gives nodes at one place on different sides the same number; since nodes are sorted by vertices first, they are neighbours.
std::vector<std::int32_t> first_of_place(const CutSurface& surface) {
  std::vector<std::int32_t> first(surface.nodes.size());
  for (std::size_t n = 0; n < first.size(); ++n)
    first[n] = n > 0 && surface.nodes[n].vertices == surface.nodes[n - 1].vertices ? first[n - 1] : static_cast<std::int32_t>(n);
  return first;
}

/// Sums over the triangles of a crack.
struct CrackSums {
  Crack crack;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< moment of area about the origin
  std::vector<std::int32_t> triangles;
};

/// Edges have their node in the middle.
std::vector<std::array<std::int32_t, 2>> edges_cut(const std::vector<std::int32_t>& triangles, const CutSurface& surface) {
  std::vector<std::array<std::int32_t, 2>> edges;
  for (const std::int32_t t : triangles)
    for (const std::int32_t n : surface.triangles[t])
      if (const CutNode& node = surface.nodes[n]; node.size() == 2) edges.push_back({node.vertices[0], node.vertices[1]});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double extent(const CrackSums& sums, const CutSurface& surface, const std::vector<Point>& points) {
  const Eigen::Vector3d c(sums.crack.centre_m[0], sums.crack.centre_m[1], sums.crack.centre_m[2]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(sums.second - sums.crack.area_m2 * c * c.transpose());
  const Eigen::Vector3d longest = axes.eigenvectors().col(2);
  double low = k_infinity, high = -k_infinity;
  for (const std::int32_t t : sums.triangles)
    for (const std::int32_t n : surface.triangles[t]) {
      const double along = longest.dot(Eigen::Vector3d(points[n][0], points[n][1], points[n][2]));
      low = std::min(low, along);
      high = std::max(high, along);
    }
  return high - low;
}

void add(CrackSums& sums, const Point& a, const Point& b, const Point& c) {
  Crack& crack = sums.crack;
  if (crack.area_m2 == 0 && sums.triangles.empty()) crack.low_m = crack.high_m = a;
  const double area = 0.25 * length(cross(b - a, c - a));  // half, because both sides are visited
  crack.area_m2 += area;
  for (const Point& x : {a, b, c}) {
    crack.centre_m = crack.centre_m + area / 3 * x;  // later divided by the area
    const Eigen::Vector3d y(x[0], x[1], x[2]);
    sums.second += area / 3 * y * y.transpose();
    for (int i = 0; i < 3; ++i) {
      crack.low_m[i] = std::min(crack.low_m[i], x[i]);
      crack.high_m[i] = std::max(crack.high_m[i], x[i]);
    }
  }
}

}  // namespace

std::vector<Crack> cracks(const CutSurface& surface, const std::vector<Point>& points) {
  const std::vector<std::int32_t> place = first_of_place(surface);
  UnionFind sets(surface.nodes.size());
  for (std::size_t t = surface.skin_triangles; t < surface.triangles.size(); ++t)
    for (const std::int32_t n : surface.triangles[t]) sets.unite(place[n], place[surface.triangles[t][0]]);
  std::map<std::int32_t, CrackSums> all;
  for (std::size_t t = surface.skin_triangles; t < surface.triangles.size(); ++t) {
    const Triangle& corner = surface.triangles[t];
    CrackSums& sums = all[sets.find(place[corner[0]])];
    add(sums, points[corner[0]], points[corner[1]], points[corner[2]]);
    sums.triangles.push_back(static_cast<std::int32_t>(t));
  }
  std::vector<Crack> result;
  for (auto& [root, sums] : all) {
    if (sums.crack.area_m2 > 0) sums.crack.centre_m = 1 / sums.crack.area_m2 * sums.crack.centre_m;
    sums.crack.length_m = extent(sums, surface, points);
    sums.crack.edges = edges_cut(sums.triangles, surface);
    result.push_back(sums.crack);
  }
  std::stable_sort(result.begin(), result.end(), [](const Crack& a, const Crack& b) { return a.area_m2 > b.area_m2; });
  return result;
}

std::vector<std::int32_t> without_specks(const Topology& topology, std::vector<std::int32_t> broken_at, const std::vector<Crack>& cracks,
                                         double smallest_m2) {
  for (const Crack& crack : cracks) {
    if (crack.area_m2 >= smallest_m2) continue;
    for (const auto& edge : crack.edges) {
      const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), edge);
      broken_at[static_cast<std::size_t>(found - topology.edges.begin())] = -1;
    }
  }
  return broken_at;
}

std::vector<Piece> take_census(const CutSurface& surface, const std::vector<std::int32_t>& piece_of, const std::vector<Point>& points) {
  std::vector<Piece> result(piece_of.empty() ? 0 : 1 + *std::max_element(piece_of.begin(), piece_of.end()));
  for (const std::int32_t piece : piece_of) ++result[piece].vertices;

  // Volumes are measured from a point of the piece, so that little cancels.
  std::vector<const Point*> origin(result.size(), nullptr);
  std::vector<std::array<std::int32_t, 2>> edges, opposite;
  for (const Triangle& t : surface.triangles) {
    const std::int32_t piece = piece_of[an_owner(surface.nodes[t[0]])];
    if (origin[piece] == nullptr) origin[piece] = &points[t[0]];
    result[piece].volume_m3 += dot(points[t[0]] - *origin[piece], cross(points[t[1]] - *origin[piece], points[t[2]] - *origin[piece])) / 6;
    for (int i = 0; i < 3; ++i) {
      edges.push_back({t[i], t[(i + 1) % 3]});
      opposite.push_back({t[(i + 1) % 3], t[i]});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  std::vector<std::array<std::int32_t, 2>> unmatched;
  std::set_symmetric_difference(edges.begin(), edges.end(), opposite.begin(), opposite.end(), std::back_inserter(unmatched));
  for (const auto& edge : unmatched) result[piece_of[an_owner(surface.nodes[edge[0]])]].closed = false;
  return result;
}

}  // namespace bake

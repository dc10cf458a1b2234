// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/material_shape.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "solver/core/vector3.h"

namespace bake {
namespace {

using PointNumbers = std::vector<std::int32_t>;  ///< for each node the number of its point: nodes on several sides share one

/// Numbers the points. Nodes are sorted by their vertices first, so that those of one point follow each other.
PointNumbers places_of(const CutSurface& surface, std::size_t& count) {
  PointNumbers places(surface.nodes.size());
  count = 0;
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (n == 0 || surface.nodes[n].vertices != surface.nodes[n - 1].vertices) ++count;
    places[n] = static_cast<std::int32_t>(count) - 1;
  }
  return places;
}

/// The neighbours of each point in cracks, as one list and the start of each point's part.
struct Neighbours {
  std::vector<std::int64_t> starts;
  std::vector<std::int32_t> list;
};

Neighbours crack_neighbours(const CutSurface& surface, const PointNumbers& places, std::size_t count) {
  std::vector<char> on_skin(count, 0);
  for (std::size_t t = 0; t < surface.skin_triangles; ++t)
    for (const std::int32_t n : surface.triangles[t]) on_skin[places[n]] = 1;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  // Triangles of cracks come as the halves (m, f, c), (m, c, f') of quadrilaterals, whose diagonal mc is no edge.
  const auto add = [&](std::int32_t n, std::int32_t other) {
    const std::int32_t a = places[n], b = places[other];
    if (!on_skin[a] || on_skin[b]) pairs.push_back({a, b});
    if (!on_skin[b] || on_skin[a]) pairs.push_back({b, a});
  };
  for (std::size_t t = surface.skin_triangles; t + 1 < surface.triangles.size(); t += 2) {
    const auto& [m, f, c] = surface.triangles[t];
    const std::int32_t f2 = surface.triangles[t + 1][2];
    add(m, f);
    add(f, c);
    add(c, f2);
    add(f2, m);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Neighbours neighbours{std::vector<std::int64_t>(count + 1, 0), {}};
  for (const auto& [a, b] : pairs) {
    ++neighbours.starts[a + 1];
    neighbours.list.push_back(b);
  }
  std::partial_sum(neighbours.starts.begin(), neighbours.starts.end(), neighbours.starts.begin());
  return neighbours;
}

/// The shares of the point of an edge, face or tetrahedron that is nearest to x, none smaller than allowed.
std::array<double, 4> clamped_shares(const std::vector<Point>& points, const CutNode& node, const Point& x) {
  const int size = node.size();
  const Point& origin = points[node.vertices[0]];
  Eigen::Matrix3d square = Eigen::Matrix3d::Identity();  // rows of sides that are not there say 0 = 0
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  for (int i = 1; i < size; ++i) {
    const Vector3 side = points[node.vertices[i]] - origin;
    along[i - 1] = dot(side, x - origin);
    for (int j = 1; j < size; ++j) square(i - 1, j - 1) = dot(side, points[node.vertices[j]] - origin);
  }
  const Eigen::Vector3d inner = square.inverse() * along;
  std::array<double, 4> shares{};
  shares[0] = 1 - inner.sum();
  for (int i = 1; i < size; ++i) shares[i] = inner[i - 1];
  const double least = size == 2 ? 0.2 : 0.1;
  double beyond = 0;  // sum of what exceeds the least
  for (int i = 0; i < size; ++i) beyond += shares[i] = std::max(shares[i] - least, 0.0);
  for (int i = 0; i < size; ++i) shares[i] = least + shares[i] * (1 - size * least) / beyond;
  return shares;
}

Point at_shares(const std::vector<Point>& points, const CutNode& node, const std::array<double, 4>& shares) {
  Point x{0, 0, 0};
  for (int i = 0; i < node.size(); ++i) x = x + shares[i] * points[node.vertices[i]];
  return x;
}

}  // namespace

MaterialShape material_shape(const Topology& topology, const CutSurface& surface, int passes) {
  std::size_t count = 0;
  const PointNumbers places = places_of(surface, count);
  std::vector<const CutNode*> node_at(count);
  for (std::size_t n = 0; n < places.size(); ++n) node_at[places[n]] = &surface.nodes[n];
  const std::vector<Point>& vertices = topology.mesh.points;
  std::vector<std::array<double, 4>> shares(count);
  std::vector<Point> points(count);
  for (std::size_t p = 0; p < count; ++p) {
    for (int i = 0; i < node_at[p]->size(); ++i) shares[p][i] = 1.0 / node_at[p]->size();
    points[p] = at_shares(vertices, *node_at[p], shares[p]);
  }
  const Neighbours neighbours = crack_neighbours(surface, places, count);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Point> before = points;
    for (std::size_t p = 0; p < count; ++p) {
      const auto first = neighbours.starts[p], last = neighbours.starts[p + 1];
      if (first == last) continue;
      Point mean{0, 0, 0};
      for (auto i = first; i < last; ++i) mean = mean + 1.0 / static_cast<double>(last - first) * before[neighbours.list[i]];
      shares[p] = clamped_shares(vertices, *node_at[p], 0.5 * (before[p] + mean));
      points[p] = at_shares(vertices, *node_at[p], shares[p]);
    }
  }
  MaterialShape shape;
  for (const std::int32_t p : places) {
    shape.shares.push_back(shares[p]);
    shape.points.push_back(points[p]);
  }
  return shape;
}

}  // namespace bake

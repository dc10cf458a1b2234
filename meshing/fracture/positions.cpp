// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/positions.h"

#include <Eigen/Dense>
#include <algorithm>

#include "solver/core/vector3.h"

namespace bake {
namespace {

Eigen::Vector3d eigen(const Vector3& a) { return {a[0], a[1], a[2]}; }

/// Sums over the whole edges at a vertex: A = sum of dx dX^T, B = sum of dX dX^T.
struct EdgeSums {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d b = Eigen::Matrix3d::Zero();
};

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& a) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

Eigen::Matrix3d best_map(const EdgeSums& sums) {
  constexpr double k_worst_condition = 1e3, k_least_stretch = 0.4, k_largest_stretch = 2.5;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(sums.b);
  if (!(spread.eigenvalues()[2] > 0)) return Eigen::Matrix3d::Identity();  // a particle without whole edges
  if (spread.eigenvalues()[0] * k_worst_condition > spread.eigenvalues()[2]) {
    const Eigen::Matrix3d map = sums.a * sums.b.inverse();
    const Eigen::Vector3d stretch = map.jacobiSvd().singularValues();
    if (stretch[2] > k_least_stretch && stretch[0] < k_largest_stretch && map.determinant() > 0) return map;
  }
  // If the edges do not determine the rotation (about a single edge, for instance), the added identity chooses the smallest.
  return nearest_rotation(sums.a + 1e-6 * spread.eigenvalues()[2] * Eigen::Matrix3d::Identity());
}

/// For the owners of nodes that are not whole the map G_a; `index` holds the place of each vertex in `maps`, or -1.
struct Maps {
  std::vector<std::int32_t> index;
  std::vector<Eigen::Matrix3d> maps;
};

Maps fit_maps(const Topology& topology, const CutSurface& surface, const std::vector<std::int32_t>& broken_at,
              const std::vector<Point>& positions) {
  const std::vector<Point>& rest = topology.mesh.points;
  Maps result{std::vector<std::int32_t>(rest.size(), -1), {}};
  std::int32_t count = 0;
  for (const CutNode& node : surface.nodes) {
    if (node.owns_all()) continue;
    for (int i = 0; i < node.size(); ++i)
      if (node.owns(i) && result.index[node.vertices[i]] < 0) result.index[node.vertices[i]] = count++;
  }
  std::vector<EdgeSums> sums(count);
  for (std::size_t e = 0; count > 0 && e < topology.edges.size(); ++e) {
    const auto [a, b] = topology.edges[e];
    if (broken_at[e] >= 0 || (result.index[a] < 0 && result.index[b] < 0)) continue;
    const Eigen::Vector3d before = eigen(rest[b] - rest[a]), now = eigen(positions[b] - positions[a]);
    for (const std::int32_t v : {a, b}) {
      if (result.index[v] < 0) continue;
      sums[result.index[v]].a += now * before.transpose();
      sums[result.index[v]].b += before * before.transpose();
    }
  }
  result.maps.reserve(sums.size());
  for (const EdgeSums& sum : sums) result.maps.push_back(best_map(sum));
  return result;
}

/// The frame at which an edge between two vertices broke: edges are sorted.
std::int32_t frame_of_break(const Topology& topology, const std::vector<std::int32_t>& broken_at, std::int32_t a, std::int32_t b) {
  const std::array<std::int32_t, 2> key{a, b};
  return broken_at[std::lower_bound(topology.edges.begin(), topology.edges.end(), key) - topology.edges.begin()];
}

/// The frame at which the last edge between a node's owners and its other vertices broke.
std::int32_t frame_of_parting(const Topology& topology, const std::vector<std::int32_t>& broken_at, const CutNode& node) {
  std::int32_t last = -1;
  for (int i = 0; i < node.size(); ++i)
    for (int j = i + 1; j < node.size(); ++j)
      if (node.owns(i) != node.owns(j)) last = std::max(last, frame_of_break(topology, broken_at, node.vertices[i], node.vertices[j]));
  return last;
}

}  // namespace

std::vector<Point> node_positions(const Topology& topology, const CutSurface& surface, const MaterialShape& shape,
                                  const std::vector<std::int32_t>& broken_at, int frame, const std::vector<Point>& positions) {
  constexpr double k_opening_frames = 4;
  const Maps maps = fit_maps(topology, surface, broken_at, positions);
  std::vector<Point> result(surface.nodes.size());
  for (std::size_t n = 0; n < result.size(); ++n) {
    const CutNode& node = surface.nodes[n];
    Point together{0, 0, 0};
    for (int i = 0; i < node.size(); ++i) together = together + shape.shares[n][i] * positions[node.vertices[i]];
    result[n] = together;
    if (node.owns_all()) continue;
    Eigen::Vector3d parted = Eigen::Vector3d::Zero();
    double sum = 0;
    for (int i = 0; i < node.size(); ++i) {
      if (!node.owns(i)) continue;
      const std::int32_t a = node.vertices[i];
      const Eigen::Vector3d from = eigen(shape.points[n] - topology.mesh.points[a]);
      parted += shape.shares[n][i] * (eigen(positions[a]) + maps.maps[maps.index[a]] * from);
      sum += shape.shares[n][i];
    }
    const double open = std::clamp((frame - frame_of_parting(topology, broken_at, node)) / k_opening_frames, 0.0, 1.0);
    for (int k = 0; k < 3; ++k) result[n][k] = (1 - open) * together[k] + open * parted[k] / sum;
  }
  return result;
}

std::vector<double> node_values(const CutSurface& surface, const MaterialShape& shape, const std::vector<float>& values,
                                std::size_t components) {
  std::vector<double> result(components * surface.nodes.size());
  for (std::size_t n = 0; n < surface.nodes.size(); ++n) {
    const CutNode& node = surface.nodes[n];
    double sum = 0;
    for (int i = 0; i < node.size(); ++i) sum += node.owns(i) ? shape.shares[n][i] : 0;
    for (int i = 0; i < node.size(); ++i)
      for (std::size_t c = 0; node.owns(i) && c < components; ++c)
        result[components * n + c] += shape.shares[n][i] / sum * values[components * node.vertices[i] + c];
  }
  return result;
}

}  // namespace bake

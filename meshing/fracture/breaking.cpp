// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/breaking.h"

#include <algorithm>
#include <cmath>

#include "solver/core/union_find.h"
#include "solver/core/vector3.h"

namespace bake {

Breaking::Breaking(const Topology& topology, const std::vector<Point>& reference, const BreakingRule& rule)
    : topology_(topology),
      void_ratio_(rule.void_ratio),
      limits_(topology.edges.size()),
      beyond_(topology.edges.size(), 0),
      broken_at_(topology.edges.size(), -1) {
  for (std::size_t e = 0; e < limits_.size(); ++e) {
    const auto [a, b] = topology.edges[e];
    const double limit = std::max(rule.stretch * length(reference[a] - reference[b]), rule.smallest_gap_m);
    limits_[e] = static_cast<float>(limit * limit);
  }
  if (void_ratio_ > 0)
    for (const Tet& tet : topology.mesh.tets) tet_volumes_.push_back(std::abs(tet_volume(reference, tet)));
}

std::vector<double> Breaking::voids(const std::vector<Point>& positions, const std::vector<double>& growth) const {
  std::vector<double> voids(topology_.edges.size(), 0);
  for (std::size_t t = 0; t < tet_volumes_.size(); ++t) {
    const Tet& tet = topology_.mesh.tets[t];
    const double mean_growth = (growth[tet[0]] + growth[tet[1]] + growth[tet[2]] + growth[tet[3]]) / 4;
    const double more = std::abs(tet_volume(positions, tet)) - void_ratio_ * mean_growth * tet_volumes_[t];
    for (const std::int32_t e : topology_.tet_edges[t]) voids[e] += more;
  }
  return voids;
}

void Breaking::advance(int frame, const std::vector<Point>& positions, const std::vector<double>& growth) {
  const std::vector<double> void_at = void_ratio_ > 0 ? voids(positions, growth) : std::vector<double>{};
  for (std::size_t e = 0; e < limits_.size(); ++e) {
    const auto [a, b] = topology_.edges[e];
    const Vector3 between = positions[a] - positions[b];
    const bool beyond = dot(between, between) > limits_[e] && (void_at.empty() || void_at[e] > 0);
    if (beyond && beyond_[e] && broken_at_[e] < 0) broken_at_[e] = frame;
    beyond_[e] = beyond;
  }
}

std::vector<std::int32_t> pieces(const Topology& topology, const std::vector<std::int32_t>& broken_at) {
  const std::size_t vertices = topology.mesh.points.size();
  UnionFind sets(vertices);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (broken_at[e] < 0) sets.unite(topology.edges[e][0], topology.edges[e][1]);

  std::vector<std::int32_t> roots, sizes(vertices, 0), numbers(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::int32_t root = sets.find(static_cast<std::int32_t>(v));
    if (sizes[root]++ == 0) roots.push_back(root);
  }
  std::stable_sort(roots.begin(), roots.end(), [&](std::int32_t a, std::int32_t b) { return sizes[a] > sizes[b]; });
  for (std::size_t i = 0; i < roots.size(); ++i) numbers[roots[i]] = static_cast<std::int32_t>(i);
  std::vector<std::int32_t> piece(vertices);
  for (std::size_t v = 0; v < vertices; ++v) piece[v] = numbers[sets.find(static_cast<std::int32_t>(v))];
  return piece;
}

}  // namespace bake

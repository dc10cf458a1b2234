// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/breaking.h"

#include <algorithm>
#include <numeric>

#include "meshing/union_find.h"
#include "solver/core/vector3.h"

namespace bake {

Breaking::Breaking(const Topology& topology, const std::vector<Point>& reference, const BreakingRule& rule)
    : topology_(topology), limits_(topology.edges.size()), beyond_(topology.edges.size(), 0), broken_at_(topology.edges.size(), -1) {
  for (std::size_t e = 0; e < limits_.size(); ++e) {
    const auto [a, b] = topology.edges[e];
    const double limit = std::max(rule.stretch * length(reference[a] - reference[b]), rule.smallest_gap_m);
    limits_[e] = static_cast<float>(limit * limit);
  }
}

void Breaking::advance(int frame, const std::vector<Point>& positions) {
  for (std::size_t e = 0; e < limits_.size(); ++e) {
    const auto [a, b] = topology_.edges[e];
    const Vector3 between = positions[a] - positions[b];
    const bool beyond = dot(between, between) > limits_[e];
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

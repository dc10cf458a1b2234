// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/topology.h"

#include <algorithm>
#include <numeric>

namespace bake {
namespace {

/// One edge of one tetrahedron: its larger vertex, and 6 times the tetrahedron's number plus the edge's number in it.
struct EdgeEntry {
  std::int32_t larger;
  std::int64_t place;
};

void number_edges(Topology& topology) {
  const auto& tets = topology.mesh.tets;
  const std::size_t vertices = topology.mesh.points.size();
  std::vector<std::int64_t> starts(vertices + 1, 0);
  const auto for_edges = [&](auto visit) {
    for (std::size_t t = 0; t < tets.size(); ++t)
      for (int e = 0; e < 6; ++e) {
        const auto [a, b] = std::minmax(tets[t][k_tet_edges[e].a], tets[t][k_tet_edges[e].b]);
        visit(a, EdgeEntry{b, static_cast<std::int64_t>(6 * t + e)});
      }
  };
  for_edges([&](std::int32_t a, const EdgeEntry&) { ++starts[a + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<EdgeEntry> entries(6 * tets.size());
  std::vector<std::int64_t> next(starts.begin(), starts.end() - 1);
  for_edges([&](std::int32_t a, const EdgeEntry& entry) { entries[next[a]++] = entry; });

  topology.tet_edges.resize(tets.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto first = entries.begin() + starts[v], last = entries.begin() + starts[v + 1];
    std::sort(first, last, [](const EdgeEntry& a, const EdgeEntry& b) { return a.larger < b.larger; });
    for (auto entry = first; entry != last; ++entry) {
      if (entry == first || entry->larger != entry[-1].larger) topology.edges.push_back({static_cast<std::int32_t>(v), entry->larger});
      topology.tet_edges[entry->place / 6][entry->place % 6] = static_cast<std::int32_t>(topology.edges.size()) - 1;
    }
  }
}

}  // namespace

Topology make_topology(TetMesh mesh) {
  Topology topology;
  topology.mesh = std::move(mesh);
  const auto& tets = topology.mesh.tets;
  topology.neighbours = tet_neighbours(tets, topology.mesh.points.size());
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (int k = 0; k < 4; ++k)
      if (topology.neighbours[t][k] < 0) topology.boundary.push_back({static_cast<std::int32_t>(t), k});
  number_edges(topology);
  return topology;
}

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts tetrahedra along the surfaces dual to broken edges.
//
// Each tetrahedron consists of four hexahedra, one per corner, which meet at the midpoints of its edges, the centroids of its faces, and
// its own. Two of them are separated if no whole edges of the tetrahedron connect their corners. The quadrilateral between two
// separated hexahedra is crack surface, once for each side. [After Wang et al. 2019; the rules are our own]
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshing/fracture/topology.h"

namespace bake {

/// A vertex of the cut surface: the midpoint of one to four vertices of the mesh, on the side of some of them.
struct CutNode {
  std::array<std::int32_t, 4> vertices{-1, -1, -1,
                                       -1};          ///< one: a vertex, two: of an edge, three: of a face, four: of a tetrahedron; rising
  std::int32_t owners = 1;                           ///< bit i: vertices[i] is on this side
  auto operator<=>(const CutNode&) const = default;  ///< identifies a node in all frames

  int size() const { return vertices[1] < 0 ? 1 : vertices[2] < 0 ? 2 : vertices[3] < 0 ? 3 : 4; }
  bool owns(int i) const { return (owners >> i & 1) != 0; }
  bool owns_all() const { return owners == (1 << size()) - 1; }
};

struct CutSurface {
  std::vector<CutNode> nodes;       ///< sorted
  std::vector<Triangle> triangles;  ///< of nodes, counter-clockwise from outside; those of the original surface first
  std::size_t skin_triangles = 0;   ///< how many those are
};

/// The closed surface of all pieces, made of the boundary of the mesh and both sides of every crack. `broken_at`: for each edge the frame
/// at which it broke, -1 if it is whole. Tetrahedra that are not cut cost one look each.
CutSurface cut(const Topology& topology, const std::vector<std::int32_t>& broken_at);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
// The reference mesh of a fracture: its tetrahedra, edges and faces as flat arrays, made once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// The edge between corners a and b of a tetrahedron; c and d are the others, so that (a, b, c, d) is an even permutation.
struct TetEdge {
  int a, b, c, d;
};
inline constexpr std::array<TetEdge, 6> k_tet_edges{{{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
/// Number in k_tet_edges of the edge between two corners.
inline constexpr std::array<std::array<int, 4>, 4> k_edge_between{{{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};

struct BoundaryFace {
  std::int32_t tet;
  std::int32_t corner;  ///< opposite to the face
};

struct Topology {
  TetMesh mesh;
  std::vector<Tet> neighbours;                         ///< behind the face opposite to each corner; -1: none
  std::vector<std::array<std::int32_t, 2>> edges;      ///< vertices, in rising order
  std::vector<std::array<std::int32_t, 6>> tet_edges;  ///< the edges of each tetrahedron in the order of k_tet_edges
  std::vector<BoundaryFace> boundary;
};

/// Throws InputError if more than two tetrahedra share a face.
Topology make_topology(TetMesh mesh);

}  // namespace bake

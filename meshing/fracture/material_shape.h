// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/fracture/cut.h"

namespace bake {

/// The position of each node of a cut surface in the reference mesh, as shares of its vertices.
struct MaterialShape {
  std::vector<std::array<double, 4>> shares;  ///< add up to 1
  std::vector<Point> points;                  ///< [m]
};

/// Nodes start at the means of their vertices. Then the nodes of cracks move `passes` times half the way to the mean of their neighbours in
/// the crack, both sides alike. They stay at least a fifth (edges) or a tenth (faces, tetrahedra) inside the rim of the edge, face or
/// tetrahedron to which they belong. The volume of all pieces together does not change, and nodes on the original surface stay on it.
MaterialShape material_shape(const Topology& topology, const CutSurface& surface, int passes);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/fracture/cut.h"

namespace bake {

/// Where each node of a cut surface is in the reference mesh, as shares of its vertices.
struct MaterialShape {
  std::vector<std::array<double, 4>> shares;  ///< add up to 1
  std::vector<Point> points;                  ///< [m]
};

/// Nodes at the means of their vertices; then those of cracks go `passes` times half the way to the mean of their neighbours in the
/// crack, the same for both sides, and no farther than a fifth (edges) or a tenth (faces, tetrahedra) of the way from the rim of where
/// they belong: the volume of all pieces together stays what it is. Nodes on the original surface stay on it.
MaterialShape material_shape(const Topology& topology, const CutSurface& surface, int passes);

}  // namespace bake

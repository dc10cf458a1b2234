// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// The largest part of a selection of tetrahedra whose boundary is a manifold surface, and its vertices in the same order. The selected
/// tetrahedra at each vertex and edge must be connected through faces: all but the largest group (by volume) are dropped. Groups without
/// an inner vertex are dropped, too. `kept` has a 1 for each tetrahedron that is selected. Depends on the input alone.
TetMesh manifold_part(const std::vector<Point>& points, const std::vector<Tet>& tets, std::vector<char> kept);

}  // namespace bake

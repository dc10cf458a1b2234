// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// Drops tetrahedra from a selection until its boundary is a manifold surface. The selected tetrahedra at each vertex and edge must be
/// connected through faces: all but the largest group (by volume) are dropped. Groups without an inner vertex are dropped, too.
/// `kept` has a 1 for each tetrahedron that is selected. Depends on the input alone.
void drop_until_manifold(const std::vector<Point>& points, const std::vector<Tet>& tets, const std::vector<Tet>& neighbours,
                         std::vector<char>& kept);

/// The largest part of a selection whose boundary is such a surface, and its vertices in the same order.
TetMesh manifold_part(const std::vector<Point>& points, const std::vector<Tet>& tets, std::vector<char> kept);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// Moves the vertices inside a mesh so that the volumes of all of them come near to `wanted_m3`; those on its boundary, its
/// tetrahedra and its volume stay as they are. Vertices are taken in turn; each goes to where the sum of squares of
/// V_v - wanted over the inner vertices v around it, quadratic in its place, is least, with a pull to where it was at first.
/// No tetrahedron loses more than half of its volume.
void even_volumes(TetMesh& mesh, double wanted_m3);

}  // namespace bake

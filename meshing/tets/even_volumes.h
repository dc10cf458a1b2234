// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// Moves the inner vertices of a mesh so that the volumes of all of them come near to `wanted_m3`. The vertices on the boundary, the
/// tetrahedra and the volume of the mesh do not change. One vertex after the other moves to where the sum of squares of V_v - wanted over
/// the inner vertices v around it is least (it is quadratic in the position), with a pull towards its first position. No tetrahedron loses
/// more than half of its volume.
void even_volumes(TetMesh& mesh, double wanted_m3);

}  // namespace bake

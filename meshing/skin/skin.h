// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshing/solid/triangle_mesh.h"

namespace bake {

/// The surface of a solid as even triangles with edges of about the given length, on its surface, creases kept.
/// `surface`: where to begin; nullptr: with the boundary of lattice tetrahedra. Throws InputError if the length is too large or too
/// small for the solid.
TriangleMesh make_skin(const Shape& solid, const TriangleMesh* surface, double edge_length_m, const Tell& tell = tell_nobody);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshing/solid/triangle_mesh.h"

namespace bake {

/// Covers the surface of a solid with even triangles whose edges have about the given length; creases are kept.
/// `surface`: the triangles from which to start; nullptr: the boundary of lattice tetrahedra. Throws InputError if the length is too large
/// or too small for the solid.
TriangleMesh make_skin(const Shape& solid, const TriangleMesh* surface, double edge_length_m, const Tell& tell = tell_nobody);

}  // namespace bake

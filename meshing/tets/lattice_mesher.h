// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra between the points of a body-centred cubic lattice whose outermost points are moved onto the surface.
//
// The lattice is rotated so that it is aligned with no grid of the simulation. It has no cospherical ties, and all its vertices have the
// same volume. Points within half a neighbour distance of the surface go to their foot on it, or to a crease or corner if one is near
// [cf. Labelle, Shewchuk 2007, "Isosurface stuffing"]; of the Delaunay tetrahedra those inside are kept. That leaves the vertices of the
// next layer with volumes that differ by a tenth; small moves make them even at last.
#pragma once

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// Volume of a solid [m^3] to about a thousandth, by counting cells; those cut by the surface by the share that is inside.
/// Throws InputError if the solid has no finite bounds or no inside.
double solid_volume(const Shape& solid);

/// Fills the solid, which has that volume, with `target` vertices, to 1 % or as near as its shape allows. Throws InputError if `target` is
/// too small for a mesh, or if the solid has no finite bounds.
TetMesh lattice_tets(const Shape& solid, double volume_m3, std::size_t target, const Tell& tell = tell_nobody);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// The Delaunay tetrahedra of points, all of positive volume by exact arithmetic, in an order that depends on the points alone.
/// Of points at the same place all but one stay without tetrahedra. Fewer than four points, or all in a plane: none.
std::vector<Tet> delaunay_tets(const std::vector<Point>& points);

}  // namespace bake

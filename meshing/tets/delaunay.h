// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// The Delaunay tetrahedra of points. All have positive volume in exact arithmetic, and their order depends on the points alone.
/// Of several points at the same position only one gets tetrahedra. Fewer than four points, or points in one plane, have none.
std::vector<Tet> delaunay_tets(const std::vector<Point>& points);

}  // namespace bake

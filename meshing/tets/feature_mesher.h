// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshing/solid/triangle_mesh.h"

namespace bake {

/// Fills a closed surface with about `target` vertices by Delaunay refinement, keeping its sharp edges (CGAL's Mesh_3, slivers perturbed
/// and exuded), to 2 % or as near as possible. The volumes of vertices spread by a quarter of their mean. It uses one thread and makes the
/// same mesh every time. Throws InputError if `target` is too small.
TetMesh feature_tets(const TriangleMesh& surface, std::size_t target, const Tell& tell = tell_nobody);

}  // namespace bake

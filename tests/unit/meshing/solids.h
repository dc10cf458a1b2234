// SPDX-License-Identifier: MIT
// Solids and small meshes that several tests use.
#pragma once

#include <vector>

#include "meshing/tets/delaunay.h"
#include "meshing/tets/lattice_mesher.h"
#include "meshing/tets/tet_mesh.h"
#include "tests/unit/boundary/sampling.h"

namespace bake {

inline ShapePtr ball(double radius = 0.1) { return make_sphere({0, 0, 0}, radius); }
inline ShapePtr brick(const Vector3& half = {0.1, 0.08, 0.06}) { return make_box({0, 0, 0}, half); }

/// A loaf as that of figure 15 with one slit: creases all around the bottom and the slit, whose ends run out to nothing.
inline ShapePtr slit_loaf() {
  const ShapePtr slit = make_transformed(make_ellipsoid({0, 0, 0}, {0.035, 0.22, 0.12}), 1, {0, 0, 35}, {0, 0, 0.25});
  return make_difference(make_intersection({make_superellipsoid({0.5, 0.27, 0.24}, 2.5, 2.2), make_half_space({0, 0, -0.06}, {0, 0, -1})}),
                         {slit});
}

inline TetMesh filled(const Shape& solid, std::size_t target, const Tell& tell = tell_nobody) {
  return lattice_tets(solid, solid_volume(solid), target, tell);
}

/// The Delaunay tetrahedra of points, without those that are nearly flat.
inline TetMesh delaunay_mesh(std::vector<Point> points) {
  TetMesh mesh{std::move(points), {}};
  for (const Tet& tet : delaunay_tets(mesh.points))
    if (tet_volume(mesh.points, tet) > 1e-9) mesh.tets.push_back(tet);
  return mesh;
}

}  // namespace bake

// SPDX-License-Identifier: MIT
// Solids and small meshes that several tests use.
#pragma once

#include <vector>

#include "meshing/tets/delaunay.h"
#include "meshing/tets/tet_mesh.h"
#include "solver/boundary/shapes.h"

namespace bake {

inline ShapePtr ball(double radius = 0.1) {
  Sphere sphere;
  sphere.radius_m = radius;
  return std::make_shared<Sphere>(sphere);
}

inline ShapePtr brick(const Vector3& half = {0.1, 0.08, 0.06}) {
  Box box;
  box.half_extents_m = half;
  return std::make_shared<Box>(box);
}

inline ShapePtr below(double z) {
  HalfSpace half;
  half.point_m = {0, 0, z};
  return std::make_shared<HalfSpace>(half);
}

/// A loaf as that of figure 15 with one slit: creases all around the bottom and the slit, whose ends run out to nothing.
inline ShapePtr slit_loaf() {
  Superellipsoid loaf;
  loaf.half_axes_m = {0.5, 0.27, 0.24};
  loaf.plan_exponent = 2.5;
  loaf.profile_exponent = 2.2;
  HalfSpace above;
  above.point_m = {0, 0, -0.06};
  above.outward_normal = {0, 0, -1};
  Ellipsoid slit;
  slit.half_axes_m = {0.035, 0.22, 0.12};
  return make_difference(make_intersection({std::make_shared<Superellipsoid>(loaf), std::make_shared<HalfSpace>(above)}),
                         {make_transformed(std::make_shared<Ellipsoid>(slit), 1, {0, 0, 35}, {0, 0, 0.25})});
}

/// The Delaunay tetrahedra of points, without those that are nearly flat.
inline TetMesh delaunay_mesh(std::vector<Point> points) {
  TetMesh mesh{std::move(points), {}};
  for (const Tet& tet : delaunay_tets(mesh.points))
    if (tet_volume(mesh.points, tet) > 1e-9) mesh.tets.push_back(tet);
  return mesh;
}

inline double volume_of(const TetMesh& mesh) {
  double sum = 0;
  for (const Tet& tet : mesh.tets) sum += tet_volume(mesh.points, tet);
  return sum;
}

}  // namespace bake

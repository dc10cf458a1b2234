// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <vector>

#include "meshing/solid/triangle_mesh.h"

namespace bake {

/// The surface as one of CGAL's, whose vertices and faces have the same order.
template <class Surface, class Kernel>
Surface cgal_surface(const TriangleMesh& mesh) {
  std::vector<typename Kernel::Point_3> points;
  for (const Point& x : mesh.points) points.emplace_back(x[0], x[1], x[2]);
  std::vector<std::vector<std::size_t>> faces;
  for (const Triangle& t : mesh.triangles) faces.emplace_back(t.begin(), t.end());
  Surface result;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, result);
  return result;
}

}  // namespace bake

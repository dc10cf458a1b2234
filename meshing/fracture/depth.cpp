// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/depth.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <memory>

namespace bake {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal(const Point& x) { return {x[0], x[1], x[2]}; }

Triangles boundary_of(const Topology& topology) {
  const auto& [points, tets] = topology.mesh;
  Triangles triangles;
  for (const auto& [t, corner] : topology.boundary) {
    const auto& f = k_faces[corner];
    triangles.emplace_back(cgal(points[tets[t][f[0]]]), cgal(points[tets[t][f[1]]]), cgal(points[tets[t][f[2]]]));
  }
  return triangles;
}

struct Boundary {
  Triangles triangles;
  AabbTree tree;
};

}  // namespace

std::function<double(const Point&)> depth_in(const Topology& topology) {
  const auto boundary = std::make_shared<Boundary>();
  boundary->triangles = boundary_of(topology);
  boundary->tree.insert(boundary->triangles.begin(), boundary->triangles.end());
  boundary->tree.accelerate_distance_queries();
  return [boundary](const Point& x) { return std::sqrt(boundary->tree.squared_distance(cgal(x))); };
}

}  // namespace bake

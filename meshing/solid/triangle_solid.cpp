// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>

#include "meshing/solid/cgal_surface.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

class TriangleSolid final : public Shape {
 public:
  explicit TriangleSolid(const TriangleMesh& mesh)
      : mesh_(mesh),
        surface_(cgal_surface<Surface, Kernel>(mesh)),
        tree_(faces(surface_).first, faces(surface_).second, surface_),
        side_(tree_) {
    tree_.accelerate_distance_queries();
    box_ = {mesh.points[0], mesh.points[0]};
    for (const Point& x : mesh.points)
      for (int i = 0; i < 3; ++i) {
        box_.low[i] = std::min(box_.low[i], x[i]);
        box_.high[i] = std::max(box_.high[i], x[i]);
      }
  }

  double distance(const Point& x) const override {
    const Kernel::Point_3 y(x[0], x[1], x[2]);
    const double away = std::sqrt(tree_.squared_distance(y));
    return side_(y) == CGAL::ON_BOUNDED_SIDE ? -away : away;
  }

  Point normal(const Point& x) const override {
    const Kernel::Point_3 y(x[0], x[1], x[2]);
    const auto [foot, face] = tree_.closest_point_and_primitive(y);
    const Vector3 away = x - Point{foot.x(), foot.y(), foot.z()};
    const auto& [a, b, c] = mesh_.triangles[static_cast<std::size_t>(face)];
    if (length(away) < 1e-9 * length(box_.high - box_.low))  // only the triangle has a direction
      return unit(cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]));
    return side_(y) == CGAL::ON_BOUNDED_SIDE ? -unit(away) : unit(away);
  }

  Box3 bounds() const override { return box_; }

 private:
  TriangleMesh mesh_;
  Surface surface_;
  Tree tree_;
  CGAL::Side_of_triangle_mesh<Surface, Kernel> side_;
  Box3 box_;
};

}  // namespace

ShapePtr make_triangle_solid(const TriangleMesh& mesh) { return std::make_shared<TriangleSolid>(mesh); }

}  // namespace bake

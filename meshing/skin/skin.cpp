// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/skin/skin.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <cmath>

#include "meshing/tets/effort.h"
#include "meshing/tets/lattice_mesher.h"
#include "meshing/tets/surface_foot.h"
#include "solver/core/errors.h"

namespace bake {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// The boundary of lattice tetrahedra whose nearest neighbours are one edge length apart.
TriangleMesh first_guess(const Shape& solid, double edge_length_m, const Tell& tell) {
  constexpr double k_most = 2e7;
  const double a = edge_length_m * 2 / std::sqrt(3.0), volume_m3 = solid_volume(solid), vertices = 2 * volume_m3 / (a * a * a);
  if (vertices < 10) throw InputError(fmt::format("edges of {:.4g} m are too long for this body", edge_length_m));
  if (vertices > k_most)
    throw InputError(
        fmt::format("edges of {:.4g} m are too short for this body: it would be filled with {:.3g} vertices on the way, allowed: {:.3g}",
                    edge_length_m, vertices, k_most));
  const TetMesh tets = lattice_tets(solid, volume_m3, static_cast<std::size_t>(vertices), tell);
  return {tets.points, boundary_triangles(tets.tets, tet_neighbours(tets.tets, tets.points.size()))};
}

Surface surface_of(const TriangleMesh& mesh) {
  std::vector<std::int32_t> number(mesh.points.size(), -1);
  Surface surface;
  for (const Triangle& t : mesh.triangles) {
    std::array<Surface::Vertex_index, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const Point& x = mesh.points[t[k]];
      if (number[t[k]] < 0) number[t[k]] = static_cast<std::int32_t>(static_cast<std::size_t>(surface.add_vertex({x[0], x[1], x[2]})));
      corner[k] = Surface::Vertex_index(number[t[k]]);
    }
    surface.add_face(corner[0], corner[1], corner[2]);
  }
  return surface;
}

void make_even(Surface& surface, double edge_length_m) {
  auto sharp = surface.add_property_map<Surface::Edge_index, bool>("e:sharp", false).first;
  processing::detect_sharp_edges(surface, k_sharp_deg, sharp);
  processing::isotropic_remeshing(faces(surface), edge_length_m, surface,
                                  CGAL::parameters::number_of_iterations(4).edge_is_constrained_map(sharp).protect_constraints(false));
}

}  // namespace

TriangleMesh make_skin(const Shape& solid, const TriangleMesh* surface, double edge_length_m, const Tell& tell) {
  if (surface != nullptr) require_effort(fmt::format("edges of {:.4g} m", edge_length_m), skin_effort(area(*surface), edge_length_m));
  Surface even = surface_of(surface != nullptr ? *surface : first_guess(solid, edge_length_m, tell));
  tell(fmt::format("making {} triangles even", even.number_of_faces()));
  make_even(even, edge_length_m);
  even.collect_garbage();
  tell(fmt::format("moving {} vertices onto the surface", even.number_of_vertices()));
  TriangleMesh skin;
  for (const auto v : even.vertices()) {
    const Point x{even.point(v).x(), even.point(v).y(), even.point(v).z()};
    skin.points.push_back(foot_on_surface(solid, x, 1e-6 * edge_length_m, edge_length_m).value_or(x));
  }
  for (const auto f : even.faces()) {
    Triangle corners;
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(even.halfedge(f), even))
      corners[k++] = static_cast<std::int32_t>(static_cast<std::size_t>(v));
    skin.triangles.push_back(corners);
  }
  if (count_odd_edges(skin.triangles) > 0 || !(enclosed_volume(skin) > 0))
    throw InputError(fmt::format("edges of {:.4g} m are too long for this body: the surface does not close", edge_length_m));
  return skin;
}

}  // namespace bake

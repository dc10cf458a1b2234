// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a surface, has it cleaned, and reports what is wrong with it then.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "meshing/solid/cgal_surface.h"
#include "meshing/solid/cleaning.h"
#include "solver/core/errors.h"
#include "solver/core/union_find.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double k_doubtful_extent_m = 20;  // what is baked is smaller

double largest_extent(const TriangleMesh& mesh) {
  Point low = mesh.points[0], high = low;
  for (const Point& x : mesh.points)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

/// Checks a surface that has been cleaned, reports what is wrong, and turns it outwards.
class Examination {
 public:
  Examination(TriangleMesh& mesh, Mended& mended) : mesh_(mesh), mended_(mended) {}

  void run() {
    check_area();
    check_edges();
    check_vertices();
    check_inside();
  }

 private:
  [[noreturn]] static void refuse(const std::string& what) { throw InputError(what); }

  std::string at(std::size_t vertex) const {
    const Point& x = mesh_.points[vertex];
    return fmt::format("vertex {} ({:.4g} {:.4g} {:.4g})", vertex, x[0], x[1], x[2]);
  }

  void check_area() const {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const auto& x = mesh_.points;
      if (!(length(cross(x[b] - x[a], x[c] - x[a])) > 0)) refuse(fmt::format("triangle {} at {} has no area", t, at(a)));
    }
  }

  static std::string edges_text(std::size_t count) { return fmt::format("{} edge{}", count, count == 1 ? "" : "s"); }

  /// Every edge must occur once in each direction.
  void check_edges() const {
    std::map<std::pair<std::int32_t, std::int32_t>, std::array<int, 2>> uses;
    for (const Triangle& t : mesh_.triangles)
      for (int k = 0; k < 3; ++k) {
        const std::int32_t a = t[k], b = t[(k + 1) % 3];
        ++uses[std::minmax(a, b)][a < b];
      }
    std::size_t open = 0;
    for (const auto& [edge, count] : uses) open += count[0] + count[1] == 1;
    for (const auto& [edge, count] : uses) {
      const int all = count[0] + count[1];
      if (all == 2 && count[0] == 1) continue;
      const std::string where = fmt::format("at the edge from {} to {}", at(edge.first), at(edge.second));
      if (all == 1) refuse(fmt::format("is open {}, and at {} in all, allowed: closed surfaces", where, edges_text(open)));
      if (all > 2) refuse(fmt::format("is not manifold {}: {} triangles meet there, allowed: 2", where, all));
      refuse("has neighbouring triangles that turn different ways " + where);
    }
  }

  /// The triangles at a vertex must be connected through edges.
  void check_vertices() const {
    std::vector<std::vector<std::int32_t>> around(mesh_.points.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::int32_t v : mesh_.triangles[t]) around[v].push_back(static_cast<std::int32_t>(t));
    for (std::size_t v = 0; v < around.size(); ++v) {
      UnionFind groups(around[v].size());
      std::map<std::int32_t, std::int32_t> first;  // triangle of the vertex, by another corner
      for (std::size_t i = 0; i < around[v].size(); ++i)
        for (const std::int32_t other : mesh_.triangles[around[v][i]]) {
          if (other == static_cast<std::int32_t>(v)) continue;
          const auto [place, is_new] = first.try_emplace(other, static_cast<std::int32_t>(i));
          if (!is_new) groups.unite(place->second, static_cast<std::int32_t>(i));
        }
      for (std::size_t i = 0; i < around[v].size(); ++i)
        if (groups.find(static_cast<std::int32_t>(i)) != 0)
          refuse(fmt::format("is not manifold at {}: parts of the surface touch there", at(v)));
    }
  }

  void check_inside() {
    Surface closed = cgal_surface<Surface, Kernel>(mesh_);
    using Face = Surface::Face_index;
    std::vector<std::pair<Face, Face>> crossing;
    processing::self_intersections(closed, std::back_inserter(crossing));
    if (!crossing.empty()) {
      const auto& [a, b] = *std::min_element(crossing.begin(), crossing.end());
      refuse(fmt::format("intersects itself: triangles {} and {} at {} do, and {} pairs in all", static_cast<std::size_t>(a),
                         static_cast<std::size_t>(b), at(mesh_.triangles[static_cast<std::size_t>(a)][0]), crossing.size()));
    }
    // Shells that were turned within themselves tell nothing of inside and outside any more; else only all of them together are turned.
    if (mended_.turned)
      turn_to_bound_a_volume(closed);
    else if (enclosed_volume(mesh_) < 0)
      turn_all(closed);
    if (!processing::does_bound_a_volume(closed) || !(enclosed_volume(mesh_) > 0))
      refuse("has a shell that is inside out: shells must in turn hold and leave out");
  }

  void turn_to_bound_a_volume(Surface& closed) {
    processing::orient_to_bound_a_volume(closed);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      int k = 0;
      const auto face = Surface::Face_index(static_cast<Surface::size_type>(t));
      for (const auto v : CGAL::vertices_around_face(closed.halfedge(face), closed))
        mesh_.triangles[t][k++] = static_cast<std::int32_t>(static_cast<std::size_t>(v));
    }
  }

  void turn_all(Surface& closed) {
    for (Triangle& t : mesh_.triangles) std::swap(t[1], t[2]);
    mended_.turned = true;
    closed = cgal_surface<Surface, Kernel>(mesh_);
  }

  TriangleMesh& mesh_;
  Mended& mended_;
};

}  // namespace

TriangleMesh read_triangle_mesh(const std::filesystem::path& file, const SurfaceReading& reading) {
  PolygonSoup soup = read_polygon_soup(file);
  for (Point& x : soup.points) {
    x = reading.unit_m * x;
    if (reading.y_is_up) x = {x[0], -x[2], x[1]};
  }
  try {
    Mended mended;
    TriangleMesh mesh = clean_surface(soup, mended);
    Examination(mesh, mended).run();
    const std::string text = mended.text();
    if (!text.empty()) reading.say(fmt::format("{}: mended: {}", file.string(), text));
    if (const double extent = largest_extent(mesh); extent > k_doubtful_extent_m && !reading.unit_is_given)
      reading.say(
          fmt::format("{}: is {:.4g} m across, if its numbers are metres; if they are millimetres, add --unit mm", file.string(), extent));
    return mesh;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace bake

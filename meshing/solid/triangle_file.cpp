// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a surface and reports what is wrong with it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "meshing/solid/triangle_mesh.h"
#include "meshing/union_find.h"
#include "solver/core/errors.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Faces = std::vector<std::vector<std::size_t>>;

constexpr const char* k_endings[] = {".stl", ".obj", ".ply", ".off"};

std::string ending(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Checks a surface that has been read, and reports what is wrong.
class Examination {
 public:
  Examination(const std::filesystem::path& file, const TriangleMesh& mesh) : file_(file.string()), mesh_(mesh) {}

  void run() const {
    if (mesh_.triangles.empty()) refuse("is empty: it has no triangles");
    check_corners();
    check_edges();
    check_vertices();
    check_inside();
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(fmt::format("{}: {}", file_, what)); }

  std::string at(std::size_t vertex) const {
    const Point& x = mesh_.points[vertex];
    return fmt::format("vertex {} ({:.4g} {:.4g} {:.4g})", vertex, x[0], x[1], x[2]);
  }

  void check_corners() const {
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      for (const double x : mesh_.points[v])
        if (!std::isfinite(x)) refuse(fmt::format("vertex {} has a coordinate that is no finite number", v));
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const auto& x = mesh_.points;
      if (!(length(cross(x[b] - x[a], x[c] - x[a])) > 0)) refuse(fmt::format("triangle {} at {} has no area", t, at(a)));
    }
  }

  /// Every edge must occur once in each direction.
  void check_edges() const {
    std::map<std::pair<std::int32_t, std::int32_t>, std::array<int, 2>> uses;
    for (const Triangle& t : mesh_.triangles)
      for (int k = 0; k < 3; ++k) {
        const std::int32_t a = t[k], b = t[(k + 1) % 3];
        ++uses[std::minmax(a, b)][a < b];
      }
    for (const auto& [edge, count] : uses) {
      const int all = count[0] + count[1];
      const std::string where = fmt::format("at the edge from {} to {}", at(edge.first), at(edge.second));
      if (all == 1) refuse("is open " + where + ", allowed: closed surfaces");
      if (all > 2) refuse(fmt::format("is not manifold {}: {} triangles meet there, allowed: 2", where, all));
      if (count[0] != 1) refuse("has neighbouring triangles that turn different ways " + where);
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

  void check_inside() const {
    std::vector<Kernel::Point_3> points;
    for (const Point& x : mesh_.points) points.emplace_back(x[0], x[1], x[2]);
    Faces faces;
    for (const Triangle& t : mesh_.triangles) faces.emplace_back(t.begin(), t.end());
    CGAL::Surface_mesh<Kernel::Point_3> surface;
    processing::polygon_soup_to_polygon_mesh(points, faces, surface);
    using Face = CGAL::Surface_mesh<Kernel::Point_3>::Face_index;
    std::vector<std::pair<Face, Face>> crossing;
    processing::self_intersections(surface, std::back_inserter(crossing));
    if (!crossing.empty()) {
      const auto& [a, b] = *std::min_element(crossing.begin(), crossing.end());
      refuse(fmt::format("intersects itself: triangles {} and {} at {} do, and {} pairs in all", static_cast<std::size_t>(a),
                         static_cast<std::size_t>(b), at(mesh_.triangles[static_cast<std::size_t>(a)][0]), crossing.size()));
    }
    const double volume = enclosed_volume(mesh_);
    if (!(volume > 0))
      refuse(fmt::format("is inside out: its volume is {:.4g} m^3; triangles must be counter-clockwise from outside", volume));
    if (!processing::does_bound_a_volume(surface)) refuse("has a shell that is inside out: shells must in turn hold and leave out");
  }

  std::string file_;
  const TriangleMesh& mesh_;
};

}  // namespace

bool is_triangle_file(const std::filesystem::path& file) {
  return std::find(std::begin(k_endings), std::end(k_endings), ending(file)) != std::end(k_endings);
}

TriangleMesh read_triangle_mesh(const std::filesystem::path& file) {
  if (!std::ifstream(file)) throw InputError(fmt::format("{}: cannot open", file.string()));
  std::vector<Kernel::Point_3> points;
  Faces faces;
  bool is_read = false;
  try {
    is_read = CGAL::IO::read_polygon_soup(file.string(), points, faces, CGAL::parameters::verbose(false));
  } catch (const std::exception&) {  // the exceptions of CGAL's readers tell nothing more
  }
  if (!is_read && !(points.empty() && faces.empty()))
    throw InputError(
        fmt::format("{}: damaged, or not what its ending says (behind vertex {} and face {})", file.string(), points.size(), faces.size()));
  if (ending(file) == ".stl") processing::merge_duplicate_points_in_polygon_soup(points, faces);  // STL repeats every corner
  TriangleMesh mesh;
  for (const auto& x : points) mesh.points.push_back({x.x(), x.y(), x.z()});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::size_t v : faces[f])
      if (v >= points.size())
        throw InputError(fmt::format("{}: face {}: found vertex {}, allowed: 0 to {}", file.string(), f, v, points.size() - 1));
    for (std::size_t k = 2; k < faces[f].size(); ++k)
      mesh.triangles.push_back(
          {static_cast<std::int32_t>(faces[f][0]), static_cast<std::int32_t>(faces[f][k - 1]), static_cast<std::int32_t>(faces[f][k])});
  }
  Examination(file, mesh).run();
  return mesh;
}

}  // namespace bake

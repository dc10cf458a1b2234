// SPDX-License-Identifier: MIT
#include "solver/run/skins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "solver/core/vector3.h"
#include "solver/effects/skin_of_scene.h"
#include "solver/grid/grid.h"

namespace bake {
namespace {

std::string name_of_skin(std::size_t number) { return fmt::format("skin.{}", number); }

SurfaceMesh read_surface(const std::filesystem::path& path) {
  const Mesh file = read_mesh(path);
  if (file.corners != 3) throw InputError(fmt::format("{}: found tetrahedra, allowed: triangles", path.string()));
  SurfaceMesh mesh;
  for (std::size_t v = 0; v < file.vertex_count(); ++v)
    mesh.points.push_back({file.points[3 * v], file.points[3 * v + 1], file.points[3 * v + 2]});
  for (std::size_t t = 0; t < file.cell_count(); ++t)
    mesh.triangles.push_back({static_cast<std::int32_t>(file.cells[3 * t]), static_cast<std::int32_t>(file.cells[3 * t + 1]),
                              static_cast<std::int32_t>(file.cells[3 * t + 2])});
  return mesh;
}

SurfaceMesh mesh_on(const Scene& scene, const Skin& skin, const Body& body) {
  const double depth = skin.depth_dx * scene.dx();
  if (skin.mesh_file.empty()) return cover(*body.shape, k_skin_edge_dx * scene.dx(), depth);
  SurfaceMesh mesh = read_surface(skin.mesh_file);
  move_inwards(mesh, depth);
  return mesh;
}

void check_mesh(const Scene& scene, const SurfaceMesh& mesh) {
  if (mesh.triangles.empty()) throw InputError("found no triangle, allowed: some (a region `only` that the surface passes through)");
  hinges_of(mesh.triangles);  // throws
  double area = 0;
  for (const SurfaceTriangle& t : mesh.triangles) area += area_of(mesh, t);
  for (const SurfaceTriangle& t : mesh.triangles)
    if (!(area_of(mesh, t) > 1e-6 * area / static_cast<double>(mesh.triangles.size())))
      throw InputError(fmt::format(
          "found a triangle of the vertices {}, {}, {} that has no area, allowed: triangles that are not collapsed", t[0], t[1], t[2]));
  const std::vector<double> areas = vertex_areas(mesh);
  if (const auto lone = std::find_if(areas.begin(), areas.end(), [](double a) { return !(a > 0); }); lone != areas.end())
    throw InputError(fmt::format("found the vertex {} that belongs to no triangle, allowed: vertices of triangles", lone - areas.begin()));
  const GridGeometry geometry(scene.domain.min_m, scene.domain.max_m, scene.dx());
  for (const Point& x : mesh.points)
    if (!geometry.holds(x))
      throw InputError(
          fmt::format("found a vertex at ({:g}, {:g}, {:g}) m, outside the domain, allowed: skins inside it", x[0], x[1], x[2]));
}

MadeSkin make_skin(const Scene& scene, const Skin& skin) {
  MadeSkin made;
  for (const double number : skin.body) {
    const auto body = static_cast<std::size_t>(number);
    SurfaceMesh mesh = mesh_on(scene, skin, scene.bodies[body]);
    if (skin.only) mesh = part_inside(mesh, *skin.only);
    const auto first = static_cast<std::int32_t>(made.mesh.points.size());
    made.mesh.points.insert(made.mesh.points.end(), mesh.points.begin(), mesh.points.end());
    for (const SurfaceTriangle& t : mesh.triangles) made.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    made.body.resize(made.mesh.points.size(), static_cast<std::int32_t>(body));
  }
  check_mesh(scene, made.mesh);
  SurfaceMesh surface = made.mesh;
  move_inwards(surface, -skin.depth_dx * scene.dx());
  const std::vector<double> above = vertex_areas(surface), own = vertex_areas(made.mesh);
  for (std::size_t v = 0; v < own.size(); ++v) made.covers.push_back(above[v] / own[v]);
  return made;
}

double longest_edge(const SurfaceMesh& mesh) {
  double longest = 0;
  for (const SurfaceTriangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest =
          std::max(longest, length(mesh.points[static_cast<std::size_t>(t[(k + 1) % 3])] - mesh.points[static_cast<std::size_t>(t[k])]));
  return longest;
}

/// The centre of mass about which a body spins at the start.
Point centre_of(const Body& body, const std::vector<NewParticle>& particles) {
  double volume = 0;
  Point centre{0, 0, 0};
  for (const NewParticle& p : particles) {
    if (p.body != &body) continue;
    volume += p.volume;
    centre = centre + p.volume * p.x;
  }
  return volume > 0 ? (1 / volume) * centre : centre;
}

}  // namespace

std::vector<MadeSkin> make_skins(const Scene& scene) {
  std::vector<MadeSkin> skins;
  for (std::size_t s = 0; s < scene.skins.size(); ++s) try {
      skins.push_back(make_skin(scene, scene.skins[s]));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", scene.at(name_of_skin(s)), error.what()));
    }
  return skins;
}

std::vector<NewParticle> vertices_of(const Scene& scene, const std::vector<MadeSkin>& skins, const std::vector<NewParticle>& particles) {
  std::vector<NewParticle> vertices;
  for (std::size_t s = 0; s < skins.size(); ++s) {
    const MadeSkin& skin = skins[s];
    const std::vector<double> areas = vertex_areas(skin.mesh);
    std::int32_t last = -1;
    Point centre{};
    for (std::size_t v = 0; v < areas.size(); ++v) {
      const Body& body = scene.bodies[static_cast<std::size_t>(skin.body[v])];
      if (skin.body[v] != last) centre = centre_of(body, particles), last = skin.body[v];
      const Point& x = skin.mesh.points[v];
      vertices.push_back({x, areas[v] * scene.skins[s].thickness_m, static_cast<std::int32_t>(scene.materials.size() + s),
                          body.velocity_m_per_s + cross(body.angular_velocity_rad_per_s, x - centre), body.angular_velocity_rad_per_s,
                          &body});
    }
  }
  return vertices;
}

std::vector<std::string> doubts_about_skins(const Scene& scene) {
  std::vector<std::string> doubts;
  const std::vector<MadeSkin> skins = make_skins(scene);
  const double dx = scene.dx();
  for (std::size_t s = 0; s < skins.size(); ++s) {
    const Skin& skin = scene.skins[s];
    const SurfaceMesh& mesh = skins[s].mesh;
    const auto doubt = [&](const std::string& text) { doubts.push_back(name_of_skin(s) + ": " + text); };
    if (const double edge = longest_edge(mesh); edge > dx)
      doubt(fmt::format("edges of up to {:.3g} dx: those longer than dx make folds longer and let them come early", edge / dx));
    std::size_t outside = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const auto& shape = scene.bodies[static_cast<std::size_t>(skins[s].body[v])].shape;
      outside += shape && shape->distance(mesh.points[v]) > 0;
    }
    if (outside > 0)
      doubt(fmt::format("{} of {} vertices lie outside the flesh: they will lose hold of it (depth_dx = 0.4 holds)", outside,
                        mesh.points.size()));
    for (const double number : skin.body) {
      const double folds = fold_length(scene, flesh_under(scene, number), skin.bending_stiffness());
      if (std::isfinite(folds) && folds < 5 * dx)
        doubt(fmt::format("it would fold at {:.3g} dx on body.{}: below 5 dx the grid decides how finely (a thicker or stiffer skin)",
                          folds / dx, number));
      const auto& shape = scene.bodies[static_cast<std::size_t>(number)].shape;
      if (!shape) continue;
      const Box3 box = shape->bounds();
      const double thinnest = std::min({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
      if (thinnest < 4 * dx)
        doubt(fmt::format("body.{} is {:.3g} dx thick: below 4 dx its surface is measured too small, and it dries too slowly", number,
                          thinnest / dx));
    }
  }
  return doubts;
}

std::vector<MeshField> flesh_at(const std::vector<double>& points, const FrameData& frame, double dx) {
  std::vector<MeshField> fields;
  std::vector<const std::vector<float>*> columns;
  for (const FrameColumn& column : frame.columns)
    if (column.name == "saturation" || column.name == "temperature") {
      columns.push_back(&std::get<std::vector<float>>(column.values));
      fields.push_back({column.name, column.unit, 1, std::vector<double>(points.size() / 3, 0)});
    }
  if (fields.empty()) return fields;
  const auto cell_of = [&](double x, double y, double z, int i, int j, int k) {
    const auto part = [&](double u, int step) {
      return (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(u / (1.5 * dx))) + step) & 0x1fffff);
    };
    return part(x, i) << 42 | part(y, j) << 21 | part(z, k);
  };
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> particles_in;
  const std::vector<double> x_p =
      std::visit([](const auto& numbers) { return std::vector<double>(numbers.begin(), numbers.end()); }, frame.positions);
  for (std::size_t p = 0; 3 * p < x_p.size(); ++p) particles_in[cell_of(x_p[3 * p], x_p[3 * p + 1], x_p[3 * p + 2], 0, 0, 0)].push_back(p);
  for (std::size_t v = 0; 3 * v < points.size(); ++v) {
    const double* x = &points[3 * v];
    double weights = 0;
    std::vector<double> sums(columns.size(), 0);
    for (int cell = 0; cell < 27; ++cell) {
      const auto found = particles_in.find(cell_of(x[0], x[1], x[2], cell / 9 - 1, cell / 3 % 3 - 1, cell % 3 - 1));
      if (found == particles_in.end()) continue;
      for (const std::size_t p : found->second) {
        double w = 1;
        for (std::size_t d = 0; d < 3 && w > 0; ++d) {
          const double u = std::abs(x[d] - x_p[3 * p + d]) / dx;
          w *= u < 0.5 ? 0.75 - u * u : u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0;
        }
        if (w == 0) continue;
        weights += w;
        for (std::size_t c = 0; c < columns.size(); ++c) sums[c] += w * static_cast<double>((*columns[c])[p]);
      }
    }
    for (std::size_t c = 0; c < columns.size(); ++c) fields[c].values[v] = weights > 0 ? sums[c] / weights : 0;
  }
  return fields;
}

}  // namespace bake

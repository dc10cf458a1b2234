// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/cli/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshing/solid/polygon_soup.h"
#include "meshing/tets/lattice_mesher.h"
#include "solver/program/scene_files.h"

namespace bake::cli {
namespace {

constexpr std::pair<const char*, double> k_units[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 0.0254}};

double length_of(const std::string& unit) {
  return std::find_if(std::begin(k_units), std::end(k_units), [&](const auto& known) { return known.first == unit; })->second;
}

}  // namespace

void SourceArguments::add_to(CLI::App& command) {
  command.add_option("source", name, "a scene, by name or as path of a .toml file, or a closed surface: .stl, .obj, .ply, .off")
      ->required();
  add_quality_option(command, quality);
  add_set_option(command, overrides);
  command.add_option("--body", body, "which body of the scene [0]")->type_name("N")->transform(whole_number(0, 1'000'000));
  std::vector<std::string> units;
  for (const auto& [name, length_m] : k_units) units.emplace_back(name);
  command.add_option("--unit", unit, "unit of a surface's numbers: m, cm, mm, in [m]")
      ->check(CLI::IsMember(units))
      ->each([this](const std::string&) { unit_is_given = true; });
  command.add_option("--up", up, "axis of a surface's file that points upwards, and becomes z: y, z [z]")->check(CLI::IsMember({"y", "z"}));
}

Source find_source(const SourceArguments& arguments, const Tell& say) {
  if (is_surface_file(arguments.name)) {
    TriangleMesh surface =
        read_triangle_mesh(arguments.name, {length_of(arguments.unit), arguments.unit_is_given, arguments.up == "y", say});
    return {make_triangle_solid(surface), std::move(surface), 0};
  }
  const std::filesystem::path file(arguments.name);
  if (file.has_extension() && file.extension() != ".toml")
    throw InputError(
        fmt::format("{}: found {}, allowed: a scene (.toml), or .stl, .obj, .ply, .off", arguments.name, file.extension().string()));
  const Scene scene = open_scene(arguments.name, {arguments.quality, arguments.overrides});
  const int bodies = static_cast<int>(scene.bodies.size());
  if (arguments.body >= bodies) throw InputError(fmt::format("--body: found {}, the scene has {}, counted from 0", arguments.body, bodies));
  const Body& body = scene.bodies[arguments.body];
  if (!body.shape)
    throw InputError(fmt::format("{}: body.{}: found particles_file, allowed: a body with a shape", scene.file.string(), arguments.body));
  return {body.shape, std::nullopt, scene.dx() / std::cbrt(body.particles_per_cell)};
}

double body_volume(const Source& source) { return source.surface ? enclosed_volume(*source.surface) : solid_volume(*source.solid); }

}  // namespace bake::cli

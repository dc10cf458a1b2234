// SPDX-License-Identifier: GPL-3.0-or-later
// bake-mesh tets <scene>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

#include "meshing/cli/commands.h"
#include "meshing/tets/lattice_mesher.h"
#include "solver/cli/scene_files.h"
#include "solver/scene/reader.h"

namespace bake::cli {
namespace {

struct TetsArguments {
  std::string source;
  std::filesystem::path out;
  Quality quality = Quality::draft;
  std::vector<std::string> overrides;
  int body = 0;
  std::optional<std::size_t> vertices;
};

/// A solid, and how many vertices it gets unless told otherwise.
struct Source {
  ShapePtr solid;
  std::size_t vertices;
};

Source scene_body(const TetsArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.source), {arguments.quality, arguments.overrides});
  if (arguments.body >= static_cast<int>(scene.bodies.size()))
    throw InputError(fmt::format("--body: found {}, allowed: 0 to {}", arguments.body, static_cast<int>(scene.bodies.size()) - 1));
  const Body& body = scene.bodies[arguments.body];
  if (!body.shape)
    throw InputError(fmt::format("{}: body.{}: found particles_file, allowed: a body with a shape", scene.file.string(), arguments.body));
  const double vertices = body.particles_per_cell * solid_volume(*body.shape) / std::pow(scene.dx(), 3);
  return {body.shape, static_cast<std::size_t>(std::llround(vertices))};
}

int tets(const TetsArguments& arguments) {
  const Source source = scene_body(arguments);
  const TetMesh mesh = lattice_tets(*source.solid, arguments.vertices.value_or(source.vertices));
  write_mesh(arguments.out, to_particles_mesh(mesh));
  const TetQuality quality = tet_quality(mesh);
  fmt::print("{}: {} vertices ({} of them on the surface), {} tetrahedra, {:.6g} m^3, volumes of inner vertices spread by {:.1f} %\n",
             arguments.out.string(), mesh.points.size(), quality.boundary, mesh.tets.size(), quality.volume, 100 * quality.inner_spread);
  return k_success;
}

}  // namespace

void add_tets_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<TetsArguments>();
  CLI::App& command = *app.add_subcommand("tets", "Fill a body with tetrahedra; their vertices serve as its particles");
  command.add_option("source", arguments->source, "a scene: name or path of a .toml file")->required();
  command.add_option("--out", arguments->out, "file of the mesh, .hdf; a scene takes it as particles_file")->required()->type_name("FILE");
  add_quality_option(command, arguments->quality);
  add_set_option(command, arguments->overrides);
  command.add_option("--body", arguments->body, "which body of the scene [0]")->type_name("N")->check(CLI::Range(0, 1'000'000));
  command.add_option("--vertices", arguments->vertices, "how many vertices, to 2 % [particles_per_cell of the scene at its quality]")
      ->type_name("N")
      ->check(CLI::Range(4, 100'000'000));
  command.callback([arguments, &action] { action = [arguments] { return tets(*arguments); }; });
}

}  // namespace bake::cli

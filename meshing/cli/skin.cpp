// SPDX-License-Identifier: GPL-3.0-or-later
// bake-mesh skin <source>
#include "meshing/skin/skin.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "meshing/cli/source.h"
#include "solver/core/tell.h"
#include "solver/io/progress.h"

namespace bake::cli {
namespace {

struct SkinArguments {
  SourceArguments source;
  std::filesystem::path out;
  std::optional<double> edge_length_m;  ///< none: the distance of the scene's particles
};

void skin(const SkinArguments& arguments) {
  Meter meter("skin");
  const auto say = [&](const std::string& line) {
    meter.clear();
    tell_user("bake-mesh: {}", line);
  };
  const Source source = find_source(arguments.source, say);
  const double edge = arguments.edge_length_m.value_or(source.particle_spacing_m);
  if (!(edge > 0)) throw InputError("--edge-length is required with a surface: it has no particles");
  const TriangleMesh skin =
      make_skin(*source.solid, source.surface ? &*source.surface : nullptr, edge, [&](const std::string& doing) { meter.phase(doing); });
  meter.clear();
  Mesh mesh;
  for (const Point& x : skin.points) mesh.points.insert(mesh.points.end(), x.begin(), x.end());
  for (const Triangle& t : skin.triangles) mesh.cells.insert(mesh.cells.end(), t.begin(), t.end());
  const double share = enclosed_volume(skin) / body_volume(source);
  if (!(share >= 0.99))
    say(fmt::format("the skin encloses {:.1f} % of the body's volume; shorter edges follow its shape better", 100 * share));
  write_mesh(arguments.out, mesh);
  fmt::print("{}: {} vertices, {} triangles, {:.6g} m^2 around {:.6g} m^3\n", arguments.out.string(), skin.points.size(),
             skin.triangles.size(), area(skin), enclosed_volume(skin));
}

}  // namespace

void add_skin_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<SkinArguments>();
  CLI::App& command = *app.add_subcommand("skin", "Cover a body with even triangles");
  arguments->source.add_to(command);
  command.add_option("--out", arguments->out, "file of the mesh, .hdf")->required()->type_name("FILE");
  command.add_option("--edge-length", arguments->edge_length_m, "length of the triangles' edges [the distance of the scene's particles]")
      ->type_name("METRES")
      ->check(number(1e-9, 1e6, "m"));
  on_request(command, action, [arguments] { skin(*arguments); });
}

}  // namespace bake::cli

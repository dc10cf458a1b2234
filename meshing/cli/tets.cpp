// SPDX-License-Identifier: GPL-3.0-or-later
// bake-mesh tets <source>
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "meshing/cli/source.h"
#include "meshing/tets/feature_mesher.h"
#include "meshing/tets/lattice_mesher.h"
#include "meshing/tets/manifold.h"
#include "solver/core/errors.h"
#include "solver/io/progress.h"

namespace bake::cli {
namespace {

struct TetsArguments {
  SourceArguments source;
  std::filesystem::path out;
  std::size_t vertices = 0;  ///< 0: as the scene has particles
  std::string method = "auto";
};

std::size_t vertices_of(const Source& source, const TetsArguments& arguments) {
  if (arguments.vertices > 0) return arguments.vertices;
  if (source.surface) throw InputError("--vertices is required with a surface: it has no particles per cell");
  return static_cast<std::size_t>(std::llround(solid_volume(*source.solid) / std::pow(source.particle_spacing_m, 3)));
}

TetMesh make_tets(const Source& source, const TetsArguments& arguments, const Tell& tell) {
  const std::size_t vertices = vertices_of(source, arguments);
  if (arguments.method == "mesh3" && !source.surface)
    throw InputError("--method: found mesh3 with a scene, allowed: lattice (mesh3 needs a surface of triangles)");
  const bool keep_edges =
      source.surface && (arguments.method == "mesh3" || (arguments.method == "auto" && has_sharp_edges(*source.surface)));
  if (!keep_edges) return lattice_tets(*source.solid, vertices, tell);
  const TetMesh mesh = feature_tets(*source.surface, vertices, tell);
  return manifold_part(mesh.points, mesh.tets, std::vector<char>(mesh.tets.size(), 1));
}

int tets(const TetsArguments& arguments) {
  Meter meter("tets");
  const TetMesh mesh = make_tets(find_source(arguments.source), arguments, [&](const std::string& doing) { meter.phase(doing); });
  meter.phase(fmt::format("looking at {} tetrahedra", mesh.tets.size()));
  const TetQuality quality = tet_quality(mesh);
  if (quality.odd_edges > 0)
    throw RunError(fmt::format("the surface of the mesh is not closed at {} edges: nothing is written", quality.odd_edges));
  meter.clear();
  write_mesh(arguments.out, to_particles_mesh(mesh));
  fmt::print("{}: {} vertices ({} of them on the surface), {} tetrahedra, {:.6g} m^3, volumes of inner vertices spread by {:.1f} %\n",
             arguments.out.string(), mesh.points.size(), quality.boundary, mesh.tets.size(), quality.volume, 100 * quality.inner_spread);
  return k_success;
}

}  // namespace

void add_tets_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<TetsArguments>();
  CLI::App& command = *app.add_subcommand("tets", "Fill a body with tetrahedra; their vertices serve as its particles");
  arguments->source.add_to(command);
  command.add_option("--out", arguments->out, "file of the mesh, .hdf; a scene takes it as particles_file")->required()->type_name("FILE");
  command
      .add_option("--vertices", arguments->vertices,
                  "number of vertices, exact to 2 % [the number of the scene's particles at its quality]")
      ->type_name("N")
      ->transform(whole_number(4, 100'000'000));
  command
      .add_option(
          "--method", arguments->method,
          "lattice: even volumes, creases kept where vertices reach them; mesh3: sharp edges of a surface kept exactly, volumes uneven; "
          "auto: mesh3 for surfaces with edges sharper than 40 degrees [auto]")
      ->check(CLI::IsMember({"auto", "lattice", "mesh3"}));
  command.callback([arguments, &action] { action = [arguments] { return tets(*arguments); }; });
}

}  // namespace bake::cli

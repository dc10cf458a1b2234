// SPDX-License-Identifier: GPL-3.0-or-later
// bake-mesh tets <source>
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "meshing/cli/source.h"
#include "meshing/tets/effort.h"
#include "meshing/tets/feature_mesher.h"
#include "meshing/tets/lattice_mesher.h"
#include "meshing/tets/manifold.h"
#include "meshing/tets/own_process.h"
#include "solver/core/errors.h"
#include "solver/core/tell.h"
#include "solver/io/progress.h"

namespace bake::cli {
namespace {

struct TetsArguments {
  SourceArguments source;
  std::filesystem::path out;
  std::size_t vertices = 0;  ///< 0: as the scene has particles
  std::string method = "auto";
};

std::size_t vertices_of(const Source& source, const TetsArguments& arguments, double volume_m3) {
  if (arguments.vertices > 0) return arguments.vertices;
  if (source.surface) throw InputError("--vertices is required with a surface: it has no particles per cell");
  return static_cast<std::size_t>(std::llround(volume_m3 / std::pow(source.particle_spacing_m, 3)));
}

/// How a mesh compares with what was asked for.
struct Verdict {
  double count_miss = 1, volume_miss = 1;  ///< shares

  bool has_count() const { return count_miss <= 0.1; }
  bool has_volume() const { return volume_miss <= 0.01; }
  /// The better one has the count, and of two that have it (or have it not) the better volume (or count).
  bool is_better_than(const Verdict& other) const {
    if (has_count() != other.has_count()) return has_count();
    return has_count() ? volume_miss < other.volume_miss : count_miss < other.count_miss;
  }
};

/// What is asked for.
struct Aim {
  std::size_t vertices = 0;
  double volume_m3 = 0;

  Verdict judge(const TetMesh& mesh) const {
    return {std::abs(static_cast<double>(mesh.points.size()) / static_cast<double>(vertices) - 1), std::abs(volume(mesh) / volume_m3 - 1)};
  }
  /// Empty if the mesh is as asked for.
  std::string complaint(const TetMesh& mesh) const {
    const Verdict verdict = judge(mesh);
    if (mesh.tets.empty()) return "its mesh is empty";
    if (!verdict.has_count()) return fmt::format("the sharp edges need {} vertices", mesh.points.size());
    if (!verdict.has_volume()) return fmt::format("its mesh misses the volume by {:.1f} %", 100 * verdict.volume_miss);
    return {};
  }
};

/// The mesh that keeps sharp edges, or why there is none. CGAL's Mesh_3 may need ever more vertices where edges meet at small angles.
std::variant<TetMesh, NoMesh> mesh_with_edges(const TriangleMesh& surface, std::size_t vertices, const Tell& tell) {
  constexpr double k_slack = 10;  // a busy machine, a surface of many edges
  const Effort effort = feature_effort(static_cast<double>(vertices));
  return in_own_process(
      [&](const Tell& tell_parent) {
        const TetMesh mesh = feature_tets(surface, vertices, tell_parent);
        return manifold_part(mesh.points, mesh.tets, std::vector<char>(mesh.tets.size(), 1));
      },
      {60 + k_slack * effort.seconds, 1e9 + k_slack * effort.bytes}, tell);
}

TetMesh only_mesh3(const Source& source, const Aim& aim, const Tell& tell) {
  auto made = mesh_with_edges(*source.surface, aim.vertices, tell);
  if (const auto* none = std::get_if<NoMesh>(&made))
    throw InputError(fmt::format("mesh3 makes no mesh of this surface: {}; --method lattice may", none->why));
  TetMesh& mesh = std::get<TetMesh>(made);
  const Verdict verdict = aim.judge(mesh);
  if (mesh.tets.empty() || !verdict.has_count())
    throw InputError(
        fmt::format("--vertices {}: {}; --method lattice rounds them and keeps to the number", aim.vertices, aim.complaint(mesh)));
  return std::move(mesh);
}

/// mesh3 or, where that gives up or does not make what was asked for, the better of both.
TetMesh mesh3_or_lattice(const Source& source, const Aim& aim, const Tell& tell, const Tell& say) {
  auto made = mesh_with_edges(*source.surface, aim.vertices, tell);
  auto* with_edges = std::get_if<TetMesh>(&made);
  const std::string complaint = with_edges != nullptr ? aim.complaint(*with_edges) : std::get<NoMesh>(made).why;
  if (complaint.empty()) return std::move(*with_edges);
  const bool has_edges = with_edges != nullptr && !with_edges->tets.empty();
  TetMesh lattice;
  try {
    lattice = lattice_tets(*source.solid, aim.volume_m3, aim.vertices, tell);
  } catch (const InputError& error) {
    if (!has_edges || !aim.judge(*with_edges).has_count()) throw InputError(fmt::format("lattice: {}; mesh3: {}", error.what(), complaint));
    return std::move(*with_edges);
  }
  if (has_edges && aim.judge(*with_edges).is_better_than(aim.judge(lattice))) return std::move(*with_edges);
  say(fmt::format("mesh3 gives up ({}), so the lattice is used: sharp edges are kept only where its vertices reach them", complaint));
  return lattice;
}

TetMesh make_tets(const Source& source, const TetsArguments& arguments, const Aim& aim, const Tell& tell, const Tell& say) {
  if (arguments.method == "mesh3" && !source.surface)
    throw InputError("--method: found mesh3 with a scene, allowed: lattice (mesh3 needs a surface of triangles)");
  const bool keep_edges =
      source.surface && (arguments.method == "mesh3" || (arguments.method == "auto" && has_sharp_edges(*source.surface)));
  const auto vertices = static_cast<double>(aim.vertices);
  require_effort(fmt::format("{} vertices", aim.vertices), keep_edges ? feature_effort(vertices) : lattice_effort(vertices));
  if (!keep_edges) return lattice_tets(*source.solid, aim.volume_m3, aim.vertices, tell);
  return arguments.method == "mesh3" ? only_mesh3(source, aim, tell) : mesh3_or_lattice(source, aim, tell, say);
}

void tets(const TetsArguments& arguments) {
  Meter meter("tets");
  const auto tell = [&](const std::string& doing) { meter.phase(doing); };
  const auto say = [&](const std::string& line) {
    meter.clear();
    tell_user("bake-mesh: {}", line);
  };
  const Source source = find_source(arguments.source, say);
  tell("measuring the volume");
  const double volume_m3 = body_volume(source);
  const Aim aim{vertices_of(source, arguments, volume_m3), volume_m3};
  const TetMesh mesh = make_tets(source, arguments, aim, tell, say);
  meter.phase(fmt::format("looking at {} tetrahedra", mesh.tets.size()));
  const TetQuality quality = tet_quality(mesh);
  if (quality.odd_edges > 0)
    throw RunError(fmt::format("the surface of the mesh is not closed at {} edges: nothing is written", quality.odd_edges));
  const Verdict verdict = aim.judge(mesh);
  if (!verdict.has_count())
    say(fmt::format("{} vertices instead of {}: the shape admits no nearer number", mesh.points.size(), aim.vertices));
  if (!verdict.has_volume())
    say(fmt::format("the mesh holds {:.1f} % of the body's volume; more vertices follow its shape better",
                    100 * quality.volume / aim.volume_m3));
  meter.clear();
  write_mesh(arguments.out, to_particles_mesh(mesh));
  fmt::print("{}: {} vertices ({} of them on the surface), {} tetrahedra, {:.6g} m^3, volumes of inner vertices spread by {:.1f} %\n",
             arguments.out.string(), mesh.points.size(), quality.boundary, mesh.tets.size(), quality.volume, 100 * quality.inner_spread);
}

}  // namespace

void add_tets_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<TetsArguments>();
  CLI::App& command = *app.add_subcommand("tets", "Fill a body with tetrahedra; their vertices serve as its particles");
  arguments->source.add_to(command);
  command.add_option("--out", arguments->out, "file of the mesh, .hdf; a scene takes it as particles_file")->required()->type_name("FILE");
  command
      .add_option("--vertices", arguments->vertices,
                  "number of vertices, exact to 2 %, or to 10 % for mesh3 [the number of the scene's particles at its quality]")
      ->type_name("N")
      ->transform(whole_number(4, 100'000'000));
  command
      .add_option(
          "--method", arguments->method,
          "lattice: even volumes, creases kept where vertices reach them; mesh3: sharp edges of a surface kept exactly, volumes uneven; "
          "auto: mesh3 for surfaces with edges sharper than 40 degrees, and lattice where mesh3 gives up [auto]")
      ->check(CLI::IsMember({"auto", "lattice", "mesh3"}));
  on_request(command, action, [arguments] { tets(*arguments); });
}

}  // namespace bake::cli

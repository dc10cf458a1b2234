// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "meshing/cli/commands.h"
#include "meshing/solid/triangle_mesh.h"
#include "solver/scene/scene.h"

namespace bake::cli {

/// What the user wants to mesh: a body of a scene, or a closed surface.
struct SourceArguments {
  std::string name;
  Quality quality = Quality::draft;
  std::vector<std::string> overrides;
  int body = 0;
  std::string unit = "m", up = "z";  ///< of a surface
  bool unit_is_given = false;

  void add_to(CLI::App& command);
};

struct Source {
  ShapePtr solid;
  std::optional<TriangleMesh> surface;  ///< only if the source is a file of triangles
  double particle_spacing_m = 0;        ///< distance of the scene's particles at this quality; 0 for a file of triangles
};

/// Throws InputError if the scene or kind of file is unknown, the file has a mistake, or the body does not exist or has no shape.
/// `say` gets a line for each thing that was mended, or that looks doubtful.
Source find_source(const SourceArguments& arguments, const Tell& say);

/// [m^3]
double body_volume(const Source& source);

}  // namespace bake::cli

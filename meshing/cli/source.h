// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "meshing/cli/commands.h"
#include "meshing/solid/triangle_mesh.h"
#include "solver/scene/scene.h"

namespace bake::cli {

/// What is to be meshed, as the user names it: a body of a scene, or a closed surface.
struct SourceArguments {
  std::string name;
  Quality quality = Quality::draft;
  std::vector<std::string> overrides;
  int body = 0;

  void add_to(CLI::App& command);
};

struct Source {
  ShapePtr solid;
  std::optional<TriangleMesh> surface;  ///< if it was a file of triangles
  double particle_spacing_m = 0;        ///< of the scene at this quality; 0 for a file of triangles
};

/// Throws InputError: unknown scene or kind of file, a mistake in it, no such body, a body without a shape.
Source find_source(const SourceArguments& arguments);

}  // namespace bake::cli

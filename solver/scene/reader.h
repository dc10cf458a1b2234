// SPDX-License-Identifier: MIT
// Reads a scene from a TOML file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/scene.h"

namespace bake {

struct ReadOptions {
  Quality quality = Quality::paper;
  /// Each is `key=value` with any dotted scene key (`run.end_s=2`, `body.0.temperature_C=5`, `material.dough.density_kg_per_m3=500`;
  /// members of lists by index or name) and a TOML value; a value that is no TOML is taken as a word (`run.precision=double`).
  std::vector<std::string> overrides;
};

/// Reads and checks a scene file. Relative paths in it start at the file's folder.
/// Throws InputError, one line, for everything that is wrong: `bread.toml:12: run.end_s: found -5, allowed: a number above 0`.
Scene read_scene(const std::filesystem::path& file, const ReadOptions& options = {});

/// Reads a scene from text in memory; `name` stands for the file in messages and gives the folder of relative paths.
Scene parse_scene(std::string_view text, const std::filesystem::path& name, const ReadOptions& options = {});

}  // namespace bake

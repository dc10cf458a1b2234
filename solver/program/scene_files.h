// SPDX-License-Identifier: MIT
// Finds scenes by name: the files experiments/<experiment>/<name>.toml.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene/reader.h"

namespace bake::cli {

struct SceneFile {
  std::string experiment;
  std::string name;
  std::filesystem::path file;
};

/// All scenes in the nearest experiments/ folder at or above the working folder and in that of the sources that the program was built
/// from, sorted by experiment, then name. One that is here hides that of the same experiment and name there.
std::vector<SceneFile> known_scenes();

/// The scene file that a path or a name stands for: `bread`, or `fig15_bread/bread` where several experiments have one.
/// Throws InputError for a name that is unknown (with the nearest known one) or ambiguous; does not check that a path exists.
std::filesystem::path find_scene(const std::string& name_or_path);

/// Reads the scene that `find_scene` finds and prints its notices on standard error, unless `quiet`. Throws as read_scene.
Scene open_scene(const std::string& name_or_path, const ReadOptions& options = {}, bool quiet = false);

}  // namespace bake::cli

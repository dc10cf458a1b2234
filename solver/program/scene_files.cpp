// SPDX-License-Identifier: MIT
#include "solver/program/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "solver/core/tell.h"
#include "solver/scene/nearest.h"

namespace bake::cli {
namespace {

namespace fs = std::filesystem;

/// The nearest folder experiments/ at or above `start`; empty if there is none.
fs::path experiments_above(const fs::path& start) {
  std::error_code ignored;  // a folder that cannot be read counts as one without scenes
  for (fs::path folder = start; !folder.empty(); folder = folder.parent_path()) {
    if (fs::is_directory(folder / "experiments", ignored)) return fs::canonical(folder / "experiments", ignored);
    if (folder == folder.root_path()) break;
  }
  return {};
}

std::vector<SceneFile> scenes_in(const fs::path& experiments) {
  std::vector<SceneFile> found;
  std::error_code ignored;
  for (const auto& experiment : fs::directory_iterator(experiments, ignored)) {
    if (!experiment.is_directory(ignored)) continue;
    for (const auto& file : fs::directory_iterator(experiment, ignored)) {
      const fs::path name = file.path().filename();
      if (name.extension() != ".toml" || name == "figure.toml" || name == "claims.toml") continue;
      found.push_back({experiment.path().filename().string(), file.path().stem().string(), file.path()});
    }
  }
  return found;
}

bool is_path(const std::string& text) {
  std::error_code ignored;
  return fs::path(text).extension() == ".toml" || fs::is_regular_file(text, ignored);
}

std::vector<std::string> names(const std::vector<SceneFile>& scenes) {
  std::vector<std::string> result;
  result.reserve(scenes.size());
  for (const SceneFile& scene : scenes) result.push_back(scene.name);
  return result;
}

}  // namespace

std::vector<SceneFile> known_scenes() {
  std::error_code ignored;
  const fs::path here = experiments_above(fs::current_path(ignored));
  const fs::path built_with = experiments_above(BAKE_SOURCE_DIR);
  std::vector<SceneFile> scenes = scenes_in(here);
  if (built_with != here) {
    const auto is_here = [&](const SceneFile& other) {
      return std::any_of(scenes.begin(), scenes.end(),
                         [&](const SceneFile& scene) { return scene.experiment == other.experiment && scene.name == other.name; });
    };
    std::vector<SceneFile> more = scenes_in(built_with);
    std::erase_if(more, is_here);
    scenes.insert(scenes.end(), more.begin(), more.end());
  }
  std::sort(scenes.begin(), scenes.end(), [](const SceneFile& a, const SceneFile& b) {
    return std::tie(a.experiment, a.name, a.file) < std::tie(b.experiment, b.name, b.file);
  });
  return scenes;
}

std::filesystem::path find_scene(const std::string& name_or_path) {
  if (is_path(name_or_path)) return name_or_path;
  const std::vector<SceneFile> scenes = known_scenes();
  std::vector<SceneFile> matches;
  for (const SceneFile& scene : scenes) {
    if (name_or_path == scene.name || name_or_path == scene.experiment + "/" + scene.name) matches.push_back(scene);
  }
  if (matches.size() == 1) return matches.front().file;
  if (matches.empty()) {
    throw InputError(fmt::format("unknown scene '{}'; {}; `bake list` shows all, a path must end in .toml", name_or_path,
                                 scenes.empty() ? "there is no experiments/ folder here" : suggestion(name_or_path, names(scenes))));
  }
  throw InputError(fmt::format("scene '{}' is ambiguous: {} and {}", name_or_path, matches[0].file.string(), matches[1].file.string()));
}

Scene open_scene(const std::string& name_or_path, const ReadOptions& options, bool quiet) {
  Scene scene = read_scene(find_scene(name_or_path), options);
  for (const std::string& notice : scene.notices)
    if (!quiet) tell_user("bake: {}", notice);
  return scene;
}

}  // namespace bake::cli

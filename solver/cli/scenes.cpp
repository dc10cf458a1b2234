// SPDX-License-Identifier: MIT
// bake list, bake info <scene>, bake validate <scene>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "solver/baker/run.h"
#include "solver/cli/commands.h"
#include "solver/cli/scene_files.h"
#include "solver/scene/reader.h"

namespace bake::cli {
namespace {

struct SceneArguments {
  std::string scene;
  Quality quality = Quality::draft;
};

std::string title_or_error(const SceneFile& scene) {
  try {
    return read_scene(scene.file).title;
  } catch (const InputError& error) {
    return fmt::format("(not a valid scene: {})", error.what());
  }
}

int list() {
  const std::vector<SceneFile> scenes = known_scenes();
  std::size_t width = 0;
  for (const SceneFile& scene : scenes) width = std::max(width, scene.name.size());
  std::string experiment;
  for (const SceneFile& scene : scenes) {
    if (scene.experiment != experiment) fmt::print("{}\n", scene.experiment);
    experiment = scene.experiment;
    fmt::print("  {:<{}}  {}\n", scene.name, width, title_or_error(scene));
  }
  return k_success;
}

int info(const SceneArguments& arguments) {
  fmt::print("{}\n", describe_scene(read_scene(find_scene(arguments.scene), {arguments.quality, {}})));
  return k_success;
}

int validate(const SceneArguments& arguments) {
  const Scene scene = read_scene(find_scene(arguments.scene));
  fmt::print("{}: valid\n", scene.file.string());
  return k_success;
}

}  // namespace

void add_scene_commands(CLI::App& app, Action& action) {
  app.add_subcommand("list", "Name the scenes that come with Bake")->callback([&action] { action = list; });

  auto arguments = std::make_shared<SceneArguments>();
  CLI::App& info_command = *app.add_subcommand("info", "Say what a run of a scene would be: size, steps, memory");
  info_command.add_option("scene", arguments->scene, "name or path of a .toml file")->required();
  add_quality_option(info_command, arguments->quality);
  info_command.callback([arguments, &action] { action = [arguments] { return info(*arguments); }; });

  CLI::App& validate_command = *app.add_subcommand("validate", "Check a scene file without running it");
  validate_command.add_option("scene", arguments->scene, "name or path of a .toml file")->required();
  validate_command.callback([arguments, &action] { action = [arguments] { return validate(*arguments); }; });
}

}  // namespace bake::cli

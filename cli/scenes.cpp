// SPDX-License-Identifier: MIT
// bake list, bake info <scene>, bake validate <scene>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "experiments/accuracy/case.h"
#include "experiments/accuracy/expected.h"
#include "experiments/make/make_figure.h"
#include "solver/program/scene_files.h"
#include "solver/run/check_scene.h"
#include "solver/run/run.h"

namespace bake::cli {
namespace {

struct SceneArguments {
  std::string scene;
  ReadOptions options{Quality::draft, {}};
  int threads = 0;
};

std::string title_or_error(const SceneFile& scene) {
  try {
    return read_scene(scene.file).title;
  } catch (const InputError& error) {
    return fmt::format("(not a valid scene: {})", error.what());
  }
}

int list_scenes() {
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

/// Prints number, name, status and subject of every item of the paper.
int list_figures() {
  for (const Item& item : read_items(items_root(BAKE_SOURCE_DIR)).items)
    fmt::print("{:<12} {:<17} {:<14} {}\n", item.number, item.name, word_of(item.status), item.shows);
  return k_success;
}

/// Prints one line `<item> <run>` for every run that a finished item needs, or `<item>` alone if it needs none: for programs that
/// distribute runs.
int list_runs() {
  const Items items = read_items(items_root(BAKE_SOURCE_DIR));
  for (const Item& item : items.items) {
    if (item.status != ItemStatus::done) continue;
    const auto runs = runs_of(read_figure(items, item).figure);
    if (runs.empty()) fmt::print("{}\n", item.name);
    for (const std::string& run : runs) fmt::print("{} {}\n", item.name, run);
  }
  return k_success;
}

/// Prints the cases of `bake study accuracy`, one per line: for programs that distribute them.
int list_cases() {
  for (const auto& c : studies::accuracy::all_cases()) fmt::print("{}\n", c.name);
  return k_success;
}

int info(const SceneArguments& arguments) {
  const Scene scene = open_scene(arguments.scene, arguments.options);
  fmt::print("{}\n", describe_scene(scene, arguments.threads));
  for (const std::string& line : studies::accuracy::expected_of(scene, BAKE_SOURCE_DIR "/paper/accuracy.json"))
    fmt::print("  measured     {}\n", line);
  return k_success;
}

int validate(const SceneArguments& arguments) {
  const Scene scene = open_scene(arguments.scene, arguments.options);
  check_scene(scene);
  fmt::print("{}: valid\n", scene.file.string());
  return k_success;
}

}  // namespace

void add_scene_commands(CLI::App& app, Action& action) {
  auto what = std::make_shared<std::string>("scenes");
  CLI::App& list_command = *app.add_subcommand("list", "Name the scenes, or the figures and tables of the paper with their status");
  list_command.add_option("what", *what, "scenes, figures, runs (of the figures, one a line), or cases (of bake study accuracy) [scenes]")
      ->check(CLI::IsMember({"scenes", "figures", "runs", "cases"}));
  list_command.callback([what, &action] {
    action = *what == "scenes" ? list_scenes : *what == "figures" ? list_figures : *what == "runs" ? list_runs : list_cases;
  });

  auto arguments = std::make_shared<SceneArguments>();
  const auto add_command = [&](const char* name, const char* meaning, int (*act)(const SceneArguments&)) -> CLI::App& {
    CLI::App& command = *app.add_subcommand(name, meaning);
    command.add_option("scene", arguments->scene, "name or path of a .toml file")->required();
    add_quality_option(command, arguments->options.quality);
    add_set_option(command, arguments->options.overrides);
    on_request(command, action, [arguments, act] { return act(*arguments); });
    return command;
  };
  add_threads_option(add_command("info", "Say what a run of a scene would be: size, steps, memory", info), arguments->threads);
  add_command("validate", "Check a scene without running it: is there anything for which a run would refuse it?", validate);
}

}  // namespace bake::cli

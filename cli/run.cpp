// SPDX-License-Identifier: MIT
// bake run <scene>
#include "solver/run/run.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "solver/program/scene_files.h"
#include "solver/scene/describe.h"

namespace bake::cli {
namespace {

struct RunArguments {
  std::string scene;
  Quality quality = Quality::draft;
  std::optional<double> end_s;
  std::string precision;
  std::vector<std::string> overrides;
  bool overwrite = false;
  RunOptions options;
};

/// Reads the scene. The options --end and --precision are short forms of two overrides; they win over --set.
Scene read(const RunArguments& arguments) {
  ReadOptions options{arguments.quality, arguments.overrides};
  if (arguments.end_s) options.overrides.push_back(fmt::format("run.end_s={}", *arguments.end_s));
  if (!arguments.precision.empty()) options.overrides.push_back("run.precision=" + arguments.precision);
  return open_scene(arguments.scene, options, arguments.options.quiet);
}

int run(const RunArguments& arguments) {
  const Scene scene = read(arguments);
  RunOptions options = arguments.options;
  options.replace = arguments.overwrite ? Replace::any_run : options.out.empty() ? Replace::same_file : Replace::same_scene;
  if (options.out.empty()) options.out = default_results(scene);
  const RunSummary summary = run_scene(scene, options);
  if (!options.quiet) fmt::print("{}\n", summary.text);
  return summary.interrupted ? k_failed_run : k_success;
}

std::string refuse_unless_positive(const std::string& text) {
  double value = 0;
  if (CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value)) return {};
  return fmt::format("found {}, allowed: a number above 0", text);
}

}  // namespace

std::filesystem::path default_results(const Scene& scene) {
  const std::string quality = word_of(scene.quality);
  return std::filesystem::path("results") / (scene.file.stem().string() + "-" + quality);
}

void add_run_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App& command = *app.add_subcommand("run", "Simulate a scene");
  command.add_option("scene", arguments->scene, "name (see `bake list`) or path of a .toml file")->required();
  command.add_option("--out", arguments->options.out, "folder of the results [results/<scene>-<quality>]")
      ->type_name("DIR")
      ->check(not_empty());
  command.add_flag("--overwrite", arguments->overwrite, "replace what is in --out, even if it is of another scene or of other values");
  add_quality_option(command, arguments->quality);
  auto* end = command.add_option("--end", arguments->end_s, "simulated time at which the run ends, instead of the scene's");
  end->type_name("SECONDS")->check(CLI::Validator(refuse_unless_positive, ""));
  auto* frames = command.add_option("--frames", arguments->options.frames, "end after this many frames");
  frames->type_name("N")->transform(whole_number(1, 1'000'000'000))->excludes(end);
  add_threads_option(command, arguments->options.threads);
  command.add_option("--precision", arguments->precision, "floating-point numbers, instead of the scene's")
      ->check(CLI::IsMember({"single", "double"}));
  add_set_option(command, arguments->overrides);
  command.add_flag("--resume", arguments->options.resume,
                   "continue from the checkpoint in the folder of the results; begin if there is none");
  command.add_flag("--quiet", arguments->options.quiet, "print errors only");
  on_request(command, action, [arguments] { return run(*arguments); });
}

}  // namespace bake::cli

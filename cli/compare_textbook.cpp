// SPDX-License-Identifier: MIT
// bake compare-textbook <scene>
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "reference/compare/side_by_side.h"
#include "solver/program/scene_files.h"
#include "solver/run/check_scene.h"

namespace bake::cli {
namespace {

struct CompareArguments {
  std::string scene;
  Quality quality = Quality::draft;
  int steps = 100;
  std::vector<std::string> overrides;
};

constexpr double k_largest_relative_difference = 1e-9;
constexpr double k_largest_grid = 2e9;  // bytes

Scene read(const CompareArguments& arguments) {
  ReadOptions options{arguments.quality, arguments.overrides};
  options.overrides.push_back("run.precision=double");
  return open_scene(arguments.scene, options);
}

void refuse_large_grid(const Scene& scene) {
  const double bytes = SideBySide::textbook_bytes(scene);
  if (bytes > k_largest_grid)
    throw InputError(
        fmt::format("{}: found a domain whose dense grid would take {:.1f} GB, allowed: up to {:.0f} GB (a coarser --quality or "
                    "--set grid.dx_m, a smaller domain)",
                    scene.file.string(), bytes / 1e9, k_largest_grid / 1e9));
}

int compare(const CompareArguments& arguments) {
  const Scene scene = read(arguments);
  check_scene(scene);
  refuse_large_grid(scene);
  SideBySide both(scene);
  while (both.solver().counters().steps < arguments.steps && both.step()) {
  }
  const auto differences = both.differences();
  fmt::print("{}: solver and textbook after {} steps, {:.4g} s, {} particles\n",
             scene.title.empty() ? scene.file.stem().string() : scene.title, both.solver().counters().steps, both.solver().time(),
             both.solver().particles());
  fmt::print("  {:<12} {:>18} {:>12} {:>10}\n", "field", "largest difference", "of", "relative");
  for (const FieldDifference& d : differences)
    fmt::print("  {:<12} {:>18.2e} {:>12.4g} {:>10.1e}\n", d.field, d.largest, d.scale, d.relative());
  const bool agrees = worst(differences) <= k_largest_relative_difference;
  fmt::print("  they {} {:.0e}{}\n", agrees ? "agree to" : "differ by more than", k_largest_relative_difference,
             agrees ? "" : " (reference/textbook/README.md names possible reasons)");
  return agrees ? k_success : k_failed_check;
}

}  // namespace

void add_compare_textbook_command(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App& command = *app.add_subcommand("compare-textbook", "Run a scene beside the plain reference implementation, in double precision");
  command.add_option("scene", arguments->scene, "name (see `bake list`) or path of a .toml file")->required();
  command.add_option("--steps", arguments->steps, "steps to take [100]")->type_name("N")->transform(whole_number(1, 1'000'000'000));
  add_quality_option(command, arguments->quality);
  add_set_option(command, arguments->overrides);
  on_request(command, action, [arguments] { return compare(*arguments); });
}

}  // namespace bake::cli

// SPDX-License-Identifier: MIT
// bake check <scene or results>, bake bless <scene> --why "..."
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/claims/blessing.h"
#include "cli/commands.h"
#include "experiments/make/figure_file.h"
#include "solver/io/atomic_file.h"
#include "solver/program/scene_files.h"
#include "solver/run/kept_run.h"
#include "solver/scene/describe.h"
#include "solver/scene/nearest.h"
#include "solver/scene/reader.h"

namespace bake::cli {
namespace {

namespace fs = std::filesystem;

/// What is claimed of one scene by itself. Written like a figure.toml.
Figure read_claims(const fs::path& file) {
  Figure figure = read_figure(file);
  if (figure.runs.size() != 1 || figure.runs.front().mesh || !figure.surfaces.empty())
    throw InputError(fmt::format("{}: found other runs or surfaces, allowed: one [[run]] without a mesh", file.string()));
  return figure;
}

/// Those of experiments/*/claims.toml.
std::vector<Figure> all_claims() {
  std::vector<Figure> all;
  for (const auto& folder : fs::directory_iterator(fs::path(BAKE_SOURCE_DIR) / "experiments"))
    if (const fs::path file = folder.path() / "claims.toml"; fs::exists(file)) all.push_back(read_claims(file));
  return all;
}

/// Those of a scene's name, or in a file of one's own.
Figure find_claims(const std::string& name) {
  if (fs::path(name).extension() == ".toml") return read_claims(name);
  std::vector<std::string> names;
  for (Figure& figure : all_claims()) {
    names.push_back(figure.runs.front().name);
    if (names.back() == name) return std::move(figure);
  }
  throw InputError(fmt::format("unknown name '{}'; {}", name, suggestion(name, names)));
}

/// Those of the scene that a run was made of.
Figure claims_of(const Results& results) {
  const fs::path scene = results.description().value("/scene/file"_json_pointer, std::string());
  for (Figure& figure : all_claims())
    if (scene_file(figure, figure.runs.front()).stem() == scene.stem()) return std::move(figure);
  throw InputError(fmt::format("{}: found a run of {}, of which nothing is claimed, allowed: those of experiments/*/claims.toml",
                               results.folder().string(), scene.string()));
}

struct CheckArguments {
  std::string subject, why;
  fs::path out;
  bool quiet = false;
};

/// The results of the scene at draft, of which only what is missing is run.
Results results_of(const Figure& figure, const CheckArguments& arguments) {
  const FigureRun& run = figure.runs.front();
  const Scene scene = open_scene(scene_file(figure, run).string(), {Quality::draft, run.set}, arguments.quiet);
  RunOptions options;
  options.out = arguments.out.empty() ? default_results(scene) : arguments.out;
  options.quiet = arguments.quiet;
  options.replace = Replace::same_file;
  complete_run(scene, options, kept_run(scene, options.out));
  return Results(options.out);
}

ClaimVerdict verdict_of(const Claim& claim, const Results& results) {
  const Metric& metric = find_metric(claim.metric);
  const auto measured = [&](const Claim&, const std::string&) { return measure(metric, results, claim.place); };
  return judge(claim, {metric.unit, metric.meaning}, measured).front();
}

int check(const Figure& figure, const Results& results) {
  const std::string quality = results.description().value("/scene/quality"_json_pointer, std::string());
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : figure.claims)
    if (claim.is_judged_at(quality)) verdicts.push_back(verdict_of(claim, results));
  const auto missed = std::count_if(verdicts.begin(), verdicts.end(), [](const ClaimVerdict& v) { return !v.holds; });
  fmt::print("{} at {}: {}\n{}", figure.runs.front().name, quality, figure.title, table(verdicts));
  fmt::print("{} of {} claims hold\n", static_cast<std::ptrdiff_t>(verdicts.size()) - missed, verdicts.size());
  return missed == 0 && !verdicts.empty() ? k_success : k_failed_check;
}

/// Only regressions are measured anew.
int bless(const Figure& figure, const CheckArguments& arguments) {
  Blessing blessing{{}, arguments.why, commit_to_bless(arguments.why)};
  const Results results = results_of(figure, arguments);
  for (const Claim& claim : figure.claims) {
    const ClaimVerdict v = verdict_of(claim, results);
    const bool is_regression = claim.kind == Evidence::regression;
    blessing.expected.push_back(is_regression ? std::optional(v.measured) : std::nullopt);
    if (is_regression)
      fmt::print("  {:<20} {:.9g} -> {:.9g}\n", v.metric, *claim.expected, v.measured);
    else if (!v.holds)
      fmt::print("  {:<20} {:.6g} misses {}: evidence, never blessed\n", v.metric, v.measured, v.condition);
  }
  write_text_atomically(figure.file, bless_claims(read_text_file(figure.file), blessing));
  fmt::print("{} is written; commit it\n", figure.file.string());
  return k_success;
}

int check(const CheckArguments& arguments) {
  if (fs::exists(fs::path(arguments.subject) / "run.json")) {
    const Results results(arguments.subject);
    return check(claims_of(results), results);
  }
  const Figure figure = find_claims(arguments.subject);
  return check(figure, results_of(figure, arguments));
}

}  // namespace

void add_check_commands(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<CheckArguments>();
  const auto add_common = [&](CLI::App& command) {
    command.add_option("--out", arguments->out, "folder of the results [results/<scene>-draft]")->type_name("DIR")->check(not_empty());
    command.add_flag("--quiet", arguments->quiet, "no progress");
  };
  CLI::App& check_command = *app.add_subcommand("check", "Compare a run with what is claimed of its scene");
  check_command.add_option("subject", arguments->subject, "bread, cookie, a file like their claims.toml, or the folder of a finished run")
      ->required();
  add_common(check_command);
  on_request(check_command, action, [arguments] { return check(*arguments); });

  CLI::App& bless_command = *app.add_subcommand("bless", "Measure a scene's regressions anew, with a reason");
  bless_command.add_option("scene", arguments->subject, "bread, cookie, or a file like their claims.toml")->required();
  bless_command.add_option("--why", arguments->why, "the reason")->required();
  add_common(bless_command);
  on_request(bless_command, action, [arguments] { return bless(find_claims(arguments->subject), *arguments); });
}

}  // namespace bake::cli

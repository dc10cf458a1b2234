// SPDX-License-Identifier: MIT
// bake check <item or results>, bake bless <item> --why "..."
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/claims/blessing.h"
#include "analysis/claims/reference.h"
#include "cli/commands.h"
#include "solver/program/scene_files.h"
#include "solver/run/kept_run.h"
#include "solver/scene/describe.h"
#include "solver/scene/nearest.h"

namespace bake::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> reference_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(BAKE_SOURCE_DIR) / "reference/metrics"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The reference of an item's name, or in a file of one's own.
Reference find_reference(const std::string& item) {
  if (fs::path(item).extension() == ".json") return read_reference(item);
  std::vector<std::string> names;
  for (const fs::path& file : reference_files()) {
    if (file.stem() == item) return read_reference(file);
    names.push_back(file.stem().string());
  }
  throw InputError(fmt::format("unknown item '{}'; {}", item, suggestion(item, names)));
}

/// The reference of the scene and quality that a run was made of.
Reference reference_of(const Results& results, const fs::path& folder) {
  const fs::path scene = results.description().value("/scene/file"_json_pointer, std::string());
  const std::string quality = results.description().value("/scene/quality"_json_pointer, std::string());
  for (const fs::path& file : reference_files()) {
    Reference reference = read_reference(file);
    if (fs::path(reference.scene).stem() == scene.stem() && word_of(reference.quality) == quality) return reference;
  }
  throw InputError(fmt::format("{}: found a run of {} at {}, of which there is no reference, allowed: those of reference/metrics",
                               folder.string(), scene.string(), quality));
}

/// The results of the reference's scene, of which only what is missing is run.
Results results_of(const Reference& reference, const fs::path& folder, bool quiet) {
  const Scene scene = open_scene(reference.scene, {reference.quality, {}}, quiet);
  RunOptions options;
  options.out = folder.empty() ? default_results(scene) : folder;
  options.quiet = quiet;
  complete_run(scene, options, kept_run(scene, options.out));
  return Results(options.out);
}

struct CheckArguments {
  std::string subject, why;
  fs::path out;
  bool quiet = false;
};

int check_subject(const CheckArguments& arguments) {
  const bool is_run = fs::is_directory(arguments.subject) && fs::exists(fs::path(arguments.subject) / "run.json");
  const auto [reference, verdicts] = [&] {
    if (is_run) {
      const Results results(arguments.subject);
      Reference found = reference_of(results, arguments.subject);
      auto all = check(found, results);
      return std::pair(std::move(found), std::move(all));
    }
    Reference found = find_reference(arguments.subject);
    auto all = check(found, results_of(found, arguments.out, arguments.quiet));
    return std::pair(std::move(found), std::move(all));
  }();
  const auto missed = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return !v.holds(); });
  fmt::print("{} ({} at {})\n{}", reference.item, reference.scene, word_of(reference.quality), table(verdicts));
  fmt::print("{} of {} metrics hold\n", static_cast<std::ptrdiff_t>(verdicts.size()) - missed, verdicts.size());
  return missed == 0 ? k_success : k_failed_check;
}

int bless(const CheckArguments& arguments) {
  Reference reference = find_reference(arguments.subject);
  const std::string commit = commit_to_bless(arguments.why);
  for (Verdict& v : check(reference, results_of(reference, arguments.out, arguments.quiet))) {
    if (v.expectation.kind != Evidence::regression) {
      if (!v.holds())
        fmt::print("  {:<20} {:.6g} misses {}: evidence, never blessed\n", v.expectation.name, v.measured, v.expectation.words());
      continue;
    }
    const auto at = std::find_if(reference.metrics.begin(), reference.metrics.end(),
                                 [&](const Expectation& e) { return e.name == v.expectation.name && e.kind == Evidence::regression; });
    fmt::print("  {:<20} {:.9g} -> {:.9g}\n", v.expectation.name, *v.expectation.expected, v.measured);
    at->expected = v.measured;
  }
  reference.blessed = {{"why", arguments.why}, {"commit", commit}};
  write_reference(reference);
  fmt::print("{} is written; commit it\n", reference.file.string());
  return k_success;
}

}  // namespace

void add_check_commands(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<CheckArguments>();
  const auto add_common = [&](CLI::App& command) {
    command.add_option("--out", arguments->out, "folder of the results [results/<scene>-<quality>]")->type_name("DIR");
    command.add_flag("--quiet", arguments->quiet, "no progress");
  };
  CLI::App& check_command = *app.add_subcommand("check", "Compare a run with its reference metrics");
  check_command.add_option("subject", arguments->subject, "item of reference/metrics, a reference file, or the folder of a finished run")
      ->required();
  add_common(check_command);
  check_command.callback([arguments, &action] { action = [arguments] { return check_subject(*arguments); }; });

  CLI::App& bless_command = *app.add_subcommand("bless", "Measure an item's regression metrics anew, with a reason");
  bless_command.add_option("item", arguments->subject, "item of reference/metrics, or a reference file")->required();
  bless_command.add_option("--why", arguments->why, "the reason")->required();
  add_common(bless_command);
  bless_command.callback([arguments, &action] { action = [arguments] { return bless(*arguments); }; });
}

}  // namespace bake::cli

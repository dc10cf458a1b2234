// SPDX-License-Identifier: MIT
// bake study <name>
#include "experiments/common/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "solver/core/errors.h"

namespace bake::cli {

namespace {

/// Refuses an option that only some studies have.
void refuse_elsewhere(const std::string& study, const char* option, bool given, const std::vector<std::string>& where) {
  if (given && std::find(where.begin(), where.end(), study) == where.end())
    throw InputError(fmt::format("{}: found with the study \"{}\", allowed: with {}", option, study, fmt::join(where, ", ")));
}

}  // namespace

void add_study_command(CLI::App& app, Action& action) {
  const auto& all = studies::all_studies();
  std::vector<std::string> names, lines;
  for (const studies::Study& study : all) {
    names.push_back(study.name);
    lines.push_back(fmt::format("  {:<12} {}", study.name, study.meaning));
  }
  auto name = std::make_shared<std::string>();
  auto options = std::make_shared<studies::StudyOptions>();
  CLI::App& command = *app.add_subcommand("study", "Measure how well the solver does, and write tables of it");
  command.footer(fmt::format("Studies:\n{}", fmt::join(lines, "\n")));
  command.add_option("study", *name, "which study")->required()->check(CLI::IsMember(names));
  command.add_option("--out", options->out, "folder of the tables [results/studies/<study>]")->type_name("DIR")->check(not_empty());
  auto* quick = command.add_flag("--quick", options->quick, "the coarse resolutions only");
  command.add_flag("--full", options->full, "accuracy: also what takes a night; a study that was stopped continues")->excludes(quick);
  command.add_option("--case", options->cases, "convergence, accuracy: measure this case only and keep the others; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME");
  command.add_flag("--measure-only", options->measure_only,
                   "accuracy: measure and leave the page to a later call, so that cases can run side by side");
  command.add_option("--reference", options->reference, "accuracy: make the fine run that this case is measured against")
      ->type_name("CASE");
  on_request(command, action, [&all, name, options] {
    const auto study = std::find_if(all.begin(), all.end(), [&](const studies::Study& s) { return *name == s.name; });
    refuse_elsewhere(*name, "--case", !options->cases.empty(), {"convergence", "accuracy"});
    refuse_elsewhere(*name, "--full", options->full, {"accuracy"});
    refuse_elsewhere(*name, "--measure-only", options->measure_only, {"accuracy"});
    refuse_elsewhere(*name, "--reference", !options->reference.empty(), {"accuracy"});
    if (options->out.empty()) options->out = std::filesystem::path("results") / "studies" / *name;
    return study->run(*options) ? k_success : k_failed_check;
  });
}

}  // namespace bake::cli

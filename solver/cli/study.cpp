// SPDX-License-Identifier: MIT
// bake study <name>
#include "studies/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "solver/cli/commands.h"
#include "solver/scene/input_error.h"

namespace bake::cli {

void add_study_command(CLI::App& app, Action& action) {
  const auto& all = studies::all_studies();
  std::vector<std::string> names, lines;
  for (const studies::Study& study : all) {
    names.push_back(study.name);
    lines.push_back(fmt::format("  {:<12} {}", study.name, study.meaning));
  }
  auto name = std::make_shared<std::string>();
  auto options = std::make_shared<studies::StudyOptions>();
  CLI::App& command = *app.add_subcommand("study", "Measure what the solver is held to and write it down");
  command.footer(fmt::format("Studies:\n{}", fmt::join(lines, "\n")));
  command.add_option("study", *name, "which one")->required()->check(CLI::IsMember(names));
  command.add_option("--out", options->out, "folder of the tables [results/studies/<study>]")->type_name("DIR");
  command.add_flag("--quick", options->quick, "the coarse resolutions only");
  command.add_option("--case", options->cases, "convergence: measure this case only and keep the others' rows; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME");
  command.callback([&all, name, options, &action] {
    action = [&all, name, options] {
      const auto study = std::find_if(all.begin(), all.end(), [&](const studies::Study& s) { return *name == s.name; });
      if (!options->cases.empty() && *name != "convergence")
        throw InputError("--case: found with the study \"" + *name + "\", allowed: with convergence");
      if (options->out.empty()) options->out = std::filesystem::path("results") / "studies" / *name;
      return study->run(*options) ? k_success : k_failed_check;
    };
  });
}

}  // namespace bake::cli

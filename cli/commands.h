// SPDX-License-Identifier: MIT
// The commands of the `bake` program. Each function adds commands to the command line. The command that the user requests sets `action`,
// which does the work and returns the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "solver/program/program.h"

namespace bake {
struct Scene;
}

namespace bake::cli {

void add_run_command(CLI::App& app, Action& action);
void add_scene_commands(CLI::App& app, Action& action);   ///< list, info, validate
void add_check_commands(CLI::App& app, Action& action);   ///< check, bless
void add_figure_commands(CLI::App& app, Action& action);  ///< figure, table
void add_report_command(CLI::App& app, Action& action);
void add_study_command(CLI::App& app, Action& action);
void add_compare_textbook_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);  ///< compare: benchmarks
void add_help_commands(CLI::App& app, Action& action);    ///< explain, version

/// "bake 0.2.0" and the commit it was built from.
std::string version_line();

/// The default folder of a scene's results: results/<scene>-<quality>.
std::filesystem::path default_results(const Scene& scene);

}  // namespace bake::cli

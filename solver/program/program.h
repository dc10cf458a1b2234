// SPDX-License-Identifier: MIT
// The command-line code that the programs bake, bake-mesh and bake-render share.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "solver/scene/settings.h"

namespace bake::cli {

/// The exit codes of the programs.
enum ExitCode { k_success = 0, k_failed_check = 1, k_wrong_use = 2, k_failed_run = 3 };

/// What a command does; it returns the exit code.
using Action = std::function<int()>;

/// Reads the command line of `main`, runs the `action` that the requested command has set, and returns the program's exit code.
/// Every error becomes one line `<program>: ...` on standard error. Waiting threads fall asleep soon (solver/program/waiting.h).
int run_program(CLI::App& app, const Action& action, int count, char** words);

/// Adds the option --quality, which sets `quality`.
void add_quality_option(CLI::App& command, Quality& quality);

/// Adds the option --threads, which sets `threads`; 0 means all cores.
void add_threads_option(CLI::App& command, int& threads);

/// Adds the option --set, which appends to `overrides`.
void add_set_option(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace bake::cli

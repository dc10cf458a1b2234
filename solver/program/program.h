// SPDX-License-Identifier: MIT
// What Bake's programs (bake, bake-mesh, ...) have in common on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "solver/scene/settings.h"

namespace bake::cli {

/// What the programs' exit codes mean.
enum ExitCode { k_success = 0, k_failed_check = 1, k_wrong_use = 2, k_failed_run = 3 };

/// What a command does; it returns the exit code.
using Action = std::function<int()>;

/// Reads the command line of `main`, does what the command that was asked for has left in `action`, and returns the program's exit code.
/// Every error becomes one line `<program>: ...` on standard error.
int run_program(CLI::App& app, const Action& action, int count, char** words);

/// The option --quality, which fills `quality`.
void add_quality_option(CLI::App& command, Quality& quality);

/// The option --threads, which fills `threads`; 0: all cores.
void add_threads_option(CLI::App& command, int& threads);

/// The option --set, which fills `overrides`.
void add_set_option(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace bake::cli

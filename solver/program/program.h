// SPDX-License-Identifier: MIT
// The command-line code that the programs bake, bake-mesh and bake-render share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "solver/scene/settings.h"

namespace bake::cli {

/// The exit codes of the programs.
enum ExitCode {
  k_success = 0,
  k_failed_check = 1,
  k_wrong_use = 2,   ///< or bad input, or a place that cannot be written, before a run has begun
  k_failed_run = 3,  ///< or interrupted; or what was found cannot be printed
};

/// What a command does; it returns the exit code.
using Action = std::function<int()>;

/// Reads the command line of `main`, runs the `action` that the requested command has set, and returns the program's exit code.
/// Every error becomes one line `<program>: ...` on standard error. Waiting threads fall asleep soon (solver/program/waiting.h).
int run_program(CLI::App& app, const Action& action, int count, char** words);

/// Once the command is requested, `work` is what it does; it returns the exit code, or nothing where it can only succeed or throw.
template <class Work>
void on_request(CLI::App& command, Action& action, Work work) {
  command.callback([&action, work] {
    if constexpr (std::is_void_v<decltype(work())>)
      action = [work] { return work(), k_success; };
    else
      action = work;
  });
}

/// Takes whole numbers from `low` to `high`, in base ten: CLI11 by itself reads 010 as 8. To be given to CLI::Option::transform.
CLI::Validator whole_number(std::int64_t low, std::int64_t high);

/// Takes numbers from `low` to `high`, of the `unit` if they have one, and no NaN, which CLI::Range lets pass, nor words, which it takes
/// for 0. To be given to CLI::Option::check.
CLI::Validator number(double low, double high, const char* unit = "");

/// Takes every text but the empty one. To be given to CLI::Option::check.
CLI::Validator not_empty();

/// Adds the option --quality, which sets `quality`.
void add_quality_option(CLI::App& command, Quality& quality);

/// Adds the option --threads, which sets `threads`; 0 means all cores.
void add_threads_option(CLI::App& command, int& threads);

/// Adds the option --set, which appends to `overrides`.
void add_set_option(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace bake::cli

// SPDX-License-Identifier: MIT
// Starts other programs and waits for them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bake {

/// How a child program ended.
struct ChildEnd {
  int start_error = 0;  ///< errno if it could not be started, else 0
  int exit_code = 0;    ///< or 128 + the signal that ended it, as in shells
};

/// Runs a program and waits. `words`: its name (looked for in PATH unless it has a slash) and its arguments. Its standard
/// input is empty; its output goes to the file `log`, or to our own output if `log` is empty. `meanwhile` is called some four times a
/// second until it ends. Where StopSignals are there and one has come, the child is asked to stop, too, and waited for.
ChildEnd run_child(std::vector<std::string> words, const std::filesystem::path& log = {}, const std::function<void()>& meanwhile = {});

}  // namespace bake

// SPDX-License-Identifier: MIT
// Other programs: started, waited for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake {

/// How a program that was called has ended.
struct ChildEnd {
  int start_error = 0;  ///< the system's number of the reason why it could not be started
  int exit_code = 0;    ///< or 128 + the signal that ended it, as shells have it
};

/// Runs a program and waits. `words`: its name (looked for in PATH unless it has a slash) and its arguments. It reads nothing; what it
/// prints goes to the file `log`, or where our own output goes if `log` is empty.
ChildEnd run_child(std::vector<std::string> words, const std::filesystem::path& log = {});

}  // namespace bake

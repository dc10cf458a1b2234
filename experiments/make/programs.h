// SPDX-License-Identifier: MIT
// The other programs of the house, bake-mesh and bake-render: found beside this one and called.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake {

/// Where a program of the house is. Throws InputError, saying how it is built, if it is not there.
std::filesystem::path find_program(const std::string& name);

/// Runs it and waits; what it prints goes to `log`. Throws InputError with its last line if it ends with exit code 2 (bad input), RunError
/// with that line if it fails in another way.
void call_program(const std::string& name, const std::vector<std::string>& arguments, const std::filesystem::path& log);

}  // namespace bake

// SPDX-License-Identifier: MIT
// Finds the programs bake, bake-mesh and bake-render beside this one and runs them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake {

/// The path of bake, bake-mesh or bake-render. If it is missing, throws InputError that tells how to build it.
std::filesystem::path find_program(const std::string& name);

/// Runs the program and waits; its output goes to `log`, and the last line of that, which tells how far it is, to
/// standard error, unless quiet; of several that work side by side one tells. If its exit code is 2 (bad input), throws InputError with its
/// last line; if it fails in another way, throws RunError with that line. `doing`: what it does, in these lines; empty: its name.
void call_program(const std::string& name, const std::vector<std::string>& arguments, const std::filesystem::path& log, bool quiet,
                  const std::string& doing = {});

}  // namespace bake

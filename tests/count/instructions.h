// SPDX-License-Identifier: MIT
// Instructions of one step of every combination of effects: a guard against slow code that asks no clock.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace bake::count {

/// By how much a count may leave the stored one. The same sources and compiler give the same count to the last instruction; what is left
/// is for the next patch release of a compiler.
inline constexpr double k_tolerance = 0.03;

/// Name of the combination and instructions of its step.
using Counts = std::vector<std::pair<std::string, double>>;

/// Instructions of the program's own code: the libraries' (clearing memory) suit themselves to the processor. Runs `program steps` under
/// callgrind, under a minute. Throws InputError without valgrind, std::runtime_error if it fails.
Counts count_instructions(const std::filesystem::path& program);

/// What is stored in reference/instructions.json:
/// { "compiler": "g++ 12", "instructions": { "heat": 1234567, ... }, "blessed": { "why": "...", "commit": "..." } }
struct Stored {
  std::string compiler;
  Counts counts;
};
/// Throws InputError, one line.
Stored read_stored(const std::filesystem::path& file);
void write_stored(const std::filesystem::path& file, const Counts& counts, const std::string& why, const std::string& commit);

/// Name and first version number of the compiler of this program: "g++ 12". Another makes other instructions.
std::string this_compiler();

/// A line per combination, and whether all are within the tolerance; one that is not stored, or not counted, is not.
std::pair<std::string, bool> compare(const Counts& counted, const Counts& stored);

}  // namespace bake::count

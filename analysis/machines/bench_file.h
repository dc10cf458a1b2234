// SPDX-License-Identifier: MIT
// Reads the measurements of `./bake bench` on a machine from their JSON file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bake::studies {

/// Rates of the machine itself, with one thread and with all. (docs: README, "How to measure a machine")
struct MachineLimit {
  double one_thread = 0, all_threads = 0;
};

struct BenchFile {
  std::filesystem::path file;
  std::string machine;       ///< processor and number of logical cores
  std::string program;       ///< version, commit, compiler
  double logical_cores = 1;  ///< 1 if the file does not say
  double load = 0;           ///< processes that waited or ran on average in the minute before the start; 0 if the file does not say
  MachineLimit triad_GB_per_s, single_GFLOPs, double_GFLOPs;
  std::vector<std::string> names;                      ///< of the benchmarks, in the file's order
  std::map<std::string, std::vector<double>> seconds;  ///< by name: one number per repetition [s per iteration of wall time]
};

/// Skips failed repetitions and aggregates (means, medians). Throws InputError, one line, if the file is missing, cut short, other JSON, or
/// without the machine's limits or single repetitions.
BenchFile read_bench_file(const std::filesystem::path& file);

}  // namespace bake::studies

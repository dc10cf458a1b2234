// SPDX-License-Identifier: MIT
// Studies measure how well the solver does and write tables of it. `bake study <name>` runs one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake::studies {

struct StudyOptions {
  bool quick = false;              ///< only the coarse resolutions that the tests use
  bool full = false;               ///< for accuracy: also what takes a night
  std::filesystem::path out;       ///< folder of the tables; created if missing
  std::vector<std::string> cases;  ///< for convergence and accuracy: only these are measured; the others stay as the folder has them
  bool measure_only = false;       ///< for accuracy: writes only the raw data of the chosen cases
  std::string reference;           ///< of accuracy: make this case's reference and nothing else
};

/// A study and its name. `run` prints its table, writes it to the folder, and returns whether all claims hold.
struct Study {
  const char* name;
  const char* meaning;  ///< one line for `bake study --help`
  bool (*run)(const StudyOptions& options);
};

/// All studies. To add one, add a line.
const std::vector<Study>& all_studies();

}  // namespace bake::studies

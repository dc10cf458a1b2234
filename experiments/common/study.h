// SPDX-License-Identifier: MIT
// Studies: what the solver is held to, measured and written down. `bake study <name>` runs one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake::studies {

struct StudyOptions {
  bool quick = false;              ///< the resolutions of the tests instead of all
  bool full = false;               ///< of accuracy: what takes a night, too
  std::filesystem::path out;       ///< folder of the tables; made if it is not there
  std::vector<std::string> cases;  ///< of convergence and accuracy: only these are measured, the others stay as they stand in the folder
  bool measure_only = false;       ///< of accuracy: touches no file but the raw data of the chosen cases
  std::string reference;           ///< of accuracy: make this case's reference and nothing else
};

/// A study by name. `run` prints its table, writes it to the folder, and returns whether everything held that was claimed.
struct Study {
  const char* name;
  const char* meaning;  ///< one line for `bake study --help`
  bool (*run)(const StudyOptions& options);
};

/// All studies. To add one, add a line.
const std::vector<Study>& all_studies();

}  // namespace bake::studies

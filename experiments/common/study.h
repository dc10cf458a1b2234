// SPDX-License-Identifier: MIT
// Studies measure how well the solver does and write tables of it. `bake study <name>` runs one.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
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

/// Measures what is not yet in <out>/accuracy/*.jsonl, with a line of progress for each; then writes accuracy.json, accuracy.md and the
/// charts of all that is there. Holds if every repeat found the same error and errors fall with dx. With `measure_only` the page is left
/// to a later call, and nothing is judged: such calls may run side by side, each with its own cases.
bool run_accuracy(const StudyOptions& options);
/// The others measure, with lines of progress on standard error, print their tables and write them: orders.json and orders.md,
/// departures.json, ...; that of effects also the chart effects.svg (.pdf, .csv), if gnuplot is there.
bool run_convergence(const StudyOptions& options);
bool run_departures(const StudyOptions& options);
bool run_effects(const StudyOptions& options);
bool run_stability(const StudyOptions& options);
bool run_surface(const StudyOptions& options);

/// Writes `measured`, with its provenance and whether it is the quick form, to <out>/<file>.json, and `page` to <out>/<file>.md. Throws
/// OutputError.
void write_tables(const StudyOptions& options, const std::string& file, nlohmann::json measured, const std::string& page);

}  // namespace bake::studies

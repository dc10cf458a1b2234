// SPDX-License-Identifier: MIT
// Finished measurements, one JSON object a line, so that a study that was stopped goes on where it stood.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/machines/limits.h"
#include "experiments/accuracy/case.h"

namespace bake::studies::accuracy {

/// What decides a measurement: case and variant (the scene with every default filled in, as a hash), and the program and processor.
struct Identity {
  nlohmann::json what, by;
};
Identity identity_of(const Case& c, const Variant& v, const Scene& scene);

/// The measurements of one case: <folder>/<case>.jsonl.
class RawData {
 public:
  /// Reads what is there. A last line without its end, which a stopped program left, is cut off, with a line about it on standard error;
  /// any other line that is damaged is refused. Throws InputError (file:line), OutputError.
  RawData(const std::filesystem::path& folder, const std::string& name);

  /// Measurements with this identity, in the order in which they were made.
  const std::vector<nlohmann::json>& of(const Identity& identity) const;
  /// Adds one, with the load and with the speed that one thread had shortly before, and flushes it to disk before it returns. Throws
  /// OutputError.
  void append(const Identity& identity, const Found& found, const bench::Speed& speed);

 private:
  std::filesystem::path file_;
  std::map<std::string, std::vector<nlohmann::json>> lines_;  ///< by identity
};

}  // namespace bake::studies::accuracy

// SPDX-License-Identifier: MIT
// A finished run, read back from its folder, and what is measured of it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "solver/io/ledger_file.h"

namespace bake {

/// The results of a run that is done.
class Results {
 public:
  /// Throws InputError if the folder holds no run, or one that is not done.
  explicit Results(const std::filesystem::path& folder);

  const nlohmann::json& description() const { return description_; }  ///< run.json
  /// A column of the ledger, one number a frame. Throws InputError if there is none of that name.
  std::vector<double> column(std::string_view name) const;
  double first(std::string_view name) const { return column(name).front(); }
  double last(std::string_view name) const { return column(name).back(); }
  /// Largest distance of the sum of columns from its first value, over all frames: what the books do not explain.
  double drift(std::initializer_list<std::pair<const char*, double>> columns_and_signs) const;

 private:
  std::filesystem::path folder_;
  nlohmann::json description_;
  Ledger ledger_;
};

/// A number that is measured of a run.
struct Metric {
  const char* name;
  const char* unit;
  const char* meaning;
  double (*measure)(const Results&);
};

/// The metric of that name. Throws InputError, with the nearest known name.
const Metric& find_metric(std::string_view name);

}  // namespace bake

// SPDX-License-Identifier: MIT
// Reads the results of a finished run.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "solver/io/frames.h"
#include "solver/io/ledger_file.h"

namespace bake {

/// The results of a run that is done.
class Results {
 public:
  /// Throws InputError if the folder holds no finished run.
  explicit Results(const std::filesystem::path& folder);

  const nlohmann::json& description() const { return description_; }  ///< run.json
  /// A column of the ledger, one number a frame. Throws InputError if there is none of that name.
  std::vector<double> column(std::string_view name) const;
  /// Number of the frame nearest to a time, of the last one if none is given.
  int frame_at(std::optional<double> time_s) const;
  /// Throws InputError if the frame is missing or damaged.
  FrameReader frame(int number) const;
  const std::filesystem::path& folder() const { return folder_; }
  double first(std::string_view name) const { return column(name).front(); }
  double last(std::string_view name) const { return column(name).back(); }
  /// The largest distance of a sum of columns from its first value, over all frames: the change that the ledger does not explain.
  double drift(std::initializer_list<std::pair<const char*, double>> columns_and_signs) const;

 private:
  std::filesystem::path folder_;
  nlohmann::json description_;
  Ledger ledger_;
};

}  // namespace bake

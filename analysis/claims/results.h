// SPDX-License-Identifier: MIT
// Reads the results of a finished run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "solver/core/vector3.h"
#include "solver/io/frames.h"
#include "solver/io/ledger_file.h"

namespace bake {

/// A frame as metrics read it: every number is finite. Else each function throws NoNumber with the frame's file, column and row.
class CheckedFrame {
 public:
  /// Throws InputError if the frame is missing or damaged.
  explicit CheckedFrame(const std::filesystem::path& path) : path_(path), reader_(path) {}

  double time_s() const { return reader_.time_s(); }
  std::size_t particles() const { return reader_.particles(); }
  std::vector<double> positions() const;  ///< x, y, z of each particle [m]
  /// A column with one number per particle. Throws InputError if there is none of that name.
  std::vector<float> column(const std::string& name) const;
  bool has(const std::string& name) const { return reader_.has(name); }
  std::vector<std::int64_t> identities() const { return reader_.identities(); }
  /// Row of each particle first, first + 1, ..., first + count - 1; -1 for those that are not in the frame.
  std::vector<std::int64_t> rows_by_identity(std::int64_t first, std::size_t count) const { return reader_.rows_by_identity(first, count); }

 private:
  std::filesystem::path path_;
  FrameReader reader_;
};

/// The place of the particle in a row of CheckedFrame::positions.
inline Vector3 position(const std::vector<double>& positions, std::size_t row) {
  return {positions[3 * row], positions[3 * row + 1], positions[3 * row + 2]};
}

/// For each particle of `now` its row in `start`; -1 for those that were not there.
std::vector<std::int64_t> rows_in(const CheckedFrame& start, const CheckedFrame& now);
/// The same where nothing was poured. Throws InputError for a particle that was not there at the start.
std::vector<std::size_t> rows_at_start(const CheckedFrame& start, const CheckedFrame& now);

/// The results of a run that is done.
class Results {
 public:
  /// Throws InputError if the folder holds no finished run.
  explicit Results(const std::filesystem::path& folder);

  const nlohmann::json& description() const { return description_; }  ///< run.json
  /// A column of the ledger, one number a frame. Throws InputError if there is none of that name, NoNumber if one is not finite.
  std::vector<double> column(std::string_view name) const;
  /// The same, whatever its numbers are: to be drawn.
  std::vector<double> column_as_it_is(std::string_view name) const;
  /// Number of the frame nearest to a time, of the last one if none is given. Throws NoNumber if that is more than half a frame away.
  int frame_at(std::optional<double> time_s) const;
  /// Throws InputError if the frame is missing or damaged.
  CheckedFrame frame(int number) const;
  const std::filesystem::path& folder() const { return folder_; }
  /// One number of a column, of the frame `row`. Throws as `column` does, but for numbers of that row alone.
  double at(std::string_view name, std::size_t row) const;
  double first(std::string_view name) const { return at(name, 0); }
  double last(std::string_view name) const { return at(name, ledger_.rows.size() - 1); }
  /// Throws NoNumber if there is but one frame: nothing has changed in a run that has not begun.
  void expect_change() const;
  /// The largest distance of a sum of columns from its first value, over all frames: the change that the ledger does not explain.
  /// Throws NoNumber if a number is not finite, or if there is but one frame.
  double drift(std::initializer_list<std::pair<const char*, double>> columns_and_signs) const;

 private:
  std::size_t column_number(std::string_view name) const;
  std::string place_of(std::string_view name, std::size_t row) const;

  std::filesystem::path folder_;
  nlohmann::json description_;
  Ledger ledger_;
};

}  // namespace bake

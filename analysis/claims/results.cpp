// SPDX-License-Identifier: MIT
#include "analysis/claims/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "analysis/claims/finite.h"
#include "solver/io/json_fault.h"

namespace bake {

namespace {

nlohmann::json read_description(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw InputError(fmt::format("{}: cannot open: there is no run here, allowed: a folder that bake run has written", file.string()));
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a description of a run: {}", file.string(), json_fault(error)));
  }
}

/// Throws NoNumber, for a frame's file and a column of `components` numbers per particle, at the first that is not finite.
template <class T>
std::vector<T> all_finite(std::vector<T> values, std::size_t components, const std::filesystem::path& file, const std::string& column) {
  for (std::size_t i = 0; i < values.size(); ++i)
    expect_finite(static_cast<double>(values[i]), [&] { return fmt::format("{}: {} in row {}", file.string(), column, i / components); });
  return values;
}

}  // namespace

std::vector<std::int64_t> rows_in(const CheckedFrame& start, const CheckedFrame& now) {
  std::vector<std::int64_t> ids = now.identities();
  const auto last = std::max_element(ids.begin(), ids.end());
  const auto rows = start.rows_by_identity(0, last == ids.end() ? 0 : static_cast<std::size_t>(*last) + 1);
  for (std::int64_t& id : ids) id = rows[static_cast<std::size_t>(id)];
  return ids;
}

std::vector<std::size_t> rows_at_start(const CheckedFrame& start, const CheckedFrame& now) {
  const auto found = rows_in(start, now);
  if (const auto missing = std::find(found.begin(), found.end(), -1); missing != found.end())
    throw InputError(fmt::format("found particle {}, which was not there at the start, allowed: bodies alone",
                                 now.identities()[static_cast<std::size_t>(missing - found.begin())]));
  return {found.begin(), found.end()};
}

std::vector<double> CheckedFrame::positions() const { return all_finite(reader_.positions(), 3, path_, "position"); }

std::vector<float> CheckedFrame::column(const std::string& name) const { return all_finite(reader_.column(name), 1, path_, name); }

Results::Results(const std::filesystem::path& folder)
    : folder_(folder), description_(read_description(folder / "run.json")), ledger_(read_ledger(folder / "ledger.csv")) {
  const std::string state = description_.value("/summary/state"_json_pointer, "unknown");
  if (state != "done")
    throw InputError(fmt::format("{}: found a run that is {}, allowed: one that is done (bake run --resume)", folder.string(), state));
  if (ledger_.rows.empty()) throw InputError(fmt::format("{}: found no row", (folder / "ledger.csv").string()));
}

std::size_t Results::column_number(std::string_view name) const {
  const auto at = std::find(ledger_.columns.begin(), ledger_.columns.end(), name);
  if (at == ledger_.columns.end()) throw InputError(fmt::format("{}: found no column {}", (folder_ / "ledger.csv").string(), name));
  return static_cast<std::size_t>(at - ledger_.columns.begin());
}

std::string Results::place_of(std::string_view name, std::size_t row) const {
  return fmt::format("{}:{}: {}", (folder_ / "ledger.csv").string(), row + 2, name);  // below the heading, counted from 1
}

std::vector<double> Results::column_as_it_is(std::string_view name) const {
  const std::size_t number = column_number(name);
  std::vector<double> values;
  for (const auto& row : ledger_.rows) values.push_back(row[number]);
  return values;
}

std::vector<double> Results::column(std::string_view name) const {
  std::vector<double> values = column_as_it_is(name);
  for (std::size_t row = 0; row < values.size(); ++row) expect_finite(values[row], [&] { return place_of(name, row); });
  return values;
}

double Results::at(std::string_view name, std::size_t row) const {
  const double value = ledger_.rows[row][column_number(name)];
  expect_finite(value, [&] { return place_of(name, row); });
  return value;
}

int Results::frame_at(std::optional<double> time_s) const {
  const auto times = column("time_s");
  return static_cast<int>(nearest_time(times, time_s.value_or(times.back()), folder_.string()));
}

CheckedFrame Results::frame(int number) const { return CheckedFrame(folder_ / "frames" / frame_name(number)); }

void Results::expect_change() const {
  if (ledger_.rows.size() < 2)
    throw NoNumber(fmt::format("{}: found one row, allowed: a run of some time", (folder_ / "ledger.csv").string()));
}

double Results::drift(std::initializer_list<std::pair<const char*, double>> columns_and_signs) const {
  expect_change();
  std::vector<double> sum(ledger_.rows.size());
  for (const auto& [name, sign] : columns_and_signs) {
    const auto values = column(name);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += sign * values[i];
  }
  double worst = 0;
  for (const double value : sum) worst = std::max(worst, std::abs(value - sum.front()));
  return worst;
}

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "analysis/claims/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "solver/core/errors.h"

namespace bake {

namespace {

nlohmann::json read_description(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw InputError(fmt::format("{}: cannot open: there is no run here, allowed: a folder that bake run has written", file.string()));
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a description of a run: {}", file.string(), error.what()));
  }
}

}  // namespace

Results::Results(const std::filesystem::path& folder)
    : folder_(folder), description_(read_description(folder / "run.json")), ledger_(read_ledger(folder / "ledger.csv")) {
  const std::string state = description_.value("/summary/state"_json_pointer, "unknown");
  if (state != "done")
    throw InputError(fmt::format("{}: found a run that is {}, allowed: one that is done (bake run --resume)", folder.string(), state));
  if (ledger_.rows.empty()) throw InputError(fmt::format("{}: found no row", (folder / "ledger.csv").string()));
}

std::vector<double> Results::column(std::string_view name) const {
  const auto at = std::find(ledger_.columns.begin(), ledger_.columns.end(), name);
  if (at == ledger_.columns.end()) throw InputError(fmt::format("{}: found no column {}", (folder_ / "ledger.csv").string(), name));
  std::vector<double> values;
  for (const auto& row : ledger_.rows) values.push_back(row[static_cast<std::size_t>(at - ledger_.columns.begin())]);
  return values;
}

int Results::frame_at(std::optional<double> time_s) const {
  const auto times = column("time_s");
  const double time = time_s.value_or(times.back());
  const auto nearest =
      std::min_element(times.begin(), times.end(), [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  return static_cast<int>(nearest - times.begin());
}

FrameReader Results::frame(int number) const { return FrameReader(folder_ / "frames" / frame_name(number)); }

double Results::drift(std::initializer_list<std::pair<const char*, double>> columns_and_signs) const {
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

// SPDX-License-Identifier: MIT
#include "claims/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "solver/scene/input_error.h"
#include "solver/scene/nearest.h"

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

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }
double smallest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

double gain(const Results& run, std::string_view column) {
  const double before = run.first(column);
  return before > 0 ? run.last(column) / before : std::nan("");
}

/// What the books of momentum along `axis` do not explain, over the mass.
double momentum_drift(const Results& run, char axis) {
  const std::string a(1, axis);
  const auto name = [&](const char* what) { return fmt::format("{}_{}_kg_m_per_s", what, a); };
  const auto momentum = name("momentum"), impulse = name("impulse"), remap = name("water_remap_momentum"),
             retired = name("retired_momentum"), emitted = name("emitted_momentum");
  return run.drift({{momentum.c_str(), 1}, {impulse.c_str(), -1}, {remap.c_str(), -1}, {retired.c_str(), 1}, {emitted.c_str(), -1}}) /
         (run.first("solid_mass_kg") + run.first("water_mass_kg"));
}

constexpr Metric k_metrics[] = {
    {"volume_gain", "1", "volume at the end over volume at the start", [](const Results& run) { return gain(run, "volume_m3"); }},
    {"height_gain", "1", "height at the end over height at the start", [](const Results& run) { return gain(run, "height_m"); }},
    {"extent_x_gain", "1", "extent along x at the end over that at the start", [](const Results& run) { return gain(run, "extent_x_m"); }},
    {"extent_y_gain", "1", "extent along y at the end over that at the start", [](const Results& run) { return gain(run, "extent_y_m"); }},
    {"height", "m", "height at the end", [](const Results& run) { return run.last("height_m"); }},
    {"largest_height", "m", "largest height on the way", [](const Results& run) { return largest(run.column("height_m")); }},
    {"surface", "m^2", "surface that touches air at the end", [](const Results& run) { return run.last("surface_m2"); }},
    {"water_lost_share", "1", "evaporated water over the water at the start",
     [](const Results& run) { return run.last("water_evaporated_kg") / run.first("water_mass_kg"); }},
    {"gas_made", "mol", "CO2 made until the end", [](const Results& run) { return run.last("gas_mol"); }},
    {"coldest", "C", "lowest particle temperature at the end", [](const Results& run) { return run.last("temperature_min_C"); }},
    {"mean_temperature", "C", "mean temperature by volume at the end", [](const Results& run) { return run.last("temperature_mean_C"); }},
    {"hottest_ever", "C", "highest particle temperature of any frame",
     [](const Results& run) { return largest(run.column("temperature_max_C")); }},
    {"coldest_ever", "C", "lowest particle temperature of any frame",
     [](const Results& run) { return smallest(run.column("temperature_min_C")); }},
    {"dissipated", "J", "plastic work until the end", [](const Results& run) { return run.last("dissipated_J"); }},
    {"solid_drift", "1", "largest unexplained change of the solid's mass, relative",
     [](const Results& run) {
       return run.drift({{"solid_mass_kg", 1}, {"retired_solid_kg", 1}, {"emitted_solid_kg", -1}}) / run.first("solid_mass_kg");
     }},
    {"water_drift", "1", "largest unexplained change of the water's mass, relative",
     [](const Results& run) {
       return run.drift({{"water_mass_kg", 1}, {"water_evaporated_kg", 1}, {"retired_water_kg", 1}, {"emitted_water_kg", -1}}) /
              run.first("water_mass_kg");
     }},
    {"heat_drift", "1", "largest unexplained change of the heat content, over the largest content",
     [](const Results& run) {
       return run.drift({{"heat_content_J", 1},
                         {"heat_exchanged_J", -1},
                         {"latent_heat_J", 1},
                         {"vapour_heat_J", 1},
                         {"expansion_heat_J", 1},
                         {"water_remap_heat_J", -1},
                         {"retired_heat_J", 1},
                         {"emitted_heat_J", -1}}) /
              largest(run.column("heat_content_J"));
     }},
    {"momentum_drift_x", "m/s", "largest unexplained change of momentum along x, over the mass",
     [](const Results& run) { return momentum_drift(run, 'x'); }},
    {"momentum_drift_y", "m/s", "the same along y", [](const Results& run) { return momentum_drift(run, 'y'); }},
    {"momentum_drift_z", "m/s", "the same along z", [](const Results& run) { return momentum_drift(run, 'z'); }},
    {"retired_particles", "1", "particles that left through open faces", [](const Results& run) { return run.last("retired_particles"); }},
};

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

const Metric& find_metric(std::string_view name) {
  std::vector<std::string> names;
  for (const Metric& metric : k_metrics) {
    if (metric.name == name) return metric;
    names.emplace_back(metric.name);
  }
  throw InputError(fmt::format("unknown metric '{}'; {}", name, suggestion(std::string(name), names)));
}

}  // namespace bake

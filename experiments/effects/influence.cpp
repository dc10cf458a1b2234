// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/machines/scenes.h"
#include "analysis/machines/stopwatch.h"
#include "experiments/effects/effects.h"
#include "solver/core/tell.h"
#include "solver/effects/all_effects.h"
#include "solver/run/ledger.h"
#include "solver/run/simulation.h"
#include "solver/scene/layout.h"
#include "solver/scene/reader.h"

namespace bake::studies {
namespace {

constexpr const char* k_scenes[] = {"fig15_bread/bread", "fig03_cookies/cookie", "teaching/drying_cube"};

constexpr const char* k_subgrid = "subgrid diffusion";  ///< no effect of its own: a setting of heat and of water

constexpr double k_round_off = 1e-6;  ///< of single precision: no yardstick is shorter

double ledger_number(const Simulation& simulation, const char* column) {
  const auto names = ledger_columns();
  const auto at = std::find(names.begin(), names.end(), column);
  if (at == names.end()) throw std::logic_error(std::string("no column ") + column);
  return ledger_row(simulation)[static_cast<std::size_t>(at - names.begin())];
}

/// What the run is for. Where an effect is left out, what it would have changed stays as it was.
std::vector<Quantity> quantities_of(const Simulation& simulation, const Scene& scene, double volume_before, double water_before) {
  std::vector<Quantity> quantities;
  const bool heats = scene.lists("heat");
  const double theta_0 = scene.materials.front().initial_temperature_C;
  quantities.push_back({"volume gain", "1", ledger_number(simulation, "volume_m3") / volume_before});
  quantities.push_back({"height", "m", ledger_number(simulation, "height_m")});
  quantities.push_back({"mean temperature", "C", heats ? ledger_number(simulation, "temperature_mean_C") : theta_0});
  quantities.push_back({"coldest", "C", heats ? ledger_number(simulation, "temperature_min_C") : theta_0});
  quantities.push_back({"water lost", "1", water_before > 0 ? 1 - ledger_number(simulation, "water_mass_kg") / water_before : 0});
  if (!scene.lists("motion")) quantities.erase(quantities.begin(), quantities.begin() + 2);  // of what cannot move
  return quantities;
}

std::string combination_of(const Scene& scene) {
  for (const bench::Combination& c : bench::k_combinations) {
    const auto listed = [&](const std::string& effect) { return scene.lists(effect); };
    if (!c.flip && c.effects.size() == scene.effects.size() && std::all_of(c.effects.begin(), c.effects.end(), listed)) return c.name;
  }
  throw std::logic_error(fmt::format("no combination of {}", fmt::join(scene.effects, ", ")));
}

Outcome run(const std::string& file, const std::vector<std::string>& left_out, double coarsening, double end_share) {
  ReadOptions reading{Quality::draft, {}};
  if (left_out == std::vector<std::string>{k_subgrid}) reading.overrides = {"heat.subgrid_diffusion=0", "water.subgrid_diffusion=0"};
  Scene scene = read_scene(std::filesystem::path(BAKE_SOURCE_DIR) / "experiments" / (file + ".toml"), reading);
  scene.grid.dx_m *= coarsening;
  std::erase_if(scene.effects, [&](const std::string& e) { return std::find(left_out.begin(), left_out.end(), e) != left_out.end(); });
  Outcome outcome{std::filesystem::path(file).filename().string(), left_out, combination_of(scene), scene.dx(), {}, 0, 0};
  const bench::Stopwatch watch;
  const double end = end_share * scene.run.end_s;
  const auto simulation = Simulation::begin(scene);
  const double volume = ledger_number(*simulation, "volume_m3"), water = ledger_number(*simulation, "water_mass_kg");
  simulation->advance(end, end);
  outcome.quantities = quantities_of(*simulation, scene, volume, water);
  outcome.particle_steps = static_cast<double>(simulation->counters().particle_steps);
  outcome.cpu_s = watch.cpu_s();
  tell_user("{} at dx {:.4g} m{}{}: {:.1f} s", outcome.scene, outcome.dx_m, left_out.empty() ? "" : " without ", fmt::join(left_out, ", "),
            outcome.cpu_s);
  return outcome;
}

}  // namespace

std::vector<std::string> with_dependents(const std::string& effect, const std::vector<std::string>& effects) {
  std::vector<std::string> gone{effect};
  for (std::size_t i = 0; i < gone.size(); ++i)
    for_each_effect([&]<class E>() {
      const auto is_in = [](const std::vector<std::string>& list, std::string_view name) {
        return std::find(list.begin(), list.end(), name) != list.end();
      };
      if (is_in({E::needs.begin(), E::needs.end()}, gone[i]) && is_in(effects, E::name) && !is_in(gone, E::name))
        gone.emplace_back(E::name);
    });
  return gone;
}

double Influence::error_of(std::size_t quantity) const {
  const double here = whole.quantities[quantity].value, there = other.quantities[quantity].value;
  return std::max(std::abs(here - there), k_round_off * std::abs(here));
}

double Influence::change_of(std::size_t quantity, const Outcome& without) const {
  return without.quantities[quantity].value - whole.quantities[quantity].value;
}

std::pair<double, std::string> Influence::largest(const Outcome& without) const {
  std::pair<double, std::string> most{0, "none"};
  for (std::size_t q = 0; q < whole.quantities.size(); ++q) {
    const double over = std::abs(change_of(q, without)) / std::max(error_of(q), k_round_off);
    if (over > most.first) most = {over, whole.quantities[q].name};
  }
  return most;
}

std::vector<Influence> measure_influence(const InfluenceOptions& options) {
  std::vector<Influence> all;
  for (const std::string file : k_scenes) {
    Influence influence{run(file, {}, options.coarsening, options.end_share), run(file, {}, options.other, options.end_share), {}};
    const Scene scene = read_scene(std::filesystem::path(BAKE_SOURCE_DIR) / "experiments" / (file + ".toml"), {Quality::draft, {}});
    for (const std::string& effect : scene.effects) {
      const auto gone = with_dependents(effect, scene.effects);
      // without motion a loaf keeps its shape, and elasticity is what motion needs: both or none
      if (effect == "motion" || effect == "elasticity") continue;
      influence.without.push_back(run(file, gone, options.coarsening, options.end_share));
    }
    influence.without.push_back(run(file, {k_subgrid}, options.coarsening, options.end_share));
    all.push_back(std::move(influence));
  }
  return all;
}

}  // namespace bake::studies

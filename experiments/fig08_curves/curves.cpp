// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "analysis/claims/finite.h"
#include "experiments/fig15_bread/dough.h"
#include "experiments/make/computed.h"
#include "solver/effects/plasticity.h"
#include "solver/run/simulation.h"

namespace bake {
namespace {

/// Yield stress and viscosity along a way of temperatures.
struct Way {
  std::vector<double> theta, tau_y, eta;
};

class Dough {
 public:
  explicit Dough(const Scene& scene) : k_(scene, scene.materials[0]) {}
  void add(Way& way, double theta, double theta_peak) const {
    Lanes<double> tau_y, eta;
    Plasticity::curves<Lanes<double>>(lanes<double>(theta), lanes<double>(theta_peak), k_, tau_y, eta);
    way.theta.push_back(theta);
    way.tau_y.push_back(tau_y[0]);
    way.eta.push_back(eta[0]);
  }
  /// The curves as they are for dough that is heated for the first time.
  Way heated(double from, double to) const {
    Way way;
    for (int i = 0; i <= 400; ++i) {
      const double theta = from + (to - from) * i / 400;
      add(way, theta, theta);
    }
    return way;
  }

 private:
  Plasticity::Constants<double> k_;
};

/// The solver warms a block to `peak` and cools it again: the properties on the way down.
Way cooled_from(double peak, const Dough& dough) {
  constexpr double k_cold = 4, k_half_s = 1;
  Curve held;
  held.points = {{0, k_cold}, {k_half_s, peak}, {2 * k_half_s, k_cold}, {2.1 * k_half_s, k_cold}};
  Scene scene = bread_scene();
  scene.effects = {"heat"};
  hold_block(scene, held);
  const auto simulation = Simulation::begin(scene);
  Way way;
  constexpr int k_samples = 42;
  for (int i = 1; i <= k_samples; ++i) {
    const double time = 2.1 * k_half_s * i / k_samples;
    simulation->advance(time, time + 2.1 * k_half_s / k_samples);
    const Snapshot now = simulation->snapshot();
    const double theta = now["temperature"][0], theta_peak = now["peak_temperature"][0];
    if (theta < theta_peak) dough.add(way, theta, theta_peak);
  }
  return way;
}

/// How much a way rises and falls altogether, relative to its largest value.
struct Turns {
  double risen = 0, fallen = 0;
  bool falls_first = false;
};
Turns turns_of(const std::vector<double>& values) {
  Turns turns;
  const double largest = largest_of(values);
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = (values[i] - values[i - 1]) / largest;
    if (change < 0 && turns.risen == 0) turns.falls_first = true;
    (change < 0 ? turns.fallen : turns.risen) += std::abs(change);
  }
  return turns;
}

/// Number of times that a way changes from falling to rising or back.
double changes_of_direction(const std::vector<double>& values) {
  if (std::isnan(largest_of(values))) return std::nan("");
  int changes = 0, last = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const int now = values[i] > values[i - 1] ? 1 : values[i] < values[i - 1] ? -1 : 0;
    if (now != 0 && last != 0 && now != last) ++changes;
    if (now != 0) last = now;
  }
  return changes;
}

double spread(const std::vector<double>& values) { return largest_of(values) / smallest_of(values) - 1; }

charts::Panel panel(const char* title, const char* label, const char* unit, const Plasticity::Material& material) {
  charts::Panel panel{title, {"temperature $θ$", "°C"}, {label, unit}};
  panel.x.range = {{0, 105}};
  for (int i = 0; i < 4; ++i)
    panel.rules.push_back({true, material.temperatures_C[static_cast<std::size_t>(i)], fmt::format("$θ_{}$", i + 1)});
  return panel;
}

/// The way up as a line, the way down as a dashed one with an arrow.
void add_ways(charts::Panel& panel, const Way& up, const Way& down, std::vector<double> Way::*value, double until) {
  charts::Series heated{"heated", charts::Kind::line}, cooled{"cooled again", charts::Kind::line}, arrow{"direction", charts::Kind::arrows};
  for (std::size_t i = 0; i < up.theta.size(); ++i) {
    if (up.theta[i] > until) break;
    heated.x.push_back(up.theta[i]);
    heated.y.push_back((up.*value)[i]);
  }
  heated.colour = charts::palette(0);
  panel.series.push_back(heated);
  if (until < down.theta.front()) return;
  cooled.x = down.theta;
  cooled.y = down.*value;
  cooled.dash = charts::Dash::dashed;
  const std::size_t middle = down.theta.size() * 3 / 5;
  arrow.x = {down.theta[middle]};
  arrow.y = {(down.*value)[middle]};
  arrow.x_end = {down.theta[middle + 2]};
  arrow.y_end = {(down.*value)[middle + 2]};
  arrow.in_legend = false;
  cooled.colour = arrow.colour = charts::palette(1);
  panel.series.push_back(cooled);
  panel.series.push_back(arrow);
}

charts::Chart chart_of(const Plasticity::Material& material, const Way& up, const Way& down) {
  charts::Panel yield = panel("(a)", "yield stress $τ_y$", "Pa", material);
  add_ways(yield, up, down, &Way::tau_y, 1e9);
  yield.y.range = {{0, 1.08 * material.yield_stress_Pa[3]}};
  charts::Panel closer = panel("(b)", "yield stress $τ_y$", "Pa", material);
  closer.rules.pop_back();
  add_ways(closer, up, down, &Way::tau_y, material.temperatures_C[2] + 2);
  closer.y.range = {{0, 1.5 * material.yield_stress_Pa[0]}};
  closer.x.range = {{0, material.temperatures_C[2] + 5}};
  charts::Panel viscosity = panel("(c)", "viscosity $η$", "Pa s", material);
  add_ways(viscosity, up, down, &Way::eta, 1e9);
  viscosity.y.range = {{0, 1.15 * material.viscosity_Pa_s[0]}};
  viscosity.legend = charts::Legend::bottom_left;
  return {"curves",
          "Yield stress and viscosity against temperature; past gelatinisation they keep their values when the dough cools",
          {yield, closer, viscosity},
          3};
}

}  // namespace

Computed fig08_curves() {
  const Scene scene = bread_scene();
  const auto& material = of<Plasticity>(scene.materials[0]);
  const Dough dough(scene);
  const Way up = dough.heated(0, 100), down = cooled_from(100, dough);
  const double below = material.temperatures_C[3] - 1;
  const Way not_set = cooled_from(below, dough);

  Way first_heated;  // the same temperatures for the first time
  for (const double theta : not_set.theta) dough.add(first_heated, theta, theta);
  double memory = 0;
  for (std::size_t i = 0; i < not_set.theta.size(); ++i) memory = larger(memory, std::abs(not_set.tau_y[i] / first_heated.tau_y[i] - 1));

  Computed computed;
  computed.charts = {chart_of(material, up, down)};
  computed.numbers = {
      {"yield_stress_turns", "1", "times that the yield stress changes between falling and rising, from 0 to 100 C",
       changes_of_direction(up.tau_y)},
      {"yield_stress_falls_first", "1", "1 if it falls before it rises", turns_of(up.tau_y).falls_first ? 1.0 : 0.0},
      {"viscosity_rise", "1", "how much the viscosity rises on the way from 0 to 100 C, relative to its largest value",
       turns_of(up.eta).risen},
      {"least_viscosity", "Pa s", "smallest viscosity from 0 to 100 C", smallest_of(up.eta), non_negative},
      {"coldest_on_return", "C", "temperature to which the block is cooled again", down.theta.back()},
      {"yield_stress_change_on_return", "1", "largest relative change of the yield stress while a block cools from 100 C",
       spread(down.tau_y)},
      {"viscosity_change_on_return", "1", "the same of the viscosity", spread(down.eta)},
      {"memory_below_gelatinisation", "1", "largest relative difference from the first heating while a block cools from just below it",
       memory},
  };
  return computed;
}

}  // namespace bake

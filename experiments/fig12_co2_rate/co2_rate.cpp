// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "analysis/claims/finite.h"
#include "experiments/fig15_bread/dough.h"
#include "experiments/make/computed.h"
#include "solver/effects/leavening.h"
#include "solver/run/simulation.h"

namespace bake {
namespace {

constexpr double k_cold = 0, k_hot = 100, k_end_s = 10;  ///< temperature rises evenly: 10 K a second
constexpr double k_slope = (k_hot - k_cold) / k_end_s;

Scene with(double theta_r, double width) {
  return bread_scene(
      {fmt::format("material.dough.peak_temperature_C={}", theta_r), fmt::format("material.dough.temperature_width_K={}", width)});
}

/// The solver's rate [mol/(m^3 s)] at a temperature.
class Rate {
 public:
  explicit Rate(const Scene& scene) : k_(scene, scene.materials[0]) {}
  double operator()(double theta) const { return Leavening::rate(lanes<double>(theta), k_)[0]; }

 private:
  Leavening::Constants<double> k_;
};

/// Temperature of the largest rate: the steps halve until they are small.
double peak_of(const Rate& rate) {
  double at = k_cold, best = rate(at);
  for (double step = 16; step > 1e-4; step /= 2)
    for (bool better = true; better;) {
      better = false;
      for (const double next : {at - step, at + step})
        if (rate(next) > best) at = next, best = rate(next), better = true;
    }
  return at;
}

/// Distance of the two temperatures at which the rate is half its largest, by bisection on either side.
double width_of(const Rate& rate) {
  const double peak = peak_of(rate), half = rate(peak) / 2;
  const auto edge = [&](double outside) {
    double inside = peak;
    for (int i = 0; i < 60; ++i) (rate((inside + outside) / 2) > half ? inside : outside) = (inside + outside) / 2;
    return inside;
  };
  return edge(peak + 1000) - edge(peak - 1000);
}

/// The gas that the solver has made in a block of dough whose temperature rises evenly [mol/m^3].
struct Produced {
  std::vector<double> theta, gas;
};
Produced warmed(Scene scene) {
  Curve held;
  held.points = {{0, k_cold}, {k_end_s, k_hot}};
  scene.effects = {"motion", "heat", "elasticity", "plasticity", "leavening"};
  hold_block(scene, held);
  const auto simulation = Simulation::begin(scene);
  Produced produced;
  constexpr int k_samples = 20;
  for (int i = 1; i <= k_samples; ++i) {
    const double time = k_end_s * i / k_samples;
    simulation->advance(time, time + k_end_s / k_samples);
    const Snapshot now = simulation->snapshot();
    produced.theta.push_back(now["temperature"][0]);
    produced.gas.push_back(now["produced_gas"][0]);
  }
  return produced;
}

/// Integral over time of alpha_g R_0 exp(-((theta - theta_r)/Delta theta)^2) while theta rises evenly to `theta` [mol/m^3].
double integral(const Scene& scene, double theta) {
  const Material& dough = scene.materials[0];
  const auto& m = of<Leavening>(dough);
  const auto part = [&](double at) { return std::erf((at - m.peak_temperature_C) / m.temperature_width_K); };
  const double peak_rate = m.production_mol_per_kgs * dough.density_kg_per_m3;
  return peak_rate * m.temperature_width_K * std::sqrt(M_PI) / 2 / k_slope * (part(theta) - part(k_cold));
}

charts::Series curve(const std::string& name, const Scene& scene, std::size_t colour) {
  charts::Series series{name};
  const Rate rate(scene);
  for (double theta = k_cold; theta <= k_hot; theta += 0.5) {
    series.x.push_back(theta);
    series.y.push_back(rate(theta));
  }
  series.colour = charts::palette(colour);
  return series;
}

}  // namespace

Computed fig12_co2_rate() {
  const Scene bread = bread_scene();
  const double theta_r = of<Leavening>(bread.materials[0]).peak_temperature_C;
  charts::Panel peaks{"(a)", {"temperature $θ$", "°C"}, {"d$n^g$/d$t$", "mol m$^{−3}$ s$^{−1}$"}};
  peaks.y.range = {{0, 1.9 * Rate(bread)(theta_r)}};  // room for the legend
  charts::Panel widths = peaks, gas{"(c)", {"temperature $θ$", "°C"}, {"CO$_2$ made $n^g$", "mol m$^{−3}$"}};
  widths.title = "(b)";
  Computed computed;
  double off_peak = 0, off_integral = 0;
  std::size_t colour = 0;
  for (const double at : {20.0, 30.0, 40.0}) {
    peaks.series.push_back(curve(fmt::format("$θ_r$ = {} °C", at), with(at, 20), colour++));
    off_peak = larger(off_peak, std::abs(peak_of(Rate(with(at, 20))) - at));
  }
  for (const double width : {10.0, 20.0, 40.0}) {
    const Scene scene = with(theta_r, width);
    const std::string name = fmt::format("Δ$θ$ = {} K", width);
    widths.series.push_back(curve(name, scene, colour));
    charts::Series exact{name}, found{"", charts::Kind::points};
    for (double theta = k_cold; theta <= k_hot; theta += 1) {
      exact.x.push_back(theta);
      exact.y.push_back(integral(scene, theta));
    }
    const Produced produced = warmed(scene);
    found.x = produced.theta;
    found.y = produced.gas;
    found.name = "solver, " + name;
    found.in_legend = false;
    exact.colour = found.colour = charts::palette(colour++);
    const bool steep = width > 30;  // no room above it: named on its left
    gas.marks.push_back(
        {steep ? 62. : 78., integral(scene, steep ? 68 : 78), name, steep ? charts::Side::left : charts::Side::above, false, exact.colour});
    gas.series.push_back(exact);
    gas.series.push_back(found);
    computed.numbers.push_back({fmt::format("width_at_half_rate_{}", width), "K",
                                fmt::format("width of the curve at half its height, for a Delta theta of {} K", width),
                                width_of(Rate(scene))});
    for (std::size_t i = 0; i < produced.theta.size(); ++i)
      off_integral = larger(off_integral, std::abs(produced.gas[i] - integral(scene, k_slope * k_end_s * static_cast<double>(i + 1) / 20)) /
                                              integral(scene, k_hot));
  }
  peaks.legend = widths.legend = charts::Legend::top_right;
  computed.numbers.push_back({"peak_offset", "K", "largest distance of the fastest reaction from theta_r, for three of these", off_peak});
  computed.numbers.push_back({"peak_rate", "mol/(m^3 s)", "rate at the peak of bread's dough", Rate(bread)(theta_r)});
  computed.numbers.push_back({"produced_gas_error", "1",
                              "largest distance of the gas that the solver makes from the integral, relative to its end, for three widths",
                              off_integral});
  computed.charts = {
      {"co2_rate",
       "Rate of the leavening reaction against temperature for several peaks and widths, and the gas made in a warming block",
       {peaks, widths, gas},
       3}};
  return computed;
}

}  // namespace bake

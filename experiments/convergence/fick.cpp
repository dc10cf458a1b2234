// SPDX-License-Identifier: MIT
// Water in a bar at 1 C, K = 2 m^2/(s K): s_t = (K theta s s_x)_x.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

using std::numbers::pi;

constexpr double k_middle = 0.5, k_swing = 1e-6;  // the diffusivity K theta s is 1 m^2/s but for a share of 1e-6

Bar bar_at_one_degree(double diffusivity) {
  Bar bar;
  bar.effects = "water";
  bar.material =
      fmt::format("initial_temperature_C = 1\ninitial_saturation = {}\nwater_density_kg_per_m3 = 1\ndiffusivity_m2_per_sK = {}\n", k_middle,
                  diffusivity);
  return bar;
}

std::vector<double> saturation(const Snapshot& now) {
  std::vector<double> s = now["water_mass"];
  const auto& V = now["initial_volume"];
  for (std::size_t i = 0; i < s.size(); ++i) s[i] /= V[i];
  return s;
}

}  // namespace

std::vector<Errors> fick(bool quick) {
  constexpr double t = 0.05;
  Errors e;
  e.quantity = fmt::format("saturation at Fo = {}, rms over 0.2 < x < 0.8, relative to its swing", t);
  e.refined = "cells";
  e.low = 1.8, e.high = 2.2;
  e.why = "second order: nothing happens at a surface";
  e.refinements = quick ? std::vector<double>{16, 32, 64} : std::vector<double>{8, 16, 32, 64, 128};
  for (const double n : e.refinements) {
    Bar bar = bar_at_one_degree(2);
    bar.cells = static_cast<int>(n);
    bar.end_s = t;
    bar.state = [](double x) { return fmt::format("saturation = {:.17g}", k_middle + k_swing * std::cos(pi * x)); };
    const Snapshot now = bar.end()->snapshot();
    const std::vector<double> s = saturation(now);
    e.errors.push_back(root_mean_square(differences(
                           now, [&](std::size_t i) { return s[i]; },
                           [](double x) { return k_middle + k_swing * std::exp(-pi * pi * t) * std::cos(pi * x); }, k_interior)) /
                       k_swing);
  }
  return {e};
}

/// Barenblatt's source for s_t = (s s_x)_x: s = t^(-1/3) (a^2 - xi^2) / 6 with xi = (x - 1/2) t^(-1/3), inside |xi| < a. At `first` the
/// middle has 0.6 and the front stands at 0.15 m: a^2 = 3.6 first^(1/3) = 0.0225 first^(-2/3). At `last` the front stands at 0.3 m.
namespace source {

namespace {
constexpr double first = 0.00625, last = 8 * first, peak = 0.6, width = 0.15;
// Solid without any water stays dry: particles gain in proportion to the water they have. The dry part therefore starts with a trace.
constexpr double trace = 1e-6;
double saturation_at(double x, double t) {
  const double stretch = std::cbrt(t / first), xi = (x - 0.5) / stretch;
  return std::max(0.0, peak / stretch * (1 - xi * xi / (width * width)));
}
}  // namespace

double duration_s() { return last - first; }

Bar bar(int cells) {
  Bar bar = bar_at_one_degree(1);
  bar.cells = cells;
  bar.end_s = duration_s();
  bar.state = [](double x) { return fmt::format("saturation = {:.17g}", std::max(trace, saturation_at(x, first))); };
  return bar;
}

double saturation_error(const Snapshot& end) {
  const std::vector<double> s = saturation(end);
  return root_mean_square(differences(
             end, [&](std::size_t i) { return s[i]; }, [](double x) { return saturation_at(x, last); }, k_all)) /
         saturation_at(0.5, last);
}

}  // namespace source

std::vector<Errors> barenblatt(bool quick) {
  Errors profile, spread, kept;
  profile.quantity = "saturation when the front is twice as far, rms, relative to the peak";
  profile.low = 1.3, profile.high = 1.9;
  profile.why =
      "between 1 and 2, by the kink of the front, where grad s jumps: an error of the order dx on a length of dx, 3/2 in the mean square. "
      "Where all is wet the order is 2 (fick)";
  spread.quantity = "distance of the front from Barenblatt's, in cells, from the second moment";
  spread.figure = Errors::Figure::largest_error;
  spread.high = 0.1;
  spread.why = "gains are shared by volume, so that the front does not wait for water that is there already";
  kept.figure = Errors::Figure::largest_error;
  kept.high = 1e-12;
  kept.why = "what one node loses another gains: round-off";
  kept.quantity = "total water";
  profile.refined = spread.refined = kept.refined = "cells";
  profile.refinements = spread.refinements = kept.refinements =
      quick ? std::vector<double>{32, 64, 128} : std::vector<double>{32, 64, 128, 256};
  for (const double n : profile.refinements) {
    const Bar bar = source::bar(static_cast<int>(n));
    const auto simulation = bar.begin();
    const double before = simulation->total(total::water_mass);
    run_to(*simulation, bar.end_s);
    kept.errors.push_back(std::abs(simulation->total(total::water_mass) / before - 1));
    const Snapshot now = simulation->snapshot();
    profile.errors.push_back(source::saturation_error(now));
    const std::vector<double> s = saturation(now);
    double zeroth = 0, second = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      zeroth += s[i];
      second += s[i] * std::pow(now.position[i][0] - 0.5, 2);
    }
    const double front = 2 * source::width;
    spread.errors.push_back(std::abs(std::sqrt(5 * second / zeroth) - front) / bar.dx());
  }
  return {profile, spread, kept};
}

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// A closed bar, hot at one end and evenly wet, in whose pores vapour goes to the cold end, condenses there and warms it, while water comes
// back by diffusion. No formula says how, but finite volumes along the bar share nothing with the solver but the equations:
//     d(h)/dt     = -d/dx(-kappa theta_x + c_w theta q + L_v j_v),   h = (c_s rho_s + c_w rho_w) theta
//     d(rho_w)/dt = -dq/dx,   q = -K theta rho_w s_x + j_v,   j_v = -n D_v d/dx(a_w rho_sat)
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

constexpr double k_damp_duration = 0.05;  // heat has gone a third of the bar
constexpr double k_damp_wetness = 0.5, k_damp_pores = 0.5,
                 k_damp_diffusivity = 0.01;  // s_0, n, K; half a kilogram of water and of solid in a cubic metre
constexpr double k_damp_vapour = 1, k_damp_latent_heat = 100, k_damp_hygroscopic = 0.8;  // D_v, L_v, X_h
double first_temperature(double x) { return 50 + 30 * std::cos(std::numbers::pi * x); }

/// The density of saturated vapour by Antoine's equation and the law of gases, times the activity.
double vapour(double theta, double water) {
  const double pressure = 133.322368 * std::pow(10, 8.07131 - 1730.63 / (233.426 + theta));
  return pressure * 0.018015 / (8.314 * (theta + 273.15)) / (1 + std::pow(k_damp_hygroscopic * (1 - k_damp_wetness) / water, 3));
}

struct Column {
  std::vector<double> theta, water;
};

/// Central differences and short explicit steps: second order in the cells' width of a 300th, an error of some 1e-5.
Column by_finite_volumes() {
  constexpr std::size_t n = 300;
  constexpr double dx = 1. / n;
  const auto steps = static_cast<int>(std::lround(k_damp_duration / (0.1 * dx * dx)));
  const double dt = k_damp_duration / steps;
  std::vector<double> theta(n), water(n, k_damp_wetness), heat(n), density(n), water_flux(n + 1), heat_flux(n + 1);  // of the lower faces
  for (std::size_t i = 0; i < n; ++i) heat[i] = first_temperature((static_cast<double>(i) + 0.5) * dx);
  for (int step = 0;; ++step) {
    for (std::size_t i = 0; i < n; ++i) theta[i] = heat[i] / (1 - k_damp_wetness + water[i]), density[i] = vapour(theta[i], water[i]);
    if (step == steps) return {theta, water};
    for (std::size_t i = 1; i < n; ++i) {
      const double between = 0.5 * (theta[i] + theta[i - 1]), steam = k_damp_pores * k_damp_vapour * (density[i - 1] - density[i]) / dx;
      water_flux[i] = k_damp_diffusivity * between * 0.5 * (water[i] + water[i - 1]) * (water[i - 1] - water[i]) / dx + steam;
      heat_flux[i] = (theta[i - 1] - theta[i]) / dx + between * water_flux[i] + k_damp_latent_heat * steam;
    }
    for (std::size_t i = 0; i < n; ++i) {
      water[i] += dt / dx * (water_flux[i] - water_flux[i + 1]);
      heat[i] += dt / dx * (heat_flux[i] - heat_flux[i + 1]);
    }
  }
}

/// Linear between the middles of cells.
double at(const std::vector<double>& cells, double x) {
  const double place = x * static_cast<double>(cells.size()) - 0.5;
  const double low = std::min(std::max(std::floor(place), 0.), static_cast<double>(cells.size() - 2));
  const auto i = static_cast<std::size_t>(low);
  return cells[i] + (place - low) * (cells[i + 1] - cells[i]);
}

/// `hygroscopic`: X_h; `diffusivity`: K; `first`: temperature over x.
Bar wet_bar(double cells, double hygroscopic, double diffusivity, const Profile& first) {
  Bar bar;
  bar.cells = static_cast<int>(cells);
  bar.end_s = k_damp_duration;
  bar.effects = "heat, water";
  bar.material = fmt::format(
      "initial_temperature_C = 50\ninitial_saturation = {}\ninitial_porosity = {}\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n"
      "water_density_kg_per_m3 = 1\ndiffusivity_m2_per_sK = {}\nvapour_diffusivity_m2_per_s = {}\nhygroscopic_water_kg_per_kg = {}\n",
      k_damp_wetness, k_damp_pores, diffusivity, k_damp_vapour, hygroscopic);
  bar.tables = fmt::format("[heat]\nwater_specific_heat_J_per_kgK = 1\n[water]\nlatent_heat_J_per_kg = {}\n", k_damp_latent_heat);
  bar.state = [first](double x) { return fmt::format("temperature_C = {:.17g}", first(x)); };
  return bar;
}

/// Root mean squares over the interior.
struct Distance {
  double heat, water;
};
Distance distance(const Bar& bar, const Profile& theta, const Profile& water) {
  const Snapshot now = bar.end()->snapshot();
  const auto &found = now["temperature"], &m = now["water_mass"], &V = now["initial_volume"];
  return {root_mean_square(differences(
              now, [&](std::size_t i) { return found[i]; }, theta, k_interior)),
          root_mean_square(differences(
              now, [&](std::size_t i) { return m[i] / V[i]; }, water, k_interior))};
}

Errors second_order(const char* quantity, bool quick) {
  Errors e;
  e.quantity = quantity;
  e.refined = "cells";
  e.low = 1.8, e.high = 2.2;
  e.why = "second order: nothing happens at a surface";
  e.refinements = quick ? std::vector<double>{16, 32, 64} : std::vector<double>{8, 16, 32, 64, 128};
  return e;
}

}  // namespace

/// Where dough is wet, a_w = 1, small differences of temperature decay by kappa + L_v n D_v d rho_sat / d theta, and take water with them.
std::vector<Errors> vapour_cosine(bool quick) {
  constexpr double mean = 60, swing = 1e-3, pi = std::numbers::pi;
  const double slope = (vapour(mean + 0.01, 1e9) - vapour(mean - 0.01, 1e9)) / 0.02;
  const double carried = k_damp_pores * k_damp_vapour * slope, effective = 1 + k_damp_latent_heat * carried;  // rho c = 1 J/(m^3 K)
  const double left = std::exp(-pi * pi * effective * k_damp_duration), moved = carried / effective * (1 - left);
  Errors heat = second_order("temperature, rms over 0.2 < x < 0.8, over its swing", quick);
  Errors water = second_order("water that has gone to the cold end, rms over 0.2 < x < 0.8, over its swing", quick);
  for (const double n : heat.refinements) {
    const Bar bar = wet_bar(n, 1e-4, 0, [](double x) { return mean + swing * std::cos(pi * x); });
    const Distance d = distance(
        bar, [&](double x) { return mean + left * swing * std::cos(pi * x); },
        [&](double x) { return k_damp_wetness - moved * swing * std::cos(pi * x); });
    heat.errors.push_back(d.heat / swing);
    water.errors.push_back(d.water / (moved * swing));
  }
  return {heat, water};
}

std::vector<Errors> vapour_in_a_bar(bool quick) {
  const Column exact = by_finite_volumes();
  Errors heat = second_order("temperature, rms over 0.2 < x < 0.8, over the first swing of 60 K", quick);
  Errors water = second_order("water, rms over 0.2 < x < 0.8, over what the cold end has gained", quick);
  for (const double n : heat.refinements) {
    const Distance d = distance(
        wet_bar(n, k_damp_hygroscopic, k_damp_diffusivity, first_temperature), [&](double x) { return at(exact.theta, x); },
        [&](double x) { return at(exact.water, x); });
    heat.errors.push_back(d.heat / 60);
    water.errors.push_back(d.water / (exact.water.back() - k_damp_wetness));
  }
  return {heat, water};
}

}  // namespace bake::studies

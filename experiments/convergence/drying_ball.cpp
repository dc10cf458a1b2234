// SPDX-License-Identifier: MIT
// A wet ball at rest in hot air: heat and water go along its radius and through its surface, each where the other acts. No formula
// says how, but finite volumes in the radius alone share nothing with the solver but the equations, and cost nothing:
//     d(h)/dt   = -div(-kappa grad theta + c_w theta q),      h = (c_s rho_s + c_w rho_w) theta
//     d(rho_w)/dt = -div q,                                   q = -K theta rho_w grad s, s = rho_w / rho_0
//     at the surface   q.n = beta_w theta s,   -kappa d theta/dn = beta (theta - theta_out) + L q.n
#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "experiments/common/study_scene.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

// Radius, density of the mixture and of water, specific heats, beta and theta_out are 1. Water comes to the surface as easily as it
// leaves it over K rho_0 s / beta_w = 0.4 of the radius: several cells of all grids here.
constexpr double k_conductivity = 0.5, k_latent_heat = 1, k_theta = 0.2;      // kappa, L, first temperature
constexpr double k_diffusivity = 0.1, k_evaporation = 0.05, k_wetness = 0.2;  // K, beta_w, first saturation
constexpr double k_duration = 1;

struct Dried {
  double water_lost;   ///< over the first water
  double heat_gained;  ///< over the first heat
};

/// Central differences and short explicit steps: second order in the shells' width of a hundredth, an error of some 1e-4.
Dried dry_in_shells() {
  constexpr std::size_t n = 100;
  constexpr double dr = 1. / n;
  const auto steps = static_cast<int>(std::lround(k_duration / (0.2 * dr * dr / k_conductivity)));
  const double dt = k_duration / steps;
  std::vector<double> volume(n), solid(n), water(n), heat(n), theta(n), s(n);
  std::vector<double> area(n + 1), water_flux(n + 1), heat_flux(n + 1);  // of the shells' lower faces
  for (std::size_t i = 0; i <= n; ++i) area[i] = 4 * std::numbers::pi * std::pow(dr * static_cast<double>(i), 2);
  for (std::size_t i = 0; i < n; ++i) {
    volume[i] = 4. / 3 * std::numbers::pi * (std::pow(dr * static_cast<double>(i + 1), 3) - std::pow(dr * static_cast<double>(i), 3));
    solid[i] = (1 - k_wetness) * volume[i];
    water[i] = k_wetness * volume[i];
    heat[i] = k_theta * volume[i];
  }
  const auto sum = [](const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.); };
  const auto at_surface = [](const std::vector<double>& of) { return of[n - 1] + 0.5 * (of[n - 1] - of[n - 2]); };
  const double first_water = sum(water), first_heat = sum(heat);
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < n; ++i) theta[i] = heat[i] / (solid[i] + water[i]), s[i] = water[i] / volume[i];
    for (std::size_t i = 1; i < n; ++i) {
      const double mobility = k_diffusivity * 0.5 * (theta[i] * s[i] + theta[i - 1] * s[i - 1]);
      water_flux[i] = mobility * (s[i - 1] - s[i]) / dr * area[i];
      heat_flux[i] = k_conductivity * (theta[i - 1] - theta[i]) / dr * area[i] + 0.5 * (theta[i] + theta[i - 1]) * water_flux[i];
    }
    const double theta_n = at_surface(theta);
    water_flux[n] = k_evaporation * theta_n * at_surface(s) * area[n];
    heat_flux[n] = (theta_n - 1) * area[n] + (k_latent_heat + theta_n) * water_flux[n];
    for (std::size_t i = 0; i < n; ++i) {
      water[i] += dt * (water_flux[i] - water_flux[i + 1]);
      heat[i] += dt * (heat_flux[i] - heat_flux[i + 1]);
    }
  }
  return {1 - sum(water) / first_water, sum(heat) / first_heat - 1};
}

StudyScene ball(double cells) {
  StudyScene setting = ball_in_air::setting(cells, k_conductivity);
  setting.effects = "heat, water";
  setting.frame_s = k_duration;
  setting.time = "";
  setting.threads = omp_get_num_procs();
  setting.material +=
      fmt::format("initial_saturation = {}\nwater_density_kg_per_m3 = 1\ndiffusivity_m2_per_sK = {}\nevaporation_kg_per_m2sK = {}\n",
                  k_wetness, k_diffusivity, k_evaporation);
  setting.tables += fmt::format("[heat]\nwater_specific_heat_J_per_kgK = 1\n[water]\nlatent_heat_J_per_kg = {}\n", k_latent_heat);
  setting.overrides = {fmt::format("material.0.initial_temperature_C={}", k_theta), "oven.temperature_C=1"};
  return setting;
}

}  // namespace

std::vector<Errors> drying_ball(bool quick) {
  const Dried exact = dry_in_shells();
  Errors water, heat;
  water.quantity = "water lost, against finite volumes in the radius";
  heat.quantity = "heat gained, against finite volumes in the radius";
  water.low = 1.2, water.high = 2.2;
  water.why =
      "between first and second order: the layer between the surface and the nodes resists as the dough of that depth would, once drying "
      "has "
      "gone so deep; until then as that of a half-space which dries, as if the nodes' own water had not fallen yet";
  heat.figure = Errors::Figure::largest_error;
  heat.high = 0.02;
  heat.why = "heat takes the resistance of its layer along; what is left is the heat of the water that left";
  water.refined = heat.refined = "cells in the radius";
  water.refinements = heat.refinements = quick ? std::vector<double>{11, 15, 20} : std::vector<double>{11, 15, 20, 28};
  for (const double cells : water.refinements) {
    const auto s = ball(cells).begin();
    const double first_water = s->total(total::water_mass), first_heat = s->total(total::heat_content);
    run_to(*s, k_duration);
    water.errors.push_back(std::abs((1 - s->total(total::water_mass) / first_water) / exact.water_lost - 1));
    heat.errors.push_back(std::abs((s->total(total::heat_content) / first_heat - 1) / exact.heat_gained - 1));
  }
  return {water, heat};
}

}  // namespace bake::studies

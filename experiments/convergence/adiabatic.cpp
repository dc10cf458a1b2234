// SPDX-License-Identifier: MIT
// Dough that is squeezed and stretched without conduction: theta_K = theta_0K J^(-beta_T / (rho_0 c)) on every particle.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

std::vector<Errors> adiabatic(bool quick) {
  // E = 1 Pa, nu = 0: beta_T = 3 K alpha = alpha; rho_0 c = 0.01 J/(m^3 K)
  constexpr double alpha = 1e-3, capacity = 0.01, power = alpha / capacity, theta_0K = 293.15, speed = 0.2;
  Errors e;
  e.quantity = "temperature against J, rms, relative to the rms of its change";
  e.refined = "cells";
  e.low = 0.85, e.high = 1.3;
  e.why = "first order in time: forward Euler of d theta_K / theta_K = -beta_T / (rho_0 c) d J / J, with dt in proportion to dx";
  e.refinements = quick ? std::vector<double>{16, 32, 64} : std::vector<double>{16, 32, 64, 128, 256};
  for (const double n : e.refinements) {
    Bar bar;
    bar.effects = "motion, heat, elasticity";
    bar.material = fmt::format(
        "young_modulus_Pa = 1\npoisson_ratio = 0\ninitial_temperature_C = 20\nexpansion_per_K = {}\nspecific_heat_J_per_kgK = {}\n"
        "conductivity_W_per_mK = 0\n",
        alpha, capacity);
    bar.cells = static_cast<int>(n);
    bar.air = bar.cells / 4;
    bar.time = "safety = 0.5";
    bar.end_s = 0.5;  // a quarter of the bar's period: J is 0.8 to 1.2
    bar.state = [](double x) { return fmt::format("velocity_m_per_s = [{:.17g}, 0, 0]", speed * std::cos(std::numbers::pi * x)); };
    const Snapshot now = bar.end()->snapshot();
    const auto &theta = now["temperature"], &J = now["volume_ratio"];
    std::vector<double> error, change;
    for (std::size_t i = 0; i < J.size(); ++i) {
      const double exact = theta_0K * std::pow(J[i], -power);
      error.push_back(theta[i] + 273.15 - exact);
      change.push_back(exact - theta_0K);
    }
    e.errors.push_back(root_mean_square(error) / root_mean_square(change));
  }
  return {e};
}

}  // namespace bake::studies

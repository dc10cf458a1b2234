// SPDX-License-Identifier: MIT
// A sphere so conductive that it has one temperature cools in air: d theta / dt = -3 beta / (rho c R) theta.
#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

StudyScene ball_in_air::setting(double cells_in_radius, double conductivity_W_per_mK) {
  StudyScene setting;
  setting.dx = 1 / cells_in_radius;
  setting.low = {-2, -2, -2};
  setting.high = {2, 2, 2};
  setting.material +=
      fmt::format("initial_temperature_C = 1\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = {}\n", conductivity_W_per_mK);
  setting.tables = "[oven]\ntemperature_C = 0\nheat_transfer_coefficient_W_per_m2K = 1\n";
  setting.shape = fmt::format("sphere = {{ centre_m = [{}, {}, {}], radius_m = 1 }}", centre[0], centre[1], centre[2]);
  return setting;
}

double ball_in_air::temperature(double r, double time) {
  double sum = 0;
  for (int n = 1; n < 30; ++n) {
    const double z = (n - 0.5) * std::numbers::pi;
    sum += 4 * (std::sin(z) - z * std::cos(z)) / (2 * z - std::sin(2 * z)) * std::exp(-z * z * time) * std::sin(z * r) / (z * r);
  }
  return sum;
}

std::vector<Errors> lumped_sphere(bool quick) {
  constexpr double biot = 1e-3, dt = 0.01;  // rho c = beta = R = 1
  constexpr int steps = 3;
  Errors rate, area;
  rate.quantity = "rate of cooling against 3 beta / (rho c R)";
  rate.figure = Errors::Figure::largest_error;
  rate.high = 0.015;
  rate.why =
      "the rate's error is the area's: what smoothing takes off a curved surface is put back from its curvature, and what is left is the "
      "noise "
      "of the particles, a few promille whatever dx";
  area.quantity = "rate of cooling against beta A / (rho c V), A and V as measured";
  area.figure = Errors::Figure::largest_error;
  area.high = 5e-4;
  area.why = "the sphere loses beta A theta: all that is left is that its surface is cooler than its mean, Bi / 5";
  rate.refined = area.refined = "cells in the radius";
  rate.refinements = area.refinements = quick ? std::vector<double>{4, 6, 9, 13} : std::vector<double>{4, 6, 9, 13, 20};
  for (const double n : rate.refinements) {
    StudyScene setting = ball_in_air::setting(n, 1 / biot);
    setting.threads = omp_get_num_procs();
    setting.frame_s = dt;
    setting.tables += "[heat]\nintegrator = \"backward_euler\"\nimplicit_step_factor = 1e9\n";
    const auto s = setting.begin();
    const double before = s->total(total::heat_content), volume = s->total(total::volume);
    for (int i = 1; i <= steps; ++i) run_to(*s, i * dt);
    // backward Euler: each step divides by 1 + rate dt, exactly
    const double found = (std::pow(before / s->total(total::heat_content), 1. / steps) - 1) / dt;
    rate.errors.push_back(std::abs(found / 3 - 1));
    area.errors.push_back(std::abs(found / (s->booked(booked::area) / volume) - 1));
  }
  return {rate, area};
}

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// The two Eulers of heat on one grid: only the step is refined. Without subgrid diffusion, which lags by a step and adds an error of its
// own, of second order in long ones.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

constexpr double k_end = 0.05;

/// Temperatures, in the order of identities, after `steps` equal steps.
std::vector<double> temperatures(const char* integrator, double steps) {
  Bar bar;
  bar.end_s = k_end;
  bar.material = "initial_temperature_C = 0\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  bar.tables = fmt::format("[heat]\nintegrator = \"{}\"\ntolerance = 1e-12\nsubgrid_diffusion = 0\n", integrator);
  bar.time = fmt::format("safety = 1\nlargest_step_s = {:.17g}\n", k_end / (steps - 0.5));
  bar.state = [](double x) { return fmt::format("temperature_C = {:.17g}", std::cos(std::numbers::pi * x)); };
  return bar.end()->snapshot()["temperature"];
}

Errors of(const char* integrator, std::vector<double> steps) {
  Errors e;
  e.quantity = fmt::format("temperature with {}, rms difference to twice as many steps", integrator);
  e.refined = "steps";
  e.low = 0.95, e.high = 1.05;
  e.why = "first order: the difference to half the step is half the error of an Euler step, exactly in the limit";
  e.refinements = std::move(steps);
  for (const double n : e.refinements) {
    std::vector<double> difference = temperatures(integrator, n), finer = temperatures(integrator, 2 * n);
    for (std::size_t i = 0; i < finer.size(); ++i) difference[i] -= finer[i];
    e.errors.push_back(root_mean_square(difference));
  }
  return e;
}

}  // namespace

std::vector<Errors> eulers(bool) { return {of("forward_euler", {80, 160, 320, 640}), of("backward_euler", {20, 40, 80, 160})}; }

}  // namespace bake::studies

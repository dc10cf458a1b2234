// SPDX-License-Identifier: MIT
// Elastic waves along a bar that cannot move sideways, c = sqrt((lambda + 2 mu) / rho) = 1 m/s, so small that Hencky's law is linear.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

using std::numbers::pi;

constexpr double k_dough_speed = 1e-6;  ///< of the dough, in wave speeds: the strain is as small

Bar elastic_bar() {
  Bar bar;
  bar.effects = "motion, elasticity";
  bar.material = "young_modulus_Pa = 1\npoisson_ratio = 0\n";
  bar.time = "safety = 0.5";
  return bar;
}

std::function<std::string(double x)> moving(const Profile& shape, double speed) {
  return [=](double x) { return fmt::format("velocity_m_per_s = [{:.17g}, 0, 0]", speed * shape(x)); };
}

double pulse(double x) { return std::exp(-std::pow((x - 0.5) / 0.08, 2)); }

/// The pulse after it has parted, at steps of `courant` cells' time.
double pulse_error(double cells, double courant) {
  constexpr double t = 0.2;
  Bar bar = elastic_bar();
  bar.cells = static_cast<int>(cells);
  bar.end_s = t;
  bar.time = fmt::format("safety = {:.17g}", courant);
  bar.state = moving(pulse, k_dough_speed);
  const Snapshot now = bar.end()->snapshot();
  const auto exact = [](double x) { return (pulse(x - t) + pulse(x + t)) / 2; };
  return root_mean_square(differences(now, [&](std::size_t i) { return now.velocity[i][0] / k_dough_speed; }, exact, {0.1, 0.9}));
}

/// What the velocity has of the shape, as a share of the first amplitude.
double share_of(const Snapshot& now, const Profile& shape, double speed) {
  double sum = 0;
  for (std::size_t i = 0; i < now.id.size(); ++i) sum += now.velocity[i][0] * shape(now.position[i][0]);
  return 2 * sum / (speed * static_cast<double>(now.id.size()));
}

double whole_wave(double x) { return std::cos(pi * x); }

/// The bar's lowest mode, of period 2 s: velocity shape(x) cos(pi t).
std::vector<Errors> first_period(Bar bar, const Profile& shape, bool quick) {
  Errors velocity, period;
  velocity.quantity = "velocity after a period, rms over 0.2 < x < 0.8, relative to the amplitude";
  period.quantity = "half a period, from zero to zero";
  velocity.refined = period.refined = "cells";
  velocity.refinements = period.refinements = quick ? std::vector<double>{16, 32, 64} : std::vector<double>{16, 32, 64, 128, 256};
  bar.end_s = 0.5;
  bar.state = moving(shape, k_dough_speed);
  for (const double n : velocity.refinements) {
    bar.cells = static_cast<int>(n);
    const auto s = bar.begin();
    run_to(*s, 0.5);
    const double first = share_of(s->snapshot(), shape, k_dough_speed);
    run_to(*s, 1.5);
    const double second = share_of(s->snapshot(), shape, k_dough_speed);
    period.errors.push_back(std::abs(first + second) / pi);  // where the share is zero it changes by pi per second
    run_to(*s, 2);
    const Snapshot now = s->snapshot();
    velocity.errors.push_back(root_mean_square(differences(
        now, [&](std::size_t i) { return now.velocity[i][0] / k_dough_speed; }, shape, k_interior)));
  }
  velocity.low = 1.8, velocity.high = 2.3;
  velocity.why = "second order: at its largest the velocity does not feel an error of time, and the loss of APIC is of higher order";
  return {velocity, period};
}

}  // namespace

namespace first_mode {

Bar bar(int cells, double speed) {
  Bar bar = elastic_bar();
  bar.cells = cells;
  bar.air = 4;
  bar.end_s = period_s / 4;
  bar.state = moving(whole_wave, speed);
  return bar;
}

double share(const Snapshot& now, double speed) { return share_of(now, whole_wave, speed); }

}  // namespace first_mode

std::vector<Errors> pulse_wave(bool quick) {
  Errors at_fixed_ratio, at_fine_steps;
  at_fixed_ratio.quantity = "velocity of the parted pulse, dt = dx / 2 c, rms over 0.1 < x < 0.9";
  at_fixed_ratio.low = 0.9, at_fixed_ratio.high = 1.4;
  at_fixed_ratio.why =
      "first order in time: with symplectic Euler velocity and position stand half a step apart, so that the pulse is dt / 2 late; at "
      "coarse "
      "grids dispersion adds to it";
  at_fine_steps.quantity = "velocity of the parted pulse, dt = 16 dx^2 / 2 c m, rms over 0.1 < x < 0.9";
  at_fine_steps.low = 1.7, at_fine_steps.high = 2.2;
  at_fine_steps.why = "second order in space: nothing happens at a surface";
  at_fixed_ratio.refined = at_fine_steps.refined = "cells";
  at_fixed_ratio.refinements = quick ? std::vector<double>{64, 128, 256} : std::vector<double>{64, 128, 256, 512};
  at_fine_steps.refinements = quick ? std::vector<double>{32, 64, 128} : std::vector<double>{32, 64, 128, 256};
  for (const double n : at_fixed_ratio.refinements) at_fixed_ratio.errors.push_back(pulse_error(n, 0.5));
  for (const double n : at_fine_steps.refinements) at_fine_steps.errors.push_back(pulse_error(n, 8 / n));
  return {at_fixed_ratio, at_fine_steps};
}

std::vector<Errors> free_bar(bool quick) {
  Bar bar = elastic_bar();
  bar.air = 4;
  std::vector<Errors> all = first_period(bar, whole_wave, quick);
  all[1].low = 1.8, all[1].high = 2.3;
  all[1].why = "second order: a free end carries no stress, so that its surface layer has nothing to get wrong";
  return all;
}

std::vector<Errors> clamped_bar(bool quick) {
  Bar bar = elastic_bar();
  bar.faces = "\"sticky\"";
  std::vector<Errors> all = first_period(
      bar, [](double x) { return std::sin(pi * x); }, quick);
  all[1].low = 0.8, all[1].high = 1.3;
  all[1].why =
      "first order from the surface layer: the nodes in and behind a wall are at rest and do not continue the velocity's line, so that the "
      "half cell at the wall strains too little and the bar seems shorter by a share of dx";
  return all;
}

}  // namespace bake::studies

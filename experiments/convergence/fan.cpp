// SPDX-License-Identifier: MIT
// The halves of a bar fly apart: a fan of waves of finite strain in Hencky's material.
//
// With X the place at first, u = ln J and units in which lambda + 2 mu = rho_0 = 1, a bar that cannot move sideways has the first
// Piola-Kirchhoff stress u / J, and its waves run through the material with c = sqrt(d(u/J)/dJ) = sqrt(1 - u) / J. From a jump of velocity
// between -V and V a fan spreads to either side, in which
//     c = |X - 1/2| / t,   v = +-(V - integral of c dJ) = +-(V - 2/3 (1 - (1 - u)^(3/2))).
// Stretched dough is slower, c falls with u, so that the fan is no shock.
#include <fmt/format.h>

#include <cmath>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

constexpr double k_parting_speed = 0.15, k_fan_s = 0.4;  // [m/s], [s]; the strain in the middle is 17 %

/// u of the fan at wave speed c, from 0 at c = 1 up: bisection of sqrt(1 - u) exp(-u).
double strain_at(double c) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double u = (low + high) / 2;
    (std::sqrt(1 - u) * std::exp(-u) > c ? low : high) = u;
  }
  return low;
}

double exact_velocity(double X) {
  const double lost = 2. / 3 * (1 - std::pow(1 - strain_at(std::abs(X - 0.5) / k_fan_s), 1.5));
  return std::copysign(std::max(0.0, k_parting_speed - lost), X - 0.5);
}

}  // namespace

std::vector<Errors> hencky_fan(bool quick) {
  Errors e;
  e.quantity = "velocity, rms over 0.05 < X < 0.95, relative to the jump's half";
  e.refined = "cells";
  e.low = 0.5, e.high = 1.1;
  e.why =
      "between 1/2 and 1: the edges of the fan are kinks, which a scheme of second order smears over dx^(2/3), order 1 in the mean; of the "
      "first "
      "jump some stays in the particles beside it, order 1/2";
  e.refinements = quick ? std::vector<double>{32, 64, 128} : std::vector<double>{32, 64, 128, 256, 512};
  for (const double n : e.refinements) {
    Bar bar;
    bar.effects = "motion, elasticity";
    bar.material = "young_modulus_Pa = 1\npoisson_ratio = 0\n";
    bar.cells = static_cast<int>(n);
    bar.air = bar.cells / 8;
    bar.time = "safety = 0.5";
    bar.end_s = k_fan_s;
    bar.state = [](double x) { return fmt::format("velocity_m_per_s = [{}, 0, 0]", x < 0.5 ? -k_parting_speed : k_parting_speed); };
    const auto s = bar.begin();
    const Snapshot first = s->snapshot();
    run_to(*s, k_fan_s);
    const Snapshot now = s->snapshot();
    const auto velocity = [&](std::size_t i) { return now.velocity[i][0]; };
    e.errors.push_back(root_mean_square(differences(first, velocity, exact_velocity, {0.05, 0.95})) / k_parting_speed);
  }
  return {e};
}

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// A viscoplastic bar that cannot move sideways, in uniform motion v = -V X at first. Until waves come from its free ends, uniform motion
// goes on in the middle, whatever the stress: no piston is needed, which would disturb the stress at every node that it passes. The rate of
// strain is e' = V / (1 - V t), and with the equivalent stress q and the viscous rate of each norm
//     q' = 2 mu e' - 3 mu e'_p,   e'_p = (q - tau_y) / eta (distance),   e'_p = 2 q (q^2 - tau_y^2) / eta (quadratic)
// beyond yield, without pores, which would be pressed shut. (Flow along d sqrt(q^2) / d tau and d q^2 / d tau.)
#include <fmt/format.h>

#include <cmath>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

constexpr double k_pressing_speed = 0.3, k_pressing_s = 0.25, k_yield = 0.01, k_mu = 0.5;  // E = 1 Pa, nu = 0

struct Norm {
  const char* name;
  double viscosity;
  double (*rate)(double q, double viscosity);
};
const Norm k_norms[] = {
    {"distance", 0.075, [](double q, double eta) { return (q - k_yield) / eta; }},
    {"quadratic", 1.3e-4, [](double q, double eta) { return 2 * q * (q * q - k_yield * k_yield) / eta; }},
};

/// q at k_pressing_s, by small steps of the classical Runge-Kutta method.
double exact_stress(const Norm& norm) {
  const auto slope = [&](double t, double q) {
    return 2 * k_mu * k_pressing_speed / (1 - k_pressing_speed * t) - 3 * k_mu * (q > k_yield ? norm.rate(q, norm.viscosity) : 0);
  };
  constexpr int steps = 100000;
  constexpr double h = k_pressing_s / steps;
  double q = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h, a = slope(t, q), b = slope(t + h / 2, q + h / 2 * a), c = slope(t + h / 2, q + h / 2 * b);
    q += h / 6 * (a + 2 * b + 2 * c + slope(t + h, q + h * c));
  }
  return q;
}

/// Differences of q from the exact one in the middle, relative.
std::vector<double> stress_errors(const Norm& norm, double cells, int rows) {
  Bar bar;
  bar.effects = "motion, elasticity, plasticity";
  bar.cells = static_cast<int>(cells);
  bar.rows = rows;
  bar.air = 4;
  bar.end_s = k_pressing_s;
  bar.time = "safety = 0.5";
  bar.material =
      fmt::format("young_modulus_Pa = 1\npoisson_ratio = 0\ninitial_porosity = 1e-7\nyield_stress_Pa = {}\nviscosity_Pa_s = {}\n", k_yield,
                  norm.viscosity);
  bar.tables = fmt::format("[plasticity]\nnorm = \"{}\"\n", norm.name);
  bar.state = [](double x) { return fmt::format("velocity_m_per_s = [{:.17g}, 0, 0]", -k_pressing_speed * (x - 0.5)); };
  const Snapshot now = bar.end()->snapshot();
  const auto& b = now["elastic_strain"];  // b_E - I: xx, yy, zz, yz, zx, xy
  const double exact = exact_stress(norm);
  const auto q = [&](std::size_t i) { return k_mu * std::abs(std::log1p(b[6 * i]) - std::log1p(b[6 * i + 1])) / exact; };
  return differences(now, q, [](double) { return 1.0; }, {0.35, 0.65});
}

}  // namespace

std::vector<Errors> perzyna(bool quick) {
  std::vector<Errors> all;
  for (const Norm& norm : k_norms) {
    Errors e;
    e.quantity = fmt::format("equivalent stress with norm = \"{}\", mean over 0.35 < x < 0.65, 6 rows of particles a cell", norm.name);
    e.refined = "cells";
    e.low = 0.85, e.high = 1.25;
    e.why = "first order in time: the return mapping is backward Euler, with dt in proportion to dx";
    e.refinements = quick ? std::vector<double>{32, 64, 128} : std::vector<double>{32, 64, 128, 256};
    for (const double n : e.refinements) e.errors.push_back(std::abs(mean(stress_errors(norm, n, 6))));
    all.push_back(e);
  }
  Errors noise;
  noise.quantity = "equivalent stress, rms about its mean, 128 cells";
  noise.refined = "rows of particles a cell";
  noise.low = 2, noise.high = 4.5;
  noise.why =
      "particle noise, which no finer grid takes away: the rows of a pressed bar stand at changing places in the cells and are quadrature "
      "points of "
      "the stress; their error falls with about the third power of their number, as the Fourier coefficients of a parabolic spline do";
  noise.refinements = quick ? std::vector<double>{2, 3, 4} : std::vector<double>{2, 3, 4, 6};
  for (const double rows : noise.refinements) {
    std::vector<double> errors = stress_errors(k_norms[0], 128, static_cast<int>(rows));
    const double middle = mean(errors);
    for (double& v : errors) v -= middle;
    noise.errors.push_back(root_mean_square(errors));
  }
  all.push_back(noise);
  return all;
}

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// Heat in a slab, rho c = 1 J/(m^3 K), kappa = 1 W/(m K): theta_t = theta_xx.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

using std::numbers::pi;

constexpr int k_terms = 60;  // at t = 0.05 the last is below 1e-300

double cosine(double x, double t) { return 0.5 + 0.5 * std::exp(-pi * pi * t) * std::cos(pi * x); }

double halves(double x, double t) {
  double sum = 0.5;
  for (int k = 0; k < k_terms; ++k) {
    const double m = (2 * k + 1) * pi;
    sum += (k % 2 ? -2 : 2) / m * std::exp(-m * m * t) * std::cos(m * x);
  }
  return sum;
}

double held_and_insulated(double x, double t) {
  double sum = 1;
  for (int n = 0; n < k_terms; ++n) {
    const double m = (n + 0.5) * pi;
    sum -= 2 / m * std::exp(-m * m * t) * std::sin(m * x);
  }
  return sum;
}

using Exact = double (*)(double x, double t);

/// Differences of temperature at time t in `span`.
std::vector<double> differences_at(Bar bar, double cells, double t, Exact exact, const Span& span) {
  bar.end_s = t;
  return temperature_differences(
      bar, cells, [&](double x) { return exact(x, t); }, span);
}

std::vector<double> refinements(bool quick) { return quick ? std::vector<double>{16, 32, 64} : std::vector<double>{8, 16, 32, 64, 128}; }

Bar slab() {
  Bar bar;
  bar.material = "initial_temperature_C = 0\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  return bar;
}

Errors interior(double t) {
  Errors e;
  e.quantity = fmt::format("temperature at Fo = {}, rms over 0.2 < x < 0.8", t);
  e.refined = "cells";
  return e;
}

std::vector<Errors> held_errors(const Bar& bar, double t, Exact exact, bool quick) {
  Errors e = interior(t);
  e.low = 0.8, e.high = 2;
  e.why =
      "second order but for what is left of the layer at a held face, first order with a small constant: particles within half a cell of "
      "the "
      "face also see the held nodes behind it, which have its temperature and not the line continued. The nodes next to it make that good "
      "to "
      "some 0.03 dx, which decides from 32 cells on";
  e.refinements = refinements(quick);
  for (const double n : e.refinements) e.errors.push_back(root_mean_square(differences_at(bar, n, t, exact, k_interior)));
  return {e};
}

}  // namespace

double held_slab_temperature(double x, double fourier) {
  double sum = 1 - x;
  for (int n = 1; n < k_terms; ++n) sum -= 2 / (n * pi) * std::exp(-n * n * pi * pi * fourier) * std::sin(n * pi * x);
  return sum;
}

std::vector<Errors> slab_cosine(bool quick) {
  constexpr double t = 0.05;
  Bar bar = slab();
  bar.state = [](double x) { return fmt::format("temperature_C = {:.17g}", cosine(x, 0)); };
  Errors inside = interior(t);
  inside.low = 1.8, inside.high = 2.2;
  inside.why = "second order: B-spline moments are exact for linear fields, and the steps shrink with dx^2";
  Errors anywhere;
  anywhere.quantity = fmt::format("temperature at Fo = {}, largest anywhere", t);
  anywhere.refined = "cells";
  anywhere.low = 1.7, anywhere.high = 2.3;
  anywhere.why =
      "second order, too: what the cut stencils of the two cells at an end heat single particles too much or too little goes with subgrid "
      "diffusion";
  inside.refinements = anywhere.refinements = refinements(quick);
  for (const double n : inside.refinements) {
    inside.errors.push_back(root_mean_square(differences_at(bar, n, t, cosine, k_interior)));
    anywhere.errors.push_back(largest(differences_at(bar, n, t, cosine, k_all)));
  }
  return {inside, anywhere};
}

std::vector<Errors> slab_halves(bool quick) {
  constexpr double t = 0.05;
  Bar bar = slab();
  bar.state = [](double x) { return x < 0.5 ? "temperature_C = 1" : "temperature_C = 0"; };
  Errors at_jump = interior(t), heat;
  at_jump.low = 1.8, at_jump.high = 2.7;
  at_jump.why =
      "second order, at few cells more: of a jump between neighbouring particles the nodes see only their mean; subgrid diffusion evens "
      "out "
      "the rest as heat conduction over dx would";
  heat.quantity = "heat of the hot half at Fo = 0.05";
  heat.refined = "cells";
  heat.low = 1.8, heat.high = 2.7;
  heat.why = "as the profile: no particle keeps the heat that it had at the jump";
  at_jump.refinements = heat.refinements = refinements(quick);
  for (const double n : heat.refinements) {
    at_jump.errors.push_back(root_mean_square(differences_at(bar, n, t, halves, k_interior)));
    heat.errors.push_back(2 * std::abs(mean(differences_at(bar, n, t, halves, {0, 0.5}))));
  }
  return {at_jump, heat};
}

std::vector<Errors> slab_held(bool quick) {
  Bar bar = slab();
  bar.before = bar.after = 2;
  bar.tables = held("[0, 0, 0]", "[1, 0, 0]", 1) + held("[1, 0, 0]", "[-1, 0, 0]", 0);
  return held_errors(bar, 0.05, held_slab_temperature, quick);
}

std::vector<Errors> slab_held_and_insulated(bool quick) {
  Bar bar = slab();
  bar.before = 2;
  bar.tables = held("[0, 0, 0]", "[1, 0, 0]", 1);
  return held_errors(bar, 0.2, held_and_insulated, quick);
}

}  // namespace bake::studies

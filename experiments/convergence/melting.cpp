// SPDX-License-Identifier: MIT
// A slab that melts from a held face: (theta + share molten)_t = theta_xx, 1 at x = 0, 0 at first and far away; the share molten grows from
// 0 to 1 between the temperatures 0 and `width`. Neumann's solution of Stefan's problem, with a range of temperatures for the point.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

constexpr double k_end_s = 0.1;  // the front is near 0.4 then, and the far end is still cold

/// Molten below x = 2 lambda sqrt(t), with the diffusivity 1; melting beyond, where the heat capacity is 1 + 1 / width. The same heat goes
/// into the front as comes out of it.
class Melting {
 public:
  explicit Melting(double width) : width_(width), root_(std::sqrt(width / (1 + width))) {
    double low = 1e-6, high = std::min(2.0, 25 * root_);  // erfc(25) is not yet zero in double
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (flux_in(middle) > flux_out(middle) ? low : high) = middle;
    }
    lambda = low;
  }
  double temperature(double x, double t) const {
    const double at = x / (2 * std::sqrt(t));
    return at < lambda ? 1 - (1 - width_) * std::erf(at) / std::erf(lambda) : width_ * std::erfc(at / root_) / std::erfc(lambda / root_);
  }
  double lambda;

 private:
  double flux_in(double at) const { return (1 - width_) * std::exp(-at * at) / std::erf(at); }
  double flux_out(double at) const { return width_ / root_ * std::exp(-at * at / (root_ * root_)) / std::erfc(at / root_); }
  double width_, root_;  ///< root_: of the diffusivity of what melts
};

Bar slab(double width) {
  Bar bar;
  bar.before = 2;
  bar.end_s = k_end_s;
  bar.material = fmt::format(
      "initial_temperature_C = 0\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n"
      "transition_heat_J_per_kg = 1\ntransition_from_C = 0\ntransition_to_C = {}\n",
      width);
  bar.state = [](double x) { return x < 0 ? "temperature_C = 1" : "temperature_C = 0"; };
  bar.tables = held("[0, 0, 0]", "[1, 0, 0]", 1);
  return bar;
}

}  // namespace

double melting_front(double width) { return Melting(width).lambda; }

std::vector<Errors> melting(bool quick) {
  std::vector<Errors> all;
  for (const double width : {0.1, 0.01}) {
    const Melting exact(width);
    Errors e;
    e.quantity = fmt::format("temperature, melting over {} of the rise, rms", width);
    e.refined = "cells";
    e.refinements = quick ? std::vector<double>{16, 32, 64} : std::vector<double>{16, 32, 64, 128};
    if (width > 0.05) {
      e.low = 0.9, e.high = 2.2;
      e.why = "second order, less what is left of the layer at the held face, as for the slabs without latent heat";
    } else {
      e.low = 0.7, e.high = 1.7;
      e.why = "a front thinner than a cell is known to a cell: first order, and steps of its way from node to node";
    }
    for (const double n : e.refinements) {
      const Profile at_end = [&](double x) { return exact.temperature(x, k_end_s); };
      e.errors.push_back(root_mean_square(temperature_differences(slab(width), n, at_end, k_all)));
    }
    all.push_back(e);
  }
  return all;
}

}  // namespace bake::studies

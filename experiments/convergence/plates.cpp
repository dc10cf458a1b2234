// SPDX-License-Identifier: MIT
// A bar between a hot and a cold plate, which are colliders: theta_t = theta_xx, -theta_n = beta (theta - theta_plate). What is steady, a
// line, and the first mode of cooling between them.
#include <fmt/format.h>

#include <cmath>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

constexpr double k_half_length = 0.5;  ///< half the length [m], the length of the Biot number
constexpr double k_fourier = 0.2;

double steady_between(double x, double biot) { return 0.5 - (x - k_half_length) / (2 * k_half_length) * biot / (1 + biot); }
double between(double x, double fourier, double biot) {
  const double z = cooling_root(0, biot);
  return steady_between(x, biot) + 0.5 * std::exp(-z * z * fourier) * std::cos(z * (x - k_half_length) / k_half_length);
}

std::string plate(double x, double normal, double temperature, double biot) {
  return fmt::format(
      "[[collider]]\nshape = {{ half_space = {{ point_m = [{}, 0, 0], normal = [{}, 0, 0] }} }}\ntemperature_C = {}\n"
      "heat_transfer_coefficient_W_per_m2K = {}\n",
      x, normal, temperature, biot / k_half_length);
}

/// Six cells across, as in air (robin.cpp). `shift`: of the bar against the nodes along x, in node distances.
Bar bar_between_plates(double biot, double shift) {
  Bar bar;
  bar.across = 6;
  bar.air = 4;
  bar.shift = shift;
  bar.material = "specific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  bar.tables = plate(0, 1, 1, biot) + plate(1, -1, 0, biot);
  bar.end_s = k_fourier * k_half_length * k_half_length;
  bar.state = [biot](double x) { return fmt::format("temperature_C = {:.17g}", between(x, 0, biot)); };
  return bar;
}

}  // namespace

std::vector<Errors> plates(bool quick) {
  std::vector<Errors> all;
  for (const double biot : {1.0, 10.0})
    for (const double shift : {0.0, 0.3}) {
      Errors e;
      e.quantity = fmt::format("temperature at Bi = {}, Fo = {}, faces {} dx beyond nodes, rms over 0.2 < x < 0.8", biot, k_fourier, shift);
      e.refined = "cells";
      e.low = biot > 1 ? 0.8 : 1.2, e.high = 2.2;
      e.why =
          "second order but for what is left of the layer between a face and the nodes that its heat is taken at: its resistance is known "
          "to some 0.03 dx, which decides from 16 cells on at Bi = 10";
      e.refinements = quick ? std::vector<double>{8, 16, 32} : std::vector<double>{8, 16, 32, 64};
      for (const double n : e.refinements) {
        const Profile exact = [&](double x) { return between(x, k_fourier, biot); };
        e.errors.push_back(root_mean_square(temperature_differences(bar_between_plates(biot, shift), n, exact, k_interior)));
      }
      all.push_back(e);
    }
  return all;
}

}  // namespace bake::studies

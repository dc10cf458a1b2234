// SPDX-License-Identifier: MIT
// A slab that cools in air: theta_t = theta_xx, -theta_n = beta theta at both faces, theta = 1 at first.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {

namespace {

using std::numbers::pi;

constexpr double k_half = 0.5;  ///< half the thickness [m], the length of the Biot number

double cooled(double x, double fourier, double biot) {
  double sum = 0;
  for (int n = 0; n < 40; ++n) {
    const double z = cooling_root(n, biot);
    sum += 4 * std::sin(z) / (2 * z + std::sin(2 * z)) * std::exp(-z * z * fourier) * std::cos(z * (x - k_half) / k_half);
  }
  return sum;
}

/// Six cells across: the area at a slip face is taken from the dough and its mirror image, which must not be seen at the other face.
Bar slab(double biot) {
  Bar bar;
  bar.across = 6;
  bar.air = 4;
  bar.material = "initial_temperature_C = 1\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  bar.tables = fmt::format("[oven]\ntemperature_C = 0\nheat_transfer_coefficient_W_per_m2K = {}\n", biot / k_half);
  return bar;
}

}  // namespace

double cooling_root(int n, double biot) {
  double low = n * pi, high = (n + 0.5) * pi;
  for (int i = 0; i < 100; ++i) {  // bisection of z sin z - Bi cos z
    const double z = (low + high) / 2, g = (z * std::sin(z) - biot * std::cos(z)) * (n % 2 ? -1 : 1);
    (g < 0 ? low : high) = z;
  }
  return low;
}

std::vector<Errors> robin(bool quick) {
  std::vector<Errors> all;
  for (const double biot : {0.1, 1.0, 10.0}) {
    const double fourier = biot > 1 ? 0.2 : 0.5;
    Errors e;
    e.quantity = fmt::format("temperature at Bi = {}, Fo = {}, rms over 0.2 < x < 0.8", biot, fourier);
    e.refined = "cells";
    e.low = 0.9, e.high = 4.2;
    e.why =
        "second order but for what is left of the layer between the surface and the nodes that the exchange is taken at: its resistance is "
        "known to some 0.03 dx, which decides from 32 cells on. At Bi = 10 the two cancel near 32 cells, so that errors fall faster up to "
        "there";
    e.refinements = quick ? std::vector<double>{8, 16, 32} : std::vector<double>{8, 16, 32, 64};
    for (const double n : e.refinements) {
      Bar bar = slab(biot);
      bar.end_s = fourier * k_half * k_half;
      const Profile exact = [&](double x) { return cooled(x, fourier, biot); };
      e.errors.push_back(root_mean_square(temperature_differences(bar, n, exact, k_interior)));
    }
    all.push_back(e);
  }
  return all;
}

}  // namespace bake::studies

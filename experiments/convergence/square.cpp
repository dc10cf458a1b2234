// SPDX-License-Identifier: MIT
// Heat in a long bar of square section, one metre wide, whose sides are held at 1: theta_t = theta_xx + theta_yy, theta = 0 at first.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

using std::numbers::pi;

double warmed(double x, double y, double t) {
  double sum = 0;
  for (int m = 1; m < 40; m += 2)
    for (int n = 1; n < 40; n += 2) sum += std::sin(m * pi * x) * std::sin(n * pi * y) * std::exp(-pi * pi * (m * m + n * n) * t) / (m * n);
  return 1 - 16 / (pi * pi) * sum;
}

/// One cell thick, with two cells beyond each side for the grips.
Snapshot warmed_section(double cells, double end_s) {
  StudyScene setting;
  const double dx = setting.dx = 1 / cells;
  setting.frame_s = end_s;
  setting.low = {-2 * dx, -2 * dx, 0};
  setting.high = {1 + 2 * dx, 1 + 2 * dx, dx};
  setting.material += "initial_temperature_C = 0\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  setting.shape =
      fmt::format("box = {{ centre_m = [0.5, 0.5, {0:.17g}], half_extents_m = [{1:.17g}, {1:.17g}, {0:.17g}] }}", dx / 2, 0.5 + 2 * dx);
  setting.body = "jitter = 0";
  setting.tables = held("[0, 0, 0]", "[1, 0, 0]", 1) + held("[1, 0, 0]", "[-1, 0, 0]", 1) + held("[0, 0, 0]", "[0, 1, 0]", 1) +
                   held("[0, 1, 0]", "[0, -1, 0]", 1);
  return setting.after(end_s)->snapshot();
}

}  // namespace

std::vector<Errors> square(bool quick) {
  constexpr double t = 0.05;
  Errors e;
  e.quantity = fmt::format("temperature at Fo = {}, rms over the inner three fifths", t);
  e.refined = "cells";
  e.low = 0.8, e.high = 2.1;
  e.why = "as for the slab with held faces, of which four are seen at once";
  e.refinements = quick ? std::vector<double>{12, 24, 48} : std::vector<double>{12, 24, 48, 72};
  for (const double n : e.refinements) {
    const Snapshot now = warmed_section(n, t);
    const auto& theta = now["temperature"];
    std::vector<double> inside;
    for (std::size_t i = 0; i < theta.size(); ++i) {
      const double x = now.position[i][0], y = now.position[i][1];
      if (std::abs(x - 0.5) < 0.3 && std::abs(y - 0.5) < 0.3) inside.push_back(theta[i] - warmed(x, y, t));
    }
    e.errors.push_back(root_mean_square(inside));
  }
  return {e};
}

}  // namespace bake::studies

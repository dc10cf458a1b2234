// SPDX-License-Identifier: MIT
// Where a ball that cools in air is right, and where not: what docs/model.md says of the last cell below a surface.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/convergence/exact.h"
#include "solver/core/vector3.h"

namespace bake::studies {
namespace {

constexpr double k_cells = 8, k_dx = 1 / k_cells, k_end = 0.2;

struct Off {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double off) { sum += off, squares += off * off, ++count; }
  double mean() const { return sum / count; }
  double rms() const { return std::sqrt(squares / count); }
};

/// Of the particles between two depths.
Off off(double from, double to) {
  StudyScene setting = ball_in_air::setting(k_cells, 1);
  setting.frame_s = k_end;
  const auto ball = setting.after(k_end);
  const Snapshot now = ball->snapshot();
  const auto& theta = now["temperature"];
  Off found;
  for (std::size_t p = 0; p < theta.size(); ++p) {
    const double r = length(now.position[p] - ball_in_air::centre);
    if (from <= 1 - r && 1 - r < to) found.add(theta[p] - ball_in_air::temperature(r, k_end));
  }
  return found;
}

TEST(ABallInAir, IsRightBelowItsLastCell) {
  EXPECT_LT(off(k_dx, 1).rms(), 0.002);  // of its first temperature
}

TEST(ABallInAir, IsTooWarmInItsLastCell) {
  const double drop = ball_in_air::temperature(1, k_end) * k_dx;  // q dx / kappa, with Bi = 1
  EXPECT_NEAR(off(0, 0.25 * k_dx).mean() / drop, 0.4, 0.1);
  EXPECT_NEAR(off(0.25 * k_dx, 0.5 * k_dx).mean() / drop, 0.2, 0.05);
  EXPECT_NEAR(off(0.75 * k_dx, k_dx).mean() / drop, 0, 0.05);
}

}  // namespace
}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// Where a ball that cools in air is right, and where not: what docs/model.md says of the last cell below a surface.
#include <gtest/gtest.h>

#include <numeric>

#include "experiments/convergence/exact.h"
#include "solver/core/vector3.h"

namespace bake::studies {
namespace {

constexpr double k_cells = 8, k_dx = 1 / k_cells, k_end = 0.2;

class ABallInAir : public testing::Test {
 protected:
  ABallInAir() {
    StudyScene setting = ball_in_air::setting(k_cells, 1);
    setting.frame_s = k_end;
    now_ = setting.after(k_end)->snapshot();
  }
  /// By how much the particles between two depths are too warm.
  std::vector<double> off(double from, double to) const {
    const auto& theta = now_["temperature"];
    std::vector<double> found;
    for (std::size_t p = 0; p < theta.size(); ++p) {
      const double r = length(now_.position[p] - ball_in_air::centre);
      if (from <= 1 - r && 1 - r < to) found.push_back(theta[p] - ball_in_air::temperature(r, k_end));
    }
    return found;
  }
  double mean_off(double from, double to) const {
    const auto found = off(from, to);
    return std::accumulate(found.begin(), found.end(), 0.) / static_cast<double>(found.size());
  }

 private:
  Snapshot now_;
};

TEST_F(ABallInAir, IsRightBelowItsLastCell) {
  EXPECT_LT(root_mean_square(off(k_dx, 1)), 0.002);  // of its first temperature
}

TEST_F(ABallInAir, IsTooWarmInItsLastCell) {
  const double drop = ball_in_air::temperature(1, k_end) * k_dx;  // q dx / kappa, with Bi = 1
  EXPECT_NEAR(mean_off(0, 0.25 * k_dx) / drop, 0.4, 0.1);
  EXPECT_NEAR(mean_off(0.25 * k_dx, 0.5 * k_dx) / drop, 0.2, 0.05);
  EXPECT_NEAR(mean_off(0.75 * k_dx, k_dx) / drop, 0, 0.05);
}

}  // namespace
}  // namespace bake::studies

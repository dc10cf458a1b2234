// SPDX-License-Identifier: MIT
#include "analysis/pictures/noise.h"

#include <gtest/gtest.h>

namespace bake {
namespace {

TEST(Noise, SlopeIsThatOfTheValue) {
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3f p(0.37f * static_cast<float>(i) - 20, 0.113f * static_cast<float>(i), 3 - 0.71f * static_cast<float>(i));
    const Noise here = fractal_noise(p, 3);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3f step = 1e-2f * Eigen::Vector3f::Unit(axis);
      EXPECT_NEAR(here.slope[axis], (fractal_noise(p + step, 3).value - fractal_noise(p - step, 3).value) / 2e-2f, 0.02f);
    }
    EXPECT_LT(std::abs(here.value), 1.1f);
  }
}

TEST(Noise, VariesAboutZero) {
  double sum = 0, squares = 0;
  constexpr int k_count = 20000;
  for (int i = 0; i < k_count; ++i) {
    const float value =
        noise({0.731f * static_cast<float>(i % 100), 0.577f * static_cast<float>(i / 100), 0.13f * static_cast<float>(i % 7)}).value;
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / k_count, 0, 0.03);
  EXPECT_GT(squares / k_count, 0.05);
}

}  // namespace
}  // namespace bake

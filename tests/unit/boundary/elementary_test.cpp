// SPDX-License-Identifier: MIT
// The project's own elementary functions against those of the system in long double.
#include "solver/core/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bake::elementary {
namespace {

constexpr double k_unit = 0x1p-53;

class AnElementaryFunction : public testing::Test {
 protected:
  double between(double low, double high) { return low + (high - low) * std::uniform_real_distribution<double>()(random_); }
  std::mt19937_64 random_{2019};
};

TEST_F(AnElementaryFunction, IsAsExactAsItsHeaderSays) {
  const auto relative = [](double found, long double right) { return static_cast<double>(std::abs((found - right) / right)) / k_unit; };
  const auto absolute = [](double found, long double right) { return static_cast<double>(std::abs(found - right)) / k_unit; };
  for (int i = 0; i < 100'000; ++i) {
    const double x = between(-700, 700), angle_rad = i % 2 ? between(-1e5, 1e5) : between(-7, 7);
    ASSERT_LT(relative(exp(x), std::exp(static_cast<long double>(x))), 2) << x;
    const double positive = i % 2 ? std::exp(x) : between(0.5, 2);
    ASSERT_LT(relative(log(positive), std::log(static_cast<long double>(positive))), 3) << positive;
    ASSERT_LT(absolute(sine(angle_rad), std::sin(static_cast<long double>(angle_rad))), 2) << angle_rad;
    ASSERT_LT(absolute(cosine(angle_rad), std::cos(static_cast<long double>(angle_rad))), 2) << angle_rad;
    const double a = between(0, 1) * (i % 3 ? 1 : 1e-9), b = between(0, 1) * (i % 5 ? 1 : 1e-9), y = between(0.1, 20);
    ASSERT_LT(relative(angle(a, b), std::atan2(static_cast<long double>(a), static_cast<long double>(b))), 8) << a << " " << b;
    ASSERT_LT(relative(power(a, y), std::pow(static_cast<long double>(a), static_cast<long double>(y))), 3 + 3 * std::abs(y * std::log(a)));
  }
}

TEST_F(AnElementaryFunction, KnowsItsEnds) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(exp(0), 1);
  EXPECT_EQ(exp(-800), 0);
  EXPECT_EQ(exp(800), infinity);
  EXPECT_TRUE(std::isnan(exp(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(log(1), 0);
  EXPECT_EQ(power(0, 2), 0);
  EXPECT_EQ(power(1, 3.7), 1);
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(angle(0, 1), 0);
  EXPECT_NEAR(angle(1, 0), M_PI / 2, 4 * k_unit);
}

}  // namespace
}  // namespace bake::elementary

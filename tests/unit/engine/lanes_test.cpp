// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "solver/core/rows.h"

namespace bake {
namespace {

template <class Real>
class PacksOfLanes : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(PacksOfLanes, Reals);

TYPED_TEST(PacksOfLanes, FillOneRegister) {
  EXPECT_EQ(sizeof(Lanes<TypeParam>), std::size_t{k_register_bytes});
  EXPECT_EQ(k_width<TypeParam> * sizeof(TypeParam), std::size_t{k_register_bytes});
}

TYPED_TEST(PacksOfLanes, KeepOneNumberInEveryLane) {
  for (const TypeParam x : {TypeParam(0.1), TypeParam(-3e30), std::numeric_limits<TypeParam>::denorm_min()})
    for (int l = 0; l < k_width<TypeParam>; ++l) EXPECT_EQ(lanes<TypeParam>(x)[l], x);
}

TYPED_TEST(PacksOfLanes, TransposeSwapsRowsAndColumns) {
  constexpr int W = k_width<TypeParam>;
  Lanes<TypeParam> rows[W];
  for (int i = 0; i < W; ++i)
    for (int j = 0; j < W; ++j) rows[i][j] = static_cast<TypeParam>(100 * i + j);
  transpose(rows);
  for (int i = 0; i < W; ++i)
    for (int j = 0; j < W; ++j) EXPECT_EQ(rows[i][j], static_cast<TypeParam>(100 * j + i)) << i << " " << j;
}

template <int R, class Real>
void expect_rows_become_lanes_and_back() {
  constexpr int W = k_width<Real>;
  alignas(64) Real rows[W * R], again[W * R];
  for (int l = 0; l < W; ++l)
    for (int c = 0; c < R; ++c) rows[l * R + c] = static_cast<Real>(100 * l + c);
  Lanes<Real> columns[R];
  rows_to_lanes<R>(static_cast<const Real*>(rows), columns);
  for (int l = 0; l < W; ++l)
    for (int c = 0; c < R; ++c) EXPECT_EQ(columns[c][l], static_cast<Real>(100 * l + c)) << R << ": " << l << " " << c;
  lanes_to_rows<R>(columns, again);
  for (int i = 0; i < W * R; ++i) EXPECT_EQ(again[i], rows[i]) << R << ": " << i;
}

TYPED_TEST(PacksOfLanes, RowsBecomeLanesAndBackWhateverTheirLength) {
  expect_rows_become_lanes_and_back<4, TypeParam>();
  expect_rows_become_lanes_and_back<8, TypeParam>();
  expect_rows_become_lanes_and_back<16, TypeParam>();
  expect_rows_become_lanes_and_back<64, TypeParam>();
}

TYPED_TEST(PacksOfLanes, AnyFindsOneTrueLaneWhereverItIs) {
  const auto zero = lanes<TypeParam>(0);
  EXPECT_FALSE(any(zero > zero));
  for (int l = 0; l < k_width<TypeParam>; ++l) {
    auto one = zero;
    one[l] = 1;
    EXPECT_TRUE(any(one > zero)) << l;
  }
}

TYPED_TEST(PacksOfLanes, FindLargestSmallestAndSumWhereverTheyAre) {
  for (int l = 0; l < k_width<TypeParam>; ++l) {
    auto a = lanes<TypeParam>(2);
    a[l] = 7;
    EXPECT_EQ(largest_lane(a), TypeParam(7));
    EXPECT_EQ(smallest_lane(-a), TypeParam(-7));
    EXPECT_EQ(sum_lanes(a), 2.0 * k_width<TypeParam> + 5);
  }
}

TYPED_TEST(PacksOfLanes, ClampBetweenTwoLimits) {
  const auto low = lanes<TypeParam>(-1), high = lanes<TypeParam>(2);
  EXPECT_EQ(clamp(lanes<TypeParam>(-5), low, high)[0], TypeParam(-1));
  EXPECT_EQ(clamp(lanes<TypeParam>(5), low, high)[0], TypeParam(2));
  EXPECT_EQ(clamp(lanes<TypeParam>(1.5), low, high)[0], TypeParam(1.5));
  EXPECT_EQ(abs(lanes<TypeParam>(-3))[0], TypeParam(3));
}

/// Largest error of f in units of the last place, against the same function in long double.
template <class Real, class Function, class Exact>
double error_in_ulps(Function f, Exact exact, double low, double high) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(low, high);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    Lanes<Real> x;
    for (int l = 0; l < k_width<Real>; ++l) x[l] = static_cast<Real>(uniform(random));
    const Lanes<Real> y = f(x);
    for (int l = 0; l < k_width<Real>; ++l) {
      const auto right = exact(static_cast<long double>(x[l]));
      const auto ulp = static_cast<long double>(std::numeric_limits<Real>::epsilon()) * std::abs(right);
      if (right != 0) worst = std::max(worst, static_cast<double>(std::abs(static_cast<long double>(y[l]) - right) / ulp));
    }
  }
  return worst;
}

// Eigen states a few units in the last place for its packet functions; 4 still catches a lost digit (10 units) at once.
constexpr double k_ulps = 4;

TYPED_TEST(PacksOfLanes, SquareRootAgreesWithTheStandardLibrary) {
  EXPECT_LE(error_in_ulps<TypeParam>([](auto x) { return sqrt(x); }, [](long double x) { return std::sqrt(x); }, 0, 1e6),
            2);  // by reciprocal and Newton
}
TYPED_TEST(PacksOfLanes, LogarithmAgreesWithTheStandardLibrary) {
  const auto f = [](auto x) { return log(x); };
  const auto exact = [](long double x) { return std::log(x); };
  EXPECT_LE(error_in_ulps<TypeParam>(f, exact, 1e-6, 0.9), k_ulps);
  EXPECT_LE(error_in_ulps<TypeParam>(f, exact, 1.1, 1e6), k_ulps);
}
TYPED_TEST(PacksOfLanes, ExponentialAgreesWithTheStandardLibrary) {
  EXPECT_LE(error_in_ulps<TypeParam>([](auto x) { return exp(x); }, [](long double x) { return std::exp(x); }, -20, 20), k_ulps);
}
TYPED_TEST(PacksOfLanes, LogarithmNearOneKeepsItsDigits) {
  const auto f = [](auto x) { return log1p(x); };
  const auto exact = [](long double x) { return std::log1p(x); };
  for (const double size : {1e-6, 1e-3, 0.1, 0.9}) EXPECT_LE(error_in_ulps<TypeParam>(f, exact, -size, size), k_ulps) << size;
}
TYPED_TEST(PacksOfLanes, ExponentialNearZeroKeepsItsDigits) {
  const auto f = [](auto x) { return expm1(x); };
  const auto exact = [](long double x) { return std::expm1(x); };
  for (const double size : {1e-6, 1e-3, 0.1, 2.0}) EXPECT_LE(error_in_ulps<TypeParam>(f, exact, -size, size), k_ulps) << size;
}

TEST(LanesOfDouble, HaveTheirOwnLogarithmAndExponentialNearZero) {
  std::mt19937_64 random(2019);
  std::uniform_real_distribution<double> exponent(-300, 0), sign(-1, 1);
  for (int i = 0; i < 10'000; ++i) {
    const double x = std::copysign(std::pow(10, exponent(random) / (i % 2 ? 1 : 100)), sign(random)) * 0.99;
    const double log1p_found = log1p(lanes<double>(x))[0], expm1_found = expm1(lanes<double>(x))[0];
    ASSERT_NEAR(log1p_found, std::log1p(x), 1e-15 * std::abs(std::log1p(x))) << x;
    ASSERT_NEAR(expm1_found, std::expm1(x), 1e-15 * std::abs(std::expm1(x))) << x;
  }
  EXPECT_EQ(log1p(lanes<double>(0))[0], 0);
  EXPECT_EQ(expm1(lanes<double>(0))[0], 0);
  EXPECT_EQ(expm1(lanes<double>(-800))[0], -1);
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include "analysis/machines/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bake::studies {
namespace {

TEST(Spread, HoldsTheMiddleAndBothEnds) {
  const Spread spread = spread_of({3, 1, 2});
  EXPECT_EQ(spread.low, 1);
  EXPECT_EQ(spread.median, 2);
  EXPECT_EQ(spread.high, 3);
}

TEST(Median, IsTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({}), 0);
}

/// Samples without equals of n and m numbers with U = `wins`: x beats the y one after the other.
MannWhitney with_U(int n, int m, int wins) {
  std::vector<double> x, y;
  for (int j = 0; j < m; ++j) y.push_back(j);
  for (int i = 0; i < n; ++i) {
    const int beaten = std::min(m, wins);
    wins -= beaten;
    x.push_back(beaten - 0.5 - 0.01 * i);
  }
  return mann_whitney(x, y);
}

// Numbers of orders with U = 0, 1, 2, ... of n and m numbers are the coefficients of the Gaussian binomial: for 3 and 3 they are
// 1 1 2 3 3 3 3 2 1 1 of 20; for 4 and 4 they begin with 1 1 2 3 5 of 70; for 5 and 5 with 1 1 2 3 5 7 of 252.
TEST(MannWhitneyTest, CountsTheOrdersOfSmallSamples) {
  EXPECT_NEAR(with_U(3, 3, 0).p, 2 * 1 / 20., 1e-12);
  EXPECT_NEAR(with_U(3, 3, 2).p, 2 * 4 / 20., 1e-12);
  EXPECT_NEAR(with_U(3, 3, 4).p, 1, 1e-12);
  EXPECT_NEAR(with_U(4, 4, 0).p, 2 / 70., 1e-12);
  EXPECT_NEAR(with_U(4, 4, 4).p, 2 * 12 / 70., 1e-12);
  EXPECT_NEAR(with_U(5, 5, 0).p, 2 / 252., 1e-12);
  EXPECT_NEAR(with_U(5, 5, 5).p, 2 * 19 / 252., 1e-12);
  EXPECT_NEAR(with_U(2, 3, 1).p, 2 * 2 / 10., 1e-12);
  EXPECT_EQ(with_U(4, 4, 4).U, 4);
}

// Critical values of the published tables, two-sided at 5 %: the largest U that is told apart.
TEST(MannWhitneyTest, AgreesWithThePublishedTables) {
  struct Row {
    int n, m, critical;
  };
  for (const Row& row :
       {Row{4, 4, 0}, Row{5, 5, 2}, Row{5, 8, 6}, Row{7, 9, 12}, Row{8, 8, 13}, Row{10, 10, 23}, Row{12, 15, 49}, Row{20, 20, 127}}) {
    EXPECT_LE(with_U(row.n, row.m, row.critical).p, k_significant) << row.n << " " << row.m;
    EXPECT_GT(with_U(row.n, row.m, row.critical + 1).p, k_significant) << row.n << " " << row.m;
  }
}

TEST(MannWhitneyTest, SaysWhenNothingCouldBeTold) {
  EXPECT_NEAR(with_U(3, 3, 0).p_smallest, 0.1, 1e-12);
  EXPECT_GT(with_U(3, 4, 0).p_smallest, k_significant);
  EXPECT_LT(with_U(4, 4, 0).p_smallest, k_significant);
  EXPECT_LT(with_U(3, 5, 0).p_smallest, k_significant);
  EXPECT_EQ(mann_whitney({1}, {2}).p_smallest, 1);
}

TEST(MannWhitneyTest, IsSymmetric) {
  const std::vector<double> x{1, 4, 2.5, 9, 3}, y{2, 5, 7, 8};
  EXPECT_NEAR(mann_whitney(x, y).p, mann_whitney(y, x).p, 1e-12);
  EXPECT_EQ(mann_whitney(x, y).U + mann_whitney(y, x).U, 20);
}

// All numbers equal: every order is as good as any other. 1 1 | 1 2: of the 6 choices of two of the ranks 2 2 2 4, three have the sum 4
// and three the sum 6: both as far from the mean 5.
TEST(MannWhitneyTest, SharesTheRanksOfEquals) {
  EXPECT_EQ(mann_whitney({5, 5, 5, 5}, {5, 5, 5, 5}).p, 1);
  EXPECT_EQ(mann_whitney({5, 5, 5, 5}, {5, 5, 5, 5}).U, 8);
  EXPECT_NEAR(mann_whitney({1, 1}, {1, 2}).p, 1, 1e-12);
  // 1 1 1 | 2 2 2: the one order of twenty, either way
  EXPECT_NEAR(mann_whitney({1, 1, 1}, {2, 2, 2}).p, 2 / 20., 1e-12);
}

TEST(MannWhitneyTest, IsNormalForLargeSamplesAndMeetsTheExactOne) {
  // just below and just above the border, the same U in units of its deviation
  const auto z = [](int n, double deviations) {
    const double sigma = std::sqrt(n * n * (2. * n + 1) / 12);
    return with_U(n, n, static_cast<int>(std::lround(n * n / 2. - deviations * sigma))).p;
  };
  for (const double deviations : {0.5, 1., 2.}) EXPECT_NEAR(z(30, deviations) / z(31, deviations), 1, 0.06) << deviations;
  EXPECT_NEAR(z(30, 3) / z(31, 3), 1, 0.2);  // the tail of the normal distribution is the heavier one
}

// What a test at 5 % promises: two samples of one kind are told apart in one case of twenty, or less often (few orders).
TEST(MannWhitneyTest, IsWrongAsOftenAsItSays) {
  std::mt19937 random(1);
  std::exponential_distribution<double> skewed(1);
  int told_apart = 0, outside = 0;
  constexpr int k_trials = 4000;
  for (int trial = 0; trial < k_trials; ++trial) {
    std::vector<double> x, y;
    for (int i = 0; i < 8; ++i) x.push_back(1 + skewed(random)), y.push_back(1 + skewed(random));
    told_apart += mann_whitney(x, y).p < k_significant;
    const Estimate e = ratio_of(x, y);
    outside += *e.low > 1 || *e.high < 1;
  }
  EXPECT_LT(told_apart, 0.06 * k_trials);
  EXPECT_GT(told_apart, 0.03 * k_trials);
  EXPECT_LT(outside, 0.06 * k_trials);
  EXPECT_GT(outside, 0.03 * k_trials);
}

TEST(Ratio, IsTheMedianOfAllPairsWithAnInterval) {
  const Estimate apart = ratio_of({2, 2.2, 2.1, 2.3}, {1, 1.1, 1.05, 1.2});
  EXPECT_NEAR(apart.value, 2, 0.05);
  ASSERT_TRUE(apart.low && apart.high);
  EXPECT_DOUBLE_EQ(*apart.low, 2 / 1.2);  // four and four: the outermost ratios
  EXPECT_DOUBLE_EQ(*apart.high, 2.3);
  EXPECT_FALSE(ratio_of({1, 2, 3}, {1, 2, 3}).low);
}

TEST(Ratio, HasAnIntervalThatMeetsOneJustWhereTheTestTellsNothing) {
  std::mt19937 random(3);
  std::lognormal_distribution<double> times(0, 0.1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> x, y;
    for (int i = 0; i < 6; ++i) x.push_back(times(random)), y.push_back(1.1 * times(random));
    const Estimate e = ratio_of(x, y);
    EXPECT_EQ(mann_whitney(x, y).p<k_significant, *e.low> 1 || *e.high < 1);
  }
}

}  // namespace
}  // namespace bake::studies

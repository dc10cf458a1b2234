// SPDX-License-Identifier: MIT
#include "experiments/make/moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bake {
namespace {

std::vector<double> steadily(std::size_t rows) {
  std::vector<double> column(rows);
  std::iota(column.begin(), column.end(), 0.0);
  return column;
}

TEST(Moments, AreEvenlySpacedWhereNothingElseHappens) {
  EXPECT_EQ(moments({steadily(101)}, 5), (std::vector<int>{0, 25, 50, 75, 100}));
  EXPECT_EQ(moments({steadily(101), std::vector<double>(101, 7.0)}, 5), (std::vector<int>{0, 25, 50, 75, 100}));
}

TEST(Moments, AreCloserTogetherWhereABodyChanges) {
  std::vector<double> volume(101, 1.0);
  for (std::size_t row = 0; row < 101; ++row) volume[row] = row < 40 ? 1 : row < 60 ? 1 + 0.05 * static_cast<double>(row - 40) : 2;
  const std::vector<int> rows = moments({steadily(101), volume}, 11);
  ASSERT_EQ(rows.size(), 11u);
  EXPECT_EQ(rows.front(), 0);
  EXPECT_EQ(rows.back(), 100);
  EXPECT_GE(std::count_if(rows.begin(), rows.end(), [](int row) { return row >= 40 && row <= 60; }), 5);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
  EXPECT_EQ(std::adjacent_find(rows.begin(), rows.end()), rows.end()) << "each once";
}

TEST(Moments, BeginWhereAsked) {
  EXPECT_EQ(moments({steadily(101)}, 5, 1), (std::vector<int>{1, 26, 51, 75, 100}));
  EXPECT_EQ(moments({steadily(3)}, 12, 2), (std::vector<int>{2}));
}

TEST(Moments, AreAllRowsWhereThereAreFew) {
  EXPECT_EQ(moments({steadily(3)}, 12), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(moments({steadily(1)}, 12), (std::vector<int>{0}));
}

TEST(Moments, CountNoChangeWhereThereIsNoNumber) {
  std::vector<double> bad = steadily(101);
  bad[50] = NAN;
  const std::vector<int> rows = moments({steadily(101), bad}, 5);
  EXPECT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows.back(), 100);
}

}  // namespace
}  // namespace bake

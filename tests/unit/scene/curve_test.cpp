// SPDX-License-Identifier: MIT
#include "solver/core/curve.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bake::test {
namespace {

Curve ramp() {
  Curve curve;
  curve.points = {{0, 20}, {10, 120}, {20, 70}};
  return curve;
}

TEST(Curve, IsLinearBetweenItsPoints) {
  EXPECT_DOUBLE_EQ(ramp()(2.5), 45);
  EXPECT_DOUBLE_EQ(ramp()(15), 95);
}

TEST(Curve, HitsItsPoints) {
  EXPECT_EQ(ramp()(0), 20);
  EXPECT_EQ(ramp()(10), 120);
  EXPECT_EQ(ramp()(20), 70);
}

TEST(Curve, IsFlatOutsideItsPoints) {
  EXPECT_EQ(ramp()(-1), 20);
  EXPECT_EQ(ramp()(1e9), 70);
  EXPECT_EQ(Curve(3)(-1e9), 3);
}

TEST(Curve, WithoutPointsHasNoValue) { EXPECT_THROW(Curve()(0), std::logic_error); }

}  // namespace
}  // namespace bake::test

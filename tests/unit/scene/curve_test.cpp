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

TEST(Curve, HasItsExactMeanOverAnyTime) {
  EXPECT_DOUBLE_EQ(ramp().mean(2, 4), 50);
  EXPECT_DOUBLE_EQ(ramp().mean(5, 15), (0.5 * (70 + 120) * 5 + 0.5 * (120 + 95) * 5) / 10);  // over a corner
  EXPECT_DOUBLE_EQ(ramp().mean(-10, 30), (20 * 10 + 70 * 10 + 95 * 10 + 70 * 10) / 40.);     // from end to end and beyond
  EXPECT_EQ(ramp().mean(2.5, 2.5), 45);
  EXPECT_EQ(ramp().mean(20, 20.1), 70) << "a constant has no round-off";
  EXPECT_EQ(Curve(-9.81).mean(0.1, 0.4), -9.81);
  Curve level;
  level.points = {{0, 0.1}, {1, 0.1}, {2, 0.1}, {3, 0}};
  EXPECT_EQ(level.mean(0.3, 1.7), 0.1) << "nor has what is level for a while";
}

TEST(Curve, MayBeOfVectors) {
  VectorCurve curve;
  curve.points = {{0, {0, 0, 0}}, {0.5, {3, 0, -4}}, {1, {0, 0, -1}}};
  EXPECT_EQ(curve(0.25), (Vector3{1.5, 0, -2}));
  EXPECT_EQ(curve.mean(0, 0.5), (Vector3{1.5, 0, -2}));
  EXPECT_EQ(largest_length(curve), 5);
}

TEST(Curve, WithoutPointsHasNoValue) { EXPECT_THROW(Curve()(0), std::logic_error); }

}  // namespace
}  // namespace bake::test

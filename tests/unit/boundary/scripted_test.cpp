// SPDX-License-Identifier: MIT
#include "solver/boundary/scripted.h"

#include <gtest/gtest.h>

#include "tests/unit/boundary/sampling.h"

namespace bake {
namespace {

RigidPath swing() { return {{{0, {0, 0, 0}, {0, 0, 0}}, {1, {0.1, 0.2, 0}, {0, 0, 90}}}, {0.5, 0, 0}}; }

TEST(ScriptedShape, MovesDistanceAndNormalWithItsPose) {
  for (const Sample& sample : exact_shapes()) {
    const ScriptedShape scripted{sample.shape, swing()};
    const RigidState pose = scripted.path.at(0.7);
    RandomPoints random({-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3});
    for (int i = 0; i < 200; ++i) {
      const Point drawn = random(), x = pose.to_world(drawn);
      ASSERT_NEAR(scripted.distance(pose, x), sample.shape->distance(drawn), 1e-14) << sample.name;
      ASSERT_LT(length(scripted.normal(pose, x) - pose.turn(sample.shape->normal(drawn))), 1e-6) << sample.name;
    }
  }
}

TEST(ScriptedShape, BoundsHoldTheMovedSolid) {
  for (const Sample& sample : exact_shapes()) {
    const ScriptedShape scripted{sample.shape, swing()};
    for (const double time : {0.0, 0.4, 1.0}) {
      const RigidState pose = scripted.path.at(time);
      const Box3 box = scripted.bounds(pose);
      RandomPoints random(sample.shape->bounds().low, sample.shape->bounds().high);
      for (int i = 0; i < 500; ++i) {
        const Point drawn = random();
        ASSERT_TRUE(sample.shape->distance(drawn) > 0 || holds(box, pose.to_world(drawn), 1e-14)) << sample.name;
      }
    }
  }
}

TEST(ScriptedShape, BoundsAreTightWithoutRotation) {
  const RigidPath lift({{0, {0, 0, 0}, {0, 0, 0}}, {1, {0, 0, 1}, {0, 0, 0}}}, {3, 4, 5});
  const Box3 ball = ScriptedShape{make_sphere({0, 0, 0}, 0.1), lift}.bounds(lift.at(0.5));
  EXPECT_NEAR(ball.low[2], 0.4, 1e-14);
  EXPECT_NEAR(ball.high[0], 0.1, 1e-14);
  const Box3 floor = ScriptedShape{make_half_space({0, 0, 0}, {0, 0, 1}), lift}.bounds(lift.at(0.5));
  EXPECT_NEAR(floor.high[2], 0.5, 1e-14);
  EXPECT_EQ(floor.low[2], -k_infinity);
}

TEST(ScriptedShape, IsPresentFromItsStartUntilJustBeforeItsEnd) {
  const ScriptedShape always{make_sphere({0, 0, 0}, 1), {}};
  EXPECT_TRUE(always.present(-1e9) && always.present(1e9));
  const ScriptedShape visitor{make_sphere({0, 0, 0}, 1), {}, 1, 2};
  EXPECT_FALSE(visitor.present(0.999));
  EXPECT_TRUE(visitor.present(1));
  EXPECT_TRUE(visitor.present(1.999));
  EXPECT_FALSE(visitor.present(2));
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/scene/resolved.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

std::string with_shape(const std::string& shape) { return k_least + "[[collider]]\nname = \"pan\"\nshape = " + shape + "\n"; }

ShapePtr shape_of(const std::string& text) { return parse(with_shape(text)).colliders.at(0).shape; }

TEST(ShapeInScene, IsDrawnFromItsKeys) {
  const ShapePtr ball = shape_of("{ sphere = { centre_m = [0, 0, 0.1], radius_m = 0.05 } }");
  EXPECT_NEAR(ball->distance({0, 0, 0.1}), -0.05, 1e-15);
  EXPECT_NEAR(ball->distance({0, 0, 0.2}), 0.05, 1e-15);
}

TEST(ShapeInScene, IsScaledThenTurnedThenMoved) {
  // The tip at x = 1 goes to 2, turns to y = 2, moves to (5, 2, 0).
  const ShapePtr ball =
      shape_of("{ sphere = { centre_m = [1, 0, 0], radius_m = 0.1 }, scale = 2, rotate_deg = [0, 0, 90], move_m = [5, 0, 0] }");
  EXPECT_NEAR(ball->distance({5, 2, 0}), -0.2, 1e-12);
}

TEST(ShapeInScene, CombinesOthers) {
  const std::string two = "[ { sphere = { radius_m = 1 } }, { sphere = { centre_m = [1, 0, 0], radius_m = 1 } } ]";
  const Point left = {-0.5, 0, 0}, middle = {0.5, 0, 0}, right = {1.5, 0, 0};
  EXPECT_LT(shape_of("{ union = " + two + " }")->distance(right), 0);
  EXPECT_LT(shape_of("{ intersection = " + two + " }")->distance(middle), 0);
  EXPECT_GT(shape_of("{ intersection = " + two + " }")->distance(right), 0);
  EXPECT_LT(shape_of("{ difference = " + two + " }")->distance(left), 0);
  EXPECT_GT(shape_of("{ difference = " + two + " }")->distance(middle), 0);
}

TEST(ShapeInScene, RemembersHowItWasDrawnWithDefaultsFilledIn) {
  const auto drawn = resolved(parse(with_shape("{ sphere = { radius_m = 0.5 }, move_m = [1, 2, 3] }")))["collider"][0]["shape"];
  EXPECT_EQ(drawn["sphere"]["centre_m"], (Vector3{0, 0, 0}));
  EXPECT_EQ(drawn["move_m"], (Vector3{1, 2, 3}));
  EXPECT_EQ(drawn["scale"], 1.0);
}

TEST(ShapeInScene, MustBeExactlyOne) {
  const std::string shapes =
      "box, rounded_box, sphere, ellipsoid, cylinder, capsule, cone, superellipsoid, half_space, union, intersection, difference";
  EXPECT_EQ(error_of(with_shape("{ scale = 2 }")), "bread.toml:11: collider.pan.shape: found no shape, allowed: exactly one of " + shapes);
  EXPECT_EQ(error_of(with_shape("{ sphere = { radius_m = 1 }, union = [] }")),
            "bread.toml:11: collider.pan.shape: found sphere and union, allowed: exactly one of " + shapes);
  EXPECT_EQ(error_of(with_shape("{ shpere = { radius_m = 1 } }")),
            "bread.toml:11: collider.pan.shape: unknown key 'shpere', did you mean 'sphere'?");
}

TEST(ShapeInScene, IsCheckedKeyByKey) {
  EXPECT_EQ(error_of(with_shape("{ sphere = { radius_m = 0 } }")),
            "bread.toml:11: collider.pan.shape.sphere.radius_m: found 0, allowed: a number above 0");
  EXPECT_EQ(error_of(with_shape("{ sphere = { radius = 1 } }")),
            "bread.toml:11: collider.pan.shape.sphere: unknown key 'radius', did you mean 'radius_m'?");
  EXPECT_EQ(error_of(with_shape("{ sphere = {} }")),
            "bread.toml:11: collider.pan.shape.sphere.radius_m: missing, allowed: a number above 0");
  EXPECT_EQ(error_of(with_shape("{ sphere = { radius_m = 1 }, scale = 0 }")),
            "bread.toml:11: collider.pan.shape.scale: found 0, allowed: a number above 0");
  EXPECT_EQ(error_of(with_shape("{ union = [ { sphere = { radius_m = -1 } } ] }")),
            "bread.toml:11: collider.pan.shape.union.0.sphere.radius_m: found -1, allowed: a number above 0");
  EXPECT_EQ(error_of(with_shape("\"sphere\"")).rfind("bread.toml:11: collider.pan.shape: found \"sphere\", allowed: a shape, e.g.", 0), 0u);
}

TEST(ShapeInScene, WhoseValuesDoNotFitTogetherIsRefused) {
  const std::string message = error_of(with_shape("{ half_space = { normal = [0, 0, 0] } }"));
  EXPECT_EQ(message.rfind("bread.toml:11: collider.pan.shape.half_space: ", 0), 0u) << message;
}

TEST(ShapeInScene, CombinationsNeedParts) {
  EXPECT_EQ(error_of(with_shape("{ union = [] }")),
            "bread.toml:11: collider.pan.shape.union: found a list of 0, allowed: a list of at least 1 shape");
  EXPECT_EQ(error_of(with_shape("{ difference = [ { sphere = { radius_m = 1 } } ] }")),
            "bread.toml:11: collider.pan.shape.difference: found a list of 1, allowed: a list of at least 2 shapes");
}

TEST(ShapeInScene, NestsOnlySoDeep) {
  std::string shape = "{ sphere = { radius_m = 1 } }";
  for (int i = 0; i < 40; ++i) shape = "{ union = [ " + shape + " ] }";
  EXPECT_NE(error_of(with_shape(shape)).find("too deep, allowed: 32 levels"), std::string::npos);
}

}  // namespace
}  // namespace bake::test

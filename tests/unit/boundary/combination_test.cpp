// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "solver/boundary/fill.h"
#include "solver/boundary/rotation.h"
#include "tests/unit/boundary/sampling.h"

namespace bake {
namespace {

TEST(Union, IsInsideWhereAnyPartIs) {
  const ShapePtr pair = make_union({make_sphere({-0.2, 0, 0}, 0.1), make_sphere({0.2, 0, 0}, 0.05)});
  EXPECT_DOUBLE_EQ(pair->distance({-0.2, 0, 0}), -0.1);
  EXPECT_DOUBLE_EQ(pair->distance({0.2, 0, 0}), -0.05);
  EXPECT_DOUBLE_EQ(pair->distance({0, 0, 0}), 0.1);
  EXPECT_EQ(pair->normal({0.4, 0, 0}), (Vector3{1, 0, 0}));
  EXPECT_DOUBLE_EQ(pair->bounds().low[0], -0.3);
  EXPECT_DOUBLE_EQ(pair->bounds().high[0], 0.25);
  EXPECT_DOUBLE_EQ(pair->bounds().high[1], 0.1);
}

TEST(Intersection, CutsALoafFlatAtTheBottom) {
  const ShapePtr loaf = make_intersection({make_ellipsoid({0, 0, 0}, {0.1, 0.06, 0.05}), make_half_space({0, 0, -0.01}, {0, 0, -1})});
  EXPECT_DOUBLE_EQ(loaf->bounds().low[2], -0.01);
  EXPECT_DOUBLE_EQ(loaf->bounds().high[2], 0.05);
  EXPECT_NEAR(loaf->distance({0, 0, -0.012}), 0.002, 1e-15);
  EXPECT_EQ(loaf->normal({0, 0, -0.012}), (Vector3{0, 0, -1}));
  EXPECT_LT(loaf->distance({0, 0, 0.049}), 0);
}

TEST(Intersection, OfPartsThatAreApartIsEmpty) {
  const ShapePtr nothing = make_intersection({make_sphere({0, 0, 0}, 0.1), make_sphere({1, 0, 0}, 0.1)});
  EXPECT_TRUE(fill_lattice(*nothing, 0.01, 1, 0).empty());
  EXPECT_TRUE(fill_poisson(*nothing, 0.01, 0).empty());
}

TEST(Difference, MakesAHollowVessel) {
  const ShapePtr vessel = make_difference(make_cylinder({0, 0, 0}, {0, 0, 0.1}, 0.1), {make_cylinder({0, 0, 0.01}, {0, 0, 0.2}, 0.09)});
  EXPECT_NEAR(vessel->distance({0, 0, 0.05}), 0.04, 1e-15) << "in the hollow, above the bottom";
  EXPECT_NEAR(vessel->distance({0, 0, 0.005}), -0.005, 1e-15) << "in the bottom";
  EXPECT_NEAR(vessel->distance({0.095, 0, 0.05}), -0.005, 1e-15) << "in the wall";
  EXPECT_LT(length(vessel->normal({0, 0.08, 0.05}) - Vector3{0, -1, 0}), 1e-12) << "the wall's normal points into the hollow";
  EXPECT_DOUBLE_EQ(vessel->bounds().high[2], 0.1);
  const double volume = std::numbers::pi * (0.1 * 0.1 * 0.1 - 0.09 * 0.09 * 0.09);
  EXPECT_NEAR(vessel->volume() / volume, 1, 5e-4);
}

TEST(Transformed, KeepsDistancesUpToItsScaleAndTurnsNormals) {
  const Vector3 rotate_deg = {20, -50, 100}, move = {0.3, -0.1, 0.2};
  const Rotation rotation = matrix(quaternion(k_rad_per_deg * rotate_deg));
  for (const Sample& sample : exact_shapes()) {
    const ShapePtr moved = make_transformed(sample.shape, 2.5, rotate_deg, move);
    const Box3 box = moved->bounds();
    RandomPoints random({-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3});
    for (int i = 0; i < 500; ++i) {
      const Point drawn = random(), x = rotation * (2.5 * drawn) + move;
      ASSERT_NEAR(moved->distance(x), 2.5 * sample.shape->distance(drawn), 1e-13) << sample.name;
      ASSERT_LT(length(moved->normal(x) - rotation * sample.shape->normal(drawn)), 1e-6) << sample.name;
      ASSERT_TRUE(moved->distance(x) > 0 || holds(box, x)) << sample.name;
    }
  }
}

TEST(Transformed, KeepsVolumesUpToTheCubeOfItsScale) {
  for (const Sample& sample : exact_shapes()) {
    const ShapePtr moved = make_transformed(sample.shape, 2, {10, 20, 30}, {1, 2, 3});
    EXPECT_NEAR(moved->volume() / (8 * sample.volume), 1, 1e-12) << sample.name;
    EXPECT_NEAR(sampled_volume(*moved) / (8 * sample.volume), 1, 5e-4) << sample.name;
  }
}

TEST(Transformed, TurnsByTheRightHandRule) {
  const ShapePtr bar = make_transformed(make_box({0.2, 0, 0}, {0.1, 0.01, 0.01}), 1, {0, 0, 90}, {0, 0, 0});
  EXPECT_LT(bar->distance({0, 0.2, 0}), 0);
  EXPECT_GT(bar->distance({0, -0.2, 0}), 0);
  EXPECT_NEAR(bar->bounds().high[1], 0.3, 1e-12);
}

TEST(Transformed, KeepsInfiniteBoundsWithoutNaN) {
  const ShapePtr floor = make_half_space({0, 0, 0}, {0, 0, 1});
  const Box3 lifted = make_transformed(floor, 1, {0, 0, 0}, {0, 0, 0.5})->bounds();
  EXPECT_DOUBLE_EQ(lifted.high[2], 0.5);
  EXPECT_EQ(lifted.low[0], -k_infinity);
  EXPECT_EQ(make_transformed(floor, 1, {30, 0, 0}, {0, 0, 0.5})->bounds().high[2], k_infinity);
}

TEST(Combination, RefusesEmptyListsNullShapesAndScalesThatAreNotPositive) {
  const ShapePtr ball = make_sphere({0, 0, 0}, 1);
  EXPECT_THROW(make_union({}), std::invalid_argument);
  EXPECT_THROW(make_intersection({ball, nullptr}), std::invalid_argument);
  EXPECT_THROW(make_difference(nullptr, {ball}), std::invalid_argument);
  EXPECT_THROW(make_transformed(ball, 0, {0, 0, 0}, {0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace bake

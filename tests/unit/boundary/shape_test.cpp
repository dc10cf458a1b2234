// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "solver/boundary/fill.h"
#include "tests/unit/boundary/sampling.h"

namespace bake {
namespace {

Vector3 gradient(const Shape& shape, const Point& x) {
  constexpr double k_step = 1e-7;
  Vector3 slope;
  for (int i = 0; i < 3; ++i) {
    Point ahead = x, behind = x;
    ahead[i] += k_step, behind[i] -= k_step;
    slope[i] = (shape.distance(ahead) - shape.distance(behind)) / (2 * k_step);
  }
  return slope;
}

RandomPoints around_the_origin() { return {{-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3}}; }

TEST(Shape, DistanceIsNegativeInsideAndPositiveOutside) {
  for (const Sample& sample : exact_shapes()) {
    EXPECT_LT(sample.shape->distance(sample.inside), 0) << sample.name;
    EXPECT_GT(sample.shape->distance(sample.outside), 0) << sample.name;
  }
}

TEST(Shape, DistanceNeverGrowsFasterThanOne) {
  for (const Sample& sample : exact_shapes()) {
    RandomPoints random = around_the_origin();
    RandomPoints nearby({-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01});
    for (int i = 0; i < 4000; ++i) {
      const Point x = random(), y = i % 2 ? random() : x + nearby();
      ASSERT_LE(std::abs(sample.shape->distance(x) - sample.shape->distance(y)), length(x - y) * (1 + 1e-9) + 1e-12) << sample.name;
    }
  }
}

TEST(Shape, WalkingBackTheDistanceAlongTheNormalEndsOnTheSurface) {
  for (const Sample& sample : exact_shapes()) {
    RandomPoints random = around_the_origin();
    for (int i = 0; i < 4000; ++i) {
      const Point x = random();
      const Point foot = x - sample.shape->distance(x) * sample.shape->normal(x);
      ASSERT_NEAR(sample.shape->distance(foot), 0, 1e-11) << sample.name;
    }
  }
}

TEST(Shape, NormalIsTheGradientOfTheDistance) {
  for (const Sample& sample : exact_shapes()) {
    RandomPoints random = around_the_origin();
    int smooth = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point x = random();
      const Vector3 slope = gradient(*sample.shape, x);
      if (std::abs(length(slope) - 1) > 1e-4) continue;  // a kink of the distance is nearby
      ++smooth;
      ASSERT_LT(length(sample.shape->normal(x) - slope), 1e-4) << sample.name;
      ASSERT_LT(length(sample.shape->Shape::normal(x) - slope), 1e-4) << sample.name;
    }
    EXPECT_GT(smooth, 1990) << sample.name;
  }
}

TEST(Shape, StaysFiniteWithAUnitNormalWhereTheDistanceHasNoGradientAndFarAway) {
  std::vector<Sample> samples = exact_shapes();
  samples.push_back({"superellipsoid", make_superellipsoid({0.1, 0.06, 0.05}, 3, 20), {}, {}, 0});
  samples.push_back({"octahedron", make_superellipsoid({0.1, 0.1, 0.1}, 1, 1), {}, {}, 0});
  samples.push_back({"half_space", make_half_space({0, 0, 0}, {0, 3, 4}), {}, {}, 0});
  const std::vector<Point> peculiar = {{0, 0, 0},     {0, 0.01, 0},  {0, 0, 0.01},  {0.01, -0.02, 0}, {0.1, 0, 0}, {0, 0, 0.07},
                                       {0, 0, -0.05}, {0.1, 0.1, 0}, {1e-13, 0, 0}, {1e6, -1e6, 1e6}, {0, 0, 1e9}, {-1e9, 0, 1e-9}};
  for (const Sample& sample : samples) {
    for (const Point& x : peculiar) {
      EXPECT_TRUE(std::isfinite(sample.shape->distance(x))) << sample.name;
      EXPECT_NEAR(length(sample.shape->normal(x)), 1, 1e-12) << sample.name;
    }
  }
}

TEST(Shape, HoldsTheVolumeOfItsClosedForm) {
  for (const Sample& sample : exact_shapes()) {
    EXPECT_NEAR(sample.shape->volume() / sample.volume, 1, 1e-12) << sample.name;
    EXPECT_NEAR(sampled_volume(*sample.shape) / sample.volume, 1, 5e-4) << sample.name;
  }
}

TEST(Shape, BoundsHoldTheSolid) {
  std::vector<Sample> samples = exact_shapes();
  samples.push_back({"superellipsoid", make_superellipsoid({0.1, 0.06, 0.05}, 3, 5), {}, {}, 0});
  for (const Sample& sample : samples) {
    const Box3 box = sample.shape->bounds();
    RandomPoints random = around_the_origin();
    for (int i = 0; i < 20000; ++i) {
      const Point x = random();
      ASSERT_TRUE(sample.shape->distance(x) > 0 || holds(box, x)) << sample.name;
    }
  }
}

TEST(Shape, BoundsTouchTheSolidOnEverySide) {
  for (const Sample& sample : exact_shapes()) {
    const Box3 box = sample.shape->bounds();
    for (int side = 0; side < 6; ++side) {
      const int axis = side / 2;
      const double inwards = side % 2 ? -1 : 1;
      Vector3 normal = {0, 0, 0};
      normal[axis] = inwards;
      Point just_within = side % 2 ? box.high : box.low;
      just_within[axis] += inwards * 0.003;
      const ShapePtr cap = make_intersection({sample.shape, make_half_space(just_within, normal)});
      EXPECT_FALSE(fill_lattice(*cap, 0.001, 0, 0).empty()) << sample.name << " side " << side;
    }
  }
}

TEST(Shape, BoxAndCylinderHaveTheirKnownDistances) {
  const ShapePtr box = make_box({0, 0, 0}, {1, 2, 3});
  EXPECT_DOUBLE_EQ(box->distance({0, 0, 0}), -1);
  EXPECT_DOUBLE_EQ(box->distance({4, 6, 0}), 5);
  const ShapePtr cylinder = make_cylinder({0, 0, -1}, {0, 0, 1}, 0.5);
  EXPECT_DOUBLE_EQ(cylinder->distance({0, 0, 0}), -0.5);
  EXPECT_DOUBLE_EQ(cylinder->distance({0, 0, 3}), 2);
  EXPECT_DOUBLE_EQ(cylinder->distance({3.5, 0, 5}), 5);
}

TEST(HalfSpace, IsInsideAgainstItsNormalWhateverTheNormalsLength) {
  const ShapePtr floor = make_half_space({0, 0, 0.1}, {0, 0, 5});
  EXPECT_DOUBLE_EQ(floor->distance({3, 4, 0.3}), 0.2);
  EXPECT_DOUBLE_EQ(floor->distance({3, 4, 0}), -0.1);
  EXPECT_EQ(floor->normal({1, 2, 3}), (Vector3{0, 0, 1}));
}

TEST(HalfSpace, HasOneFiniteBoundIfItsFaceFollowsTheAxes) {
  EXPECT_EQ(make_half_space({0, 0, 0.1}, {0, 0, 5})->bounds().high[2], 0.1);
  EXPECT_EQ(make_half_space({0, 0, 0.1}, {0, 0, 5})->bounds().low[2], -k_infinity);
  EXPECT_EQ(make_half_space({0.2, 0, 0}, {-1, 0, 0})->bounds().low[0], 0.2);
  EXPECT_EQ(make_half_space({0, 0, 0}, {1, 1, 0})->bounds().high[0], k_infinity);
}

TEST(Ellipsoid, OfEqualAxesIsASphere) {
  const ShapePtr ball = make_ellipsoid({0, 0, 0}, {0.1, 0.1, 0.1}), sphere = make_sphere({0, 0, 0}, 0.1);
  RandomPoints random = around_the_origin();
  for (int i = 0; i < 1000; ++i) {
    const Point x = random();
    ASSERT_NEAR(ball->distance(x), sphere->distance(x), 1e-14);
    ASSERT_LT(length(ball->normal(x) - sphere->normal(x)), 1e-12);
  }
}

TEST(Ellipsoid, IsExactAndContinuousAcrossItsSymmetryPlanes) {
  const ShapePtr flat = make_ellipsoid({0, 0, 0}, {0.12, 0.08, 0.01});
  EXPECT_NEAR(flat->distance({0, 0, 0}), -0.01, 1e-15);
  EXPECT_NEAR(flat->distance({0.2, 0, 0}), 0.08, 1e-15);
  RandomPoints random({-0.15, -0.1, 0}, {0.15, 0.1, 0});
  for (int i = 0; i < 1000; ++i) {
    const Point x = random();
    for (const double off : {1e-6, 1e-9, 1e-11, 1e-13, 1e-17}) {
      ASSERT_NEAR(flat->distance(x + Vector3{0, 0, off}), flat->distance(x), off + 1e-12) << x[0] << " " << x[1] << " " << off;
    }
    ASSERT_NEAR(flat->distance(x - flat->distance(x) * flat->normal(x)), 0, 1e-12);
  }
}

TEST(Superellipsoid, HoldsTheVolumeOfItsClosedForm) {
  for (const auto& [p, q] : {std::pair{2.0, 2.0}, {4.0, 3.0}, {10.0, 2.0}, {1.0, 1.0}}) {
    const double e = 2 / q, f = 2 / p;
    const double volume = 2 * 0.1 * 0.06 * 0.05 * e * f * std::beta(e / 2 + 1, e) * std::beta(f / 2, f / 2);
    const ShapePtr loaf = make_superellipsoid({0.1, 0.06, 0.05}, p, q);
    EXPECT_NEAR(loaf->volume() / volume, 1, 1e-12) << p << " " << q;
    EXPECT_NEAR(sampled_volume(*loaf) / volume, 1, 5e-4) << p << " " << q;
  }
}

TEST(Superellipsoid, IsRightToFirstOrderAtTheSurfaceAndNeverMoreThanTheExactDistance) {
  const ShapePtr round = make_superellipsoid({0.12, 0.06, 0.08}, 2, 2), exact = make_ellipsoid({0, 0, 0}, {0.12, 0.06, 0.08});
  RandomPoints random = around_the_origin();
  for (int i = 0; i < 4000; ++i) {
    const Point x = random();
    const double distance = exact->distance(x);
    ASSERT_EQ(round->distance(x) < 0, distance < 0);
    ASSERT_LE(round->distance(x), distance + 1e-14);
    const Point near_surface = x - (distance - 0.002) * exact->normal(x);
    ASSERT_NEAR(round->distance(near_surface), exact->distance(near_surface), 1e-4);
    ASSERT_LT(length(round->normal(near_surface) - exact->normal(near_surface)), 0.1);
  }
}

TEST(Superellipsoid, IsHardlySteeperThanOneNearTheSurface) {
  const ShapePtr loaf = make_superellipsoid({0.12, 0.06, 0.05}, 4, 2.5);
  RandomPoints random({-0.13, -0.07, -0.06}, {0.13, 0.07, 0.06});
  for (int i = 0; i < 4000; ++i) {
    const Point x = random();
    if (std::abs(loaf->distance(x)) < 0.005) {
      ASSERT_LT(length(gradient(*loaf, x)), 1.1);
    }
  }
}

TEST(Superellipsoid, ApproachesABoxForLargeExponents) {
  const ShapePtr brick = make_superellipsoid({0.12, 0.06, 0.05}, 20, 20);
  EXPECT_NEAR(brick->distance({0.02, 0.01, 0.06}), 0.01, 1e-6);
  EXPECT_NEAR(brick->distance({0.11, 0.01, 0.02}), -0.01, 1e-3);
}

TEST(ShapeCheck, NamesValuesThatDoNotFitTogether) {
  RoundedBox box;
  box.half_extents_m = {1, 2, 3}, box.radius_m = 1;
  EXPECT_EQ(box.check(), "");
  box.radius_m = 1.1;
  EXPECT_EQ(box.check(), "radius_m is larger than the smallest of half_extents_m");
  EXPECT_EQ(Cylinder{}.check(), "from_m and to_m are the same point");
  Cone cone;
  cone.to_m = {0, 0, 1};
  EXPECT_EQ(cone.check(), "from_radius_m and to_radius_m are both 0");
  HalfSpace plane;
  EXPECT_EQ(plane.check(), "");
  plane.outward_normal = {0, 0, 0};
  EXPECT_EQ(plane.check(), "normal has length 0");
}

}  // namespace
}  // namespace bake

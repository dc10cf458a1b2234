// SPDX-License-Identifier: MIT
#include "solver/boundary/fill.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "tests/support/threads_restored.h"
#include "tests/unit/boundary/sampling.h"

namespace bake {
namespace {

double filled_volume(const std::vector<Point>& points, double spacing) {
  return static_cast<double>(points.size()) * spacing * spacing * spacing;
}

void expect_inside(const Shape& shape, const std::vector<Point>& points) {
  for (const Point& x : points) ASSERT_LE(shape.distance(x), 0);
}

double distance_to_nearest(const std::vector<Point>& points, const Point& x) {
  double nearest = k_infinity;
  for (const Point& point : points) nearest = std::min(nearest, length(point - x));
  return nearest;
}

TEST(FillLattice, CountsTheVolumeForEveryJitter) {
  for (const Sample& sample : exact_shapes()) {
    for (const double jitter : {0.0, 0.5, 1.0}) {
      const auto points = fill_lattice(*sample.shape, 0.004, jitter, 3);
      expect_inside(*sample.shape, points);
      EXPECT_NEAR(filled_volume(points, 0.004) / sample.volume, 1, 0.02) << sample.name << " jitter " << jitter;
    }
  }
}

TEST(FillLattice, WithoutJitterIsACentredLattice) {
  const auto points = fill_lattice(*make_box({0, 0, 0}, {1, 0.5, 0.5}), 0.5, 0, 0);
  ASSERT_EQ(points.size(), 16u);
  EXPECT_EQ(points.front(), (Point{-0.75, -0.25, -0.25}));
  EXPECT_EQ(points[1], (Point{-0.75, -0.25, 0.25}));
  EXPECT_EQ(points.back(), (Point{0.75, 0.25, 0.25}));
}

TEST(FillLattice, DisplacesEachPointWithinItsShareOfTheCube) {
  const ShapePtr box = make_box({0, 0, 0}, {1, 1, 1});
  const auto still = fill_lattice(*box, 0.1, 0, 1), jittered = fill_lattice(*box, 0.1, 0.6, 1);
  ASSERT_EQ(still.size(), jittered.size());
  double farthest = 0;
  for (std::size_t i = 0; i < still.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(still[i][axis] - jittered[i][axis]));
  }
  EXPECT_LE(farthest, 0.03 + 1e-12);
  EXPECT_GT(farthest, 0.0299);
}

TEST(FillLattice, KeepsASheetThinnerThanTheSpacing) { EXPECT_EQ(fill_lattice(*make_box({0, 0, 0}, {1, 1, 0.01}), 0.5, 0, 0).size(), 16u); }

TEST(VisitLattice, FindsTheSamePointsAtThePlacesThatAreWanted) {
  const ShapePtr ball = make_sphere({0, 0, 0}, 1);
  std::vector<Point> found, expected;
  visit_lattice(
      *ball, 0.13, 0, 5, [](const Point& place) { return place[1] > 0.3; }, [&](const Point& x) { found.push_back(x); });
  for (const Point& x : fill_lattice(*ball, 0.13, 0, 5))
    if (x[1] > 0.3) expected.push_back(x);
  EXPECT_EQ(found, expected);
  // displaced at random, each place by its own numbers
  const std::vector<Point> all = fill_lattice(*ball, 0.13, 0.7, 5);
  found.clear();
  visit_lattice(
      *ball, 0.13, 0.7, 5, [](const Point& place) { return place[1] > 0.3; }, [&](const Point& x) { found.push_back(x); });
  ASSERT_GT(found.size(), 100u);
  for (const Point& x : found) EXPECT_NE(std::find(all.begin(), all.end(), x), all.end());
}

TEST(EstimateFilling, KnowsAboutHowManyPointsThereWillBe) {
  for (const Sample& sample : exact_shapes()) {
    const FillingSize size = estimate_filling(*sample.shape, std::cbrt(sample.volume / 1e12));
    EXPECT_NEAR(size.points / 1e12, 1, 0.03) << sample.name;
    EXPECT_GT(size.places, size.points) << sample.name;
  }
}

TEST(SampledVolume, IsRightForCombinations) {
  const double pi = std::numbers::pi;
  const auto shell = [](double thickness) {
    return make_difference(make_sphere({0, 0, 0}, 0.1), {make_sphere({0, 0, 0}, 0.1 - thickness)});
  };
  for (const double t : {0.05, 0.01, 0.001}) EXPECT_NEAR(shell(t)->volume() / (4 * pi / 3 * (1e-3 - std::pow(0.1 - t, 3))), 1, 1e-3) << t;
  const ShapePtr grains = make_union({make_sphere({0, 0, 0}, 1e-3), make_sphere({100, 1, 1}, 2e-3)});
  EXPECT_NEAR(grains->volume() / (4 * pi / 3 * 9e-9), 1, 1e-3);
  const ShapePtr slanting = make_transformed(make_box({0, 0, 0}, {0.1, 0.1, 0.002}), 1, {0, 45, 0}, {0.01, 0, 0});
  EXPECT_NEAR(make_intersection({slanting, make_half_space({0.01, 0, 0}, {0, 1, 0})})->volume() / (8e-5), 1, 1e-3);
  const ShapePtr hole = make_difference(make_box({0, 0, 0}, {0.1, 0.1, 0.1}), {make_superellipsoid({0.08, 0.09, 0.07}, 20, 20)});
  EXPECT_NEAR(hole->volume() / (8e-3 - make_superellipsoid({0.08, 0.09, 0.07}, 20, 20)->volume()), 1, 1e-3);
}

TEST(SampledVolume, OfNothingIsZeroAndOfAFloorInfinite) {
  EXPECT_EQ(make_half_space({0, 0, 0}, {0, 0, 1})->volume(), k_infinity);
  for (const double apart : {0.2, 0.3})  // touching, and not
    EXPECT_EQ(make_intersection({make_sphere({0, 0, 0}, 0.1), make_sphere({0, 0, apart}, 0.1)})->volume(), 0) << apart;
  EXPECT_EQ(make_difference(make_sphere({0, 0, 0}, 0.1), {make_sphere({0, 0, 0}, 0.2)})->volume(), 0);
}

TEST(SampledVolume, HasTheSameBitsForAnyNumberOfThreads) {
  const ShapePtr slit = make_difference(make_superellipsoid({0.08, 0.09, 0.07}, 3, 4), {make_box({0, 0, 0.07}, {0.1, 0.01, 0.02})});
  const ThreadsRestored restored;
  std::set<double> volumes;
  for (const int threads : {1, 2, 3, 7}) {
    omp_set_num_threads(threads);
    volumes.insert(sampled_volume(*slit));
  }
  EXPECT_EQ(volumes.size(), 1u);
}

TEST(SampledVolume, IsNoMoreExactThanIsAsked) {
  const ShapePtr cap = make_intersection({make_sphere({0, 0, 0}, 0.1), make_half_space({0, 0, 0.09}, {0, 0, -1})});
  const double volume = std::numbers::pi * 0.01 * 0.01 * (0.3 - 0.01) / 3;
  EXPECT_NEAR(cap->volume() / volume, 1, 1e-3);
  EXPECT_NEAR(sampled_volume(*cap, 1), volume, 4e-4);
  EXPECT_GT(std::abs(sampled_volume(*cap, 1) / volume - 1), 1e-3);
}

TEST(FillPoisson, CountsTheVolumeOfEveryShape) {
  for (const Sample& sample : exact_shapes()) {
    const double spacing = std::cbrt(sample.volume / 4000);
    const auto points = fill_poisson(*sample.shape, spacing, 3);
    expect_inside(*sample.shape, points);
    EXPECT_NEAR(filled_volume(points, spacing) / sample.volume, 1, 0.05) << sample.name;
  }
}

TEST(FillPoisson, CountsTheVolumeCloselyWhenPointsAreMany) {
  EXPECT_NEAR(filled_volume(fill_poisson(*make_box({0, 0, 0}, {0.5, 0.5, 0.5}), 0.025, 1), 0.025), 1, 0.01);
}

TEST(FillPoisson, KeepsPointsApart) {
  auto points = fill_poisson(*make_sphere({0, 0, 0}, 1), 0.15, 5);
  while (!points.empty()) {
    const Point x = points.back();
    points.pop_back();
    ASSERT_GE(distance_to_nearest(points, x), k_poisson_radius * 0.15);
  }
}

TEST(FillPoisson, LeavesHardlyRoomForAnotherPoint) {
  const auto points = fill_poisson(*make_box({0, 0, 0}, {1, 1, 1}), 0.2, 5);
  RandomPoints random({-0.8, -0.8, -0.8}, {0.8, 0.8, 0.8});
  int uncovered = 0;
  for (int i = 0; i < 5000; ++i) uncovered += distance_to_nearest(points, random()) > k_poisson_radius * 0.2;
  EXPECT_LT(uncovered, 50);
}

TEST(FillPoisson, IsAsDenseAtTheRimAsInTheMiddle) {
  const auto points = fill_poisson(*make_box({0, 0, 0}, {1, 1, 1}), 0.05, 2);
  const auto at_rim = std::count_if(points.begin(), points.end(), [](const Point& x) { return std::abs(x[0]) > 0.95; });
  const double rim_volume = 2 * 0.05 * 2 * 2;
  EXPECT_NEAR(static_cast<double>(at_rim) * 0.05 * 0.05 * 0.05 / rim_volume, 1, 0.05);
}

TEST(FillPoisson, ReachesPartsThatAreApart) {
  const auto points = fill_poisson(*make_union({make_sphere({-1, 0, 0}, 0.2), make_sphere({1, 0, 0}, 0.2)}), 0.05, 2);
  const auto left = std::count_if(points.begin(), points.end(), [](const Point& x) { return x[0] < 0; });
  EXPECT_NEAR(static_cast<double>(left) / static_cast<double>(points.size()), 0.5, 0.05);
}

TEST(Fill, IsAFunctionOfTheSeed) {
  const ShapePtr ball = make_sphere({0, 0, 0}, 1);
  EXPECT_EQ(fill_lattice(*ball, 0.2, 0.5, 1), fill_lattice(*ball, 0.2, 0.5, 1));
  EXPECT_NE(fill_lattice(*ball, 0.2, 0.5, 1), fill_lattice(*ball, 0.2, 0.5, 2));
  EXPECT_EQ(fill_poisson(*ball, 0.2, 1), fill_poisson(*ball, 0.2, 1));
  EXPECT_NE(fill_poisson(*ball, 0.2, 1), fill_poisson(*ball, 0.2, 2));
}

TEST(Fill, IsTheSameOnEveryPlatform) {
  const ShapePtr ball = make_sphere({0, 0, 0}, 1);
  const auto lattice = fill_lattice(*ball, 0.2, 0.5, 1), poisson = fill_poisson(*ball, 0.2, 1);
  EXPECT_EQ(lattice.size(), 522u);
  EXPECT_LT(length(lattice[0] - Point{-0.86917982940455463, -0.32689113492243921, -0.27535481078713758}), 1e-13);
  EXPECT_EQ(poisson.size(), 531u);
  EXPECT_LT(length(poisson[0] - Point{-0.97267216248371369, 0.10115049201831283, -0.1120443976609391}), 1e-13);
}

TEST(Fill, RefusesShapesWithoutEndAndSpacingsThatMakeNoSense) {
  const ShapePtr floor = make_half_space({0, 0, 0}, {0, 0, 1}), ball = make_sphere({0, 0, 0}, 1);
  EXPECT_THROW(fill_lattice(*floor, 0.1, 0, 0), std::invalid_argument);
  EXPECT_THROW(fill_poisson(*floor, 0.1, 0), std::invalid_argument);
  for (const double spacing : {0.0, -1.0, k_infinity, std::nan(""), 1e-6}) {
    EXPECT_THROW(fill_lattice(*ball, spacing, 0, 0), std::invalid_argument) << spacing;
    EXPECT_THROW(fill_poisson(*ball, spacing, 0), std::invalid_argument) << spacing;
  }
}

}  // namespace
}  // namespace bake

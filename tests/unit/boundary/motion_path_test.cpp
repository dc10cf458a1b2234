// SPDX-License-Identifier: MIT
#include "solver/boundary/motion_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/unit/boundary/sampling.h"

namespace bake {
namespace {

const Point k_pivot = {0.1, -0.2, 0.3};

std::vector<Keyframe> winding_keys() {
  return {{0, {0, 0, 0}, {0, 0, 0}}, {1, {0.1, 0, 0.2}, {30, 40, -50}}, {3, {0.1, 0.3, 0}, {-80, 10, 20}}, {3.5, {0, 0, 0}, {0, 0, 90}}};
}

void expect_near(const Vector3& found, const Vector3& expected, double tolerance) {
  EXPECT_LT(length(found - expected), tolerance) << found[0] << " " << found[1] << " " << found[2];
}

TEST(RigidPath, WithoutKeysRestsWhereDrawn) {
  const RigidState state = RigidPath{}.at(5);
  EXPECT_EQ(state.to_drawn({1, 2, 3}), (Point{1, 2, 3}));
  EXPECT_EQ(state.velocity_at({1, 2, 3}), (Vector3{0, 0, 0}));
  EXPECT_FALSE(RigidPath{}.moves());
  expect_near(RigidPath({}, k_pivot).at(0).to_world({1, 2, 3}), {1, 2, 3}, 1e-15);
}

TEST(RigidPath, HitsItsKeysFromBothSides) {
  const RigidPath path(winding_keys(), k_pivot);
  for (const Keyframe& key : winding_keys()) {
    const Rotation expected = matrix(quaternion(k_rad_per_deg * key.rotation_deg));
    for (const double time : {key.time_s, std::nextafter(key.time_s, -1.0)}) {
      const RigidState state = path.at(time);
      expect_near(state.centre, k_pivot + key.position_m, 1e-14);
      for (int row = 0; row < 3; ++row) expect_near(state.rotation[row], expected[row], 1e-14);
    }
  }
}

TEST(RigidPath, VelocityIsTheRateOfChangeOfThePose) {
  const RigidPath path(winding_keys(), k_pivot);
  const Point drawn = {0.5, 0.6, -0.7};
  for (const double time : {0.3, 0.9, 1.7, 2.9, 3.2}) {
    const double step = 1e-6;
    const Vector3 rate = (0.5 / step) * (path.at(time + step).to_world(drawn) - path.at(time - step).to_world(drawn));
    expect_near(path.at(time).velocity_at(path.at(time).to_world(drawn)), rate, 1e-8);
  }
}

TEST(RigidPath, RestsBeforeTheFirstAndAfterTheLastKey) {
  const RigidPath path(winding_keys(), k_pivot);
  for (const double time : {-1.0, 3.5, 10.0}) expect_near(path.at(time).velocity_at({1, 1, 1}), {0, 0, 0}, 1e-15);
  expect_near(path.at(-1).to_world({1, 2, 3}), {1, 2, 3}, 1e-15);
  expect_near(path.at(10).to_world(k_pivot + Vector3{1, 0, 0}), k_pivot + Vector3{0, 1, 0}, 1e-14);
}

TEST(RigidPath, AtAKeyAlreadyMovesAsInTheLegThatBegins) {
  const RigidPath path({{0, {0, 0, 0}, {0, 0, 0}}, {1, {1, 0, 0}, {0, 0, 0}}, {2, {1, 5, 0}, {0, 0, 0}}}, {0, 0, 0});
  expect_near(path.at(0).velocity, {1, 0, 0}, 1e-14);
  expect_near(path.at(1).velocity, {0, 5, 0}, 1e-14);
}

TEST(RigidPath, ToDrawnUndoesToWorld) {
  RandomPoints random({-1, -1, -1}, {1, 1, 1});
  const RigidState state = RigidPath(winding_keys(), k_pivot).at(2.2);
  for (int i = 0; i < 100; ++i) {
    const Point x = random();
    expect_near(state.to_drawn(state.to_world(x)), x, 1e-14);
  }
}

TEST(RigidPath, TurnsWholeTurnsAboutOneAxisAsWritten) {
  const RigidPath twist({{0, {0, 0, 0}, {0, 0, 0}}, {2, {0, 0, 0}, {0, 0, 720}}}, {0, 0, 0});
  expect_near(twist.at(0.5).angular_velocity, {0, 0, 2 * std::numbers::pi}, 1e-13);
  expect_near(twist.at(0.25).to_world({1, 0, 0}), {0, 1, 0}, 1e-13);
}

TEST(RigidPath, TurnsTheShorterWayBetweenDifferentAxes) {
  const RigidPath path({{0, {0, 0, 0}, {0, 0, 179}}, {1, {0, 0, 0}, {0, 1e-3, -179}}}, {0, 0, 0});
  EXPECT_NEAR(length(path.at(0.5).angular_velocity), 2 * k_rad_per_deg, 1e-4);
}

constexpr Box3 k_everywhere{{-k_infinity, -k_infinity, -k_infinity}, {k_infinity, k_infinity, k_infinity}};

TEST(RigidPath, LargestSpeedBoundsEveryPointOfTheBox) {
  const RigidPath path(winding_keys(), k_pivot);
  const Box3 box{{-0.1, 0, 0.2}, {0.4, 0.1, 0.5}};
  RandomPoints random(box.low, box.high);
  double fastest = 0;
  for (double time = 0; time < 3.5; time += 0.01) {
    const RigidState state = path.at(time);
    for (int i = 0; i < 20; ++i) fastest = std::max(fastest, length(state.velocity_at(state.to_world(random()))));
  }
  EXPECT_LE(fastest, path.largest_speed(box, k_everywhere));
  EXPECT_GT(fastest, 0.6 * path.largest_speed(box, k_everywhere));
}

TEST(RigidPath, LargestSpeedOfWhatHasNoEndIsThatInTheRegion) {
  const RigidPath path(winding_keys(), k_pivot);
  const Box3 endless = make_half_space({0, 0, 0}, {0, 0, 1})->bounds(), region{{-0.3, 0.1, -0.2}, {0.5, 0.7, 0.4}};
  RandomPoints random(region.low, region.high);
  double fastest = 0;
  for (double time = 0; time < 3.5; time += 0.01)
    for (int i = 0; i < 20; ++i) fastest = std::max(fastest, length(path.at(time).velocity_at(random())));
  EXPECT_LE(fastest, path.largest_speed(endless, region));
  EXPECT_GT(fastest, 0.6 * path.largest_speed(endless, region));
}

TEST(RigidPath, LargestSpeedIsExactForPureMotions) {
  const Box3 box{{0, 0, 0}, {3, 4, 7}}, endless = make_half_space({0, 0, 0}, {0, 0, 1})->bounds();
  const RigidPath slide({{0, {0, 0, 0}, {0, 0, 0}}, {2, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 0});
  EXPECT_DOUBLE_EQ(slide.largest_speed(box, k_everywhere), 0.5);
  EXPECT_DOUBLE_EQ(slide.largest_speed(endless, k_everywhere), 0.5);
  const RigidPath spin({{0, {0, 0, 0}, {0, 0, 0}}, {2, {0, 0, 0}, {0, 0, 360}}}, {0, 0, 0});
  EXPECT_NEAR(spin.largest_speed(box, k_everywhere), std::numbers::pi * 5, 1e-13);
  EXPECT_EQ(spin.largest_speed(endless, k_everywhere), k_infinity);
}

TEST(RigidPath, RefusesTimesThatDoNotRise) {
  const auto path = [](double second_time_s) { return RigidPath({{1, {}, {}}, {second_time_s, {}, {}}}, {0, 0, 0}); };
  EXPECT_NO_THROW(path(1.5));
  EXPECT_THROW(path(1), std::invalid_argument);
  EXPECT_THROW(path(0.5), std::invalid_argument);
  EXPECT_THROW(path(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace bake

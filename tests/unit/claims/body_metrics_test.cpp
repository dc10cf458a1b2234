// SPDX-License-Identifier: MIT
// Metrics of a body as a whole, on frames that are written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/claims/finite.h"
#include "tests/unit/claims/written_run.h"

namespace bake {
namespace {

/// A slab of 10 x 6 x 3 particles of 1 m^3, a metre apart.
std::vector<Dot> slab() {
  std::vector<Dot> dots;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 3; ++k) dots.push_back({static_cast<std::int64_t>(dots.size()), {1.0 * i, 1.0 * j, 1.0 * k}});
  return dots;
}

template <class Move>
std::vector<Dot> moved(std::vector<Dot> dots, Move move) {
  for (Dot& dot : dots) dot.at = move(dot.at);
  return dots;
}

class BodyMetrics : public WrittenRun {
 protected:
  BodyMetrics() : WrittenRun(R"({"summary": {"state": "done"}, "scene": {}})", "time_s\n0\n1\n2\n") {
    frame(0, {});
    frame(1, slab());
  }
  const MetricPlace since_1{.reference_time_s = 1};
  /// Turned about the y axis by `angle` and shifted.
  static Vector3 tossed(const Vector3& x, double angle) {
    return {std::cos(angle) * x[0] + std::sin(angle) * x[2] + 20, x[1] - 3, -std::sin(angle) * x[0] + std::cos(angle) * x[2] + 7};
  }
};

TEST_F(BodyMetrics, FindThePartThatIsTheLargestLump) {
  frame(2, slab());
  EXPECT_DOUBLE_EQ(measure("largest_lump", {}), 1);
  frame(2, moved(slab(), [](Vector3 x) { return Vector3{x[0] < 6.5 ? x[0] : x[0] + 0.4, x[1], x[2]}; }));
  EXPECT_DOUBLE_EQ(measure("largest_lump", {}), 1) << "a gap of 1.4 is no more than that between particles of a filling";
  frame(2, moved(slab(), [](Vector3 x) { return Vector3{x[0] < 6.5 ? x[0] : x[0] + 0.6, x[1], x[2]}; }));
  EXPECT_DOUBLE_EQ(measure("largest_lump", {}), 0.7);
  EXPECT_TRUE(std::isnan(measure("largest_lump", {.time_s = 0}))) << "nothing is there yet";
}

TEST_F(BodyMetrics, FindThatASlabWasTurnedOverAsItWas) {
  frame(2, moved(slab(), [](const Vector3& x) { return tossed(x, M_PI); }));
  EXPECT_NEAR(measure("turned_up", since_1), -1, 1e-6);
  EXPECT_NEAR(measure("deformation", since_1), 0, 1e-6);
  EXPECT_NEAR(measure("width_change", since_1), 0, 1e-6);
  frame(2, moved(slab(), [](const Vector3& x) { return tossed(x, M_PI / 3); }));
  EXPECT_NEAR(measure("turned_up", since_1), 0.5, 1e-6);
  EXPECT_NEAR(measure("deformation", since_1), 0, 1e-6);
}

TEST_F(BodyMetrics, FindHowMuchASlabWasDeformed) {
  frame(2, moved(slab(), [](Vector3 x) { return tossed({1.2 * x[0], x[1], x[2]}, M_PI); }));
  EXPECT_NEAR(measure("turned_up", since_1), -1, 1e-6);
  EXPECT_NEAR(measure("width_change", since_1), 0.2, 1e-6) << "of x alone, the larger change";
  // mean squares about the middle: 99/12 along x, 35/12 along y, 8/12 along z; x is a fifth off
  EXPECT_NEAR(measure("deformation", since_1), 0.2 * std::sqrt(99. / (99 + 35 + 8)), 1e-6);
  EXPECT_THROW(measure("deformation", {}), NoNumber) << "at the start there was nothing";
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// Metrics of what share of the volume is where, was hot or is soft, on frames that are written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/core/errors.h"
#include "tests/unit/claims/written_run.h"

namespace bake {
namespace {

class RegionMetrics : public WrittenRun {
 protected:
  RegionMetrics()
      : WrittenRun(R"({"summary": {"state": "done"}, "scene": {"material": [
      {"name": "batter", "initial_temperature_C": 5, "temperatures_C": [4, 20, 45, 80], "yield_stress_Pa": [2, 2, 2, 2000]},
      {"name": "chocolate", "initial_temperature_C": 12, "temperatures_C": [4, 20, 30, 70], "yield_stress_Pa": [3000, 1000, 100, 4000]},
      {"name": "water"}]}})",
                   "time_s\n0\n1\n2\n4\n") {}
};

MetricPlace unit_box() { return {.low_m = Vector3{0, 0, 0}, .high_m = Vector3{1, 1, 1}}; }

MetricPlace hot(double temperature_C) { return {.temperature_C = temperature_C}; }

TEST(ABoxOfAMetric, HoldsWhatIsBetweenItsCornersOnEachAxisByItself) {
  const MetricPlace box{.low_m = Vector3{-1, -2, -3}, .high_m = Vector3{1, 2, 3}};
  EXPECT_TRUE(is_in_box({0.9, 1.9, 2.9}, box));
  EXPECT_TRUE(is_in_box({-0.9, -1.9, -2.9}, box));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1, 1}) {
      Vector3 beyond{};
      beyond[axis] = side * (static_cast<double>(axis) + 1.1);
      EXPECT_FALSE(is_in_box(beyond, box)) << axis;
    }
}

TEST_F(RegionMetrics, FindTheShareThatIsInABoxNow) {
  frame(0, {{1, {0.5, 0.5, 0.5}}, {2, {2, 0.5, 0.5}}, {3, {0.5, 0.5, 3}}});
  frame(3, {{3, {0.5, 0.5, 0.9}, 20, 20, 3}, {1, {0.5, 0.5, -0.1}, 20, 20, 2}, {2, {0.9, 0.1, 0.5}, 20, 20, 5}});
  EXPECT_DOUBLE_EQ(measure("share_in_box", unit_box()), 0.8);
  MetricPlace start = unit_box();
  start.time_s = 0;
  EXPECT_DOUBLE_EQ(measure("share_in_box", start), 1.0 / 3);
}

TEST_F(RegionMetrics, FindTheShareThatWasHotOfWhatStartedInABox) {
  frame(0, {{1, {0.5, 0.5, 0.5}}, {2, {0.1, 0.1, 0.1}}, {3, {5, 0, 0}}});
  // 2 has left the box, 3 has come into it, and 4 was poured
  frame(3, {{4, {0.5, 0.5, 0.5}, 20, 90, 8}, {3, {0.5, 0, 0}, 20, 90, 4}, {2, {9, 9, 9}, 20, 90, 3}, {1, {0.5, 0.5, 0.5}, 85, 70, 1}});
  EXPECT_DOUBLE_EQ(measure("heated_share", hot(80)), 15.0 / 16) << "of all: peaks count, not what is now";
  MetricPlace place = unit_box();
  place.temperature_C = 80;
  EXPECT_DOUBLE_EQ(measure("heated_share", place), 0.75);
  place.low_m = Vector3{20, 20, 20};
  place.high_m = Vector3{21, 21, 21};
  EXPECT_TRUE(std::isnan(measure("heated_share", place))) << "nothing started there";
  place.high_m.reset();
  EXPECT_THROW(measure("heated_share", place), InputError);
}

TEST_F(RegionMetrics, FindWhatHasComeOutOfACrust) {
  // twelve pillars around the axis, one in four windows' height each: inside, crust
  const auto pillars = [](double inside, float peak) {
    std::vector<Dot> dots;
    for (int i = 0; i < 12; ++i)
      for (const double radius : {i == 0 ? inside : 4.0, 5.0})
        dots.push_back({static_cast<std::int64_t>(dots.size()),
                        {radius * std::cos(0.07 + 0.5 * i), radius * std::sin(0.07 + 0.5 * i), 1},
                        20,
                        radius == 5 ? peak : 20.f});
    return dots;
  };
  frame(0, pillars(4, 95));
  frame(1, pillars(6, 95));
  frame(2, pillars(6, 60));
  MetricPlace place = hot(90);
  place.time_s = 0;
  EXPECT_DOUBLE_EQ(measure("oozed_share", place), 0);
  place.time_s = 1;
  EXPECT_DOUBLE_EQ(measure("oozed_share", place), 1.0 / 24) << "one has come through";
  place.radius_m = 6.5;
  EXPECT_DOUBLE_EQ(measure("oozed_share", place), 0) << "but not as far as that";
  place.radius_m.reset();
  place.time_s = 2;
  EXPECT_DOUBLE_EQ(measure("oozed_share", place), 1) << "there is no crust";
}

TEST_F(RegionMetrics, FindTheShareThatWasHotOfWhatWasInABoxLater) {
  frame(0, {});
  frame(1, {{1, {0.5, 0.5, 0.5}, 20, 20, 3}, {2, {5, 0, 0}, 20, 20, 1}});
  frame(3, {{1, {7, 0, 0}, 20, 90, 3}, {2, {0.5, 0.5, 0.5}, 20, 20, 1}});
  MetricPlace place = unit_box();
  place.temperature_C = 80;
  EXPECT_TRUE(std::isnan(measure("heated_share", place))) << "nothing was poured yet";
  place.reference_time_s = 1;
  EXPECT_DOUBLE_EQ(measure("heated_share", place), 1);
}

TEST_F(RegionMetrics, FindHowMuchCrustHasBrokenAndWhatItNoLongerHolds) {
  frame(3, {{1, {4, 0.1, 0.1}, 20, 20, 2},
            {2, {5, 0.1, 0.1}, 20, 95, 1, 1, 0, 1},
            {3, {-4, 0.1, 0.1}, 20, 20, 2},
            {4, {-5, 0.1, 0.1}, 20, 95, 3, 1, 0, 0.5f}});
  EXPECT_DOUBLE_EQ(measure("broken_share", hot(90)), 0.25) << "of the crust";
  EXPECT_DOUBLE_EQ(measure("oozed_share", hot(90)), 0.25) << "of all: what is behind crust that holds has not come out";
  EXPECT_TRUE(std::isnan(measure("broken_share", hot(99)))) << "there is no crust";
}

TEST_F(RegionMetrics, FindHowLongSettingTakesBesideTheTimeUntilItBegins) {
  const auto hot_ones = [](int count) {
    std::vector<Dot> grains;
    for (int i = 0; i < 10; ++i) grains.push_back({i, {0, 0, 0.1 * i}, 20, i < count ? 70.f : 20.f});
    return grains;
  };
  for (int number = 0; number < 4; ++number) frame(number, hot_ones(std::array{0, 0, 2, 10}[static_cast<std::size_t>(number)]));
  // a tenth at 1.5 s, halfway from none at 1 s to two tenths at 2 s; nine tenths at 2 + 2 * 7 / 8 s
  EXPECT_NEAR(measure("heating_window", hot(60)), (3.75 - 1.5) / 1.5, 1e-12);
  EXPECT_FALSE(std::isfinite(measure("heating_window", hot(80)))) << "nothing ever was that hot";
  frame(3, hot_ones(8));
  EXPECT_EQ(measure("heating_window", hot(60)), k_infinity) << "nine tenths never were";
}

TEST_F(RegionMetrics, FindWhatHasMeltedOfOneMaterial) {
  // chocolate starts at 12 C with 2000 Pa, halfway from 3000 to 1000: a tenth of that is 200 Pa, at 28.9 C and from there to 31 C
  frame(0, {{1, {0, 0, 0}}});
  frame(3, {{1, {0, 0, 0}, 30, 30, 1, 1, 1},     // 100 Pa
            {2, {0, 0, 0}, 28, 28, 2, 1, 1},     // 280 Pa
            {3, {0, 0, 0}, 30, 75, 4, 1, 1},     // 4000 Pa for ever: it has been above theta_4
            {4, {0, 0, 0}, 10, 69, 8, 1, 1},     // 2250 Pa: hot below theta_4 it was, and it is cold again
            {5, {0, 0, 0}, 30, 30, 64, 1, 0}});  // batter
  MetricPlace place{.material = "chocolate", .softened_to = 0.1};
  EXPECT_DOUBLE_EQ(measure("softened_share", place), 1.0 / 15);
  place.softened_to = 0.15;
  EXPECT_DOUBLE_EQ(measure("softened_share", place), 3.0 / 15);
  place.material = "batter";
  EXPECT_DOUBLE_EQ(measure("softened_share", place), 0) << "2 Pa from first to last";
  place.material = "water";
  EXPECT_THROW(measure("softened_share", place), InputError);
  place.material = "cocoa";
  const std::string message = message_of<InputError>([&] { measure("softened_share", place); });
  EXPECT_NE(message.find("found no material 'cocoa', allowed: batter, chocolate, water"), std::string::npos) << message;
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include "analysis/browning/browning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.h"
#include "tests/unit/analysis/runs.h"

namespace bake {
namespace {

TEST(Browning, RateRisesWithTemperatureAndDryness) {
  const BrowningLaw law;
  for (double t = 20; t < 250; t += 10) EXPECT_GT(browning_rate(law, t + 10, 0.4), browning_rate(law, t, 0.4));
  for (double w = 0; w < 0.5; w += 0.05) EXPECT_GT(browning_rate(law, 150, w + 0.05), browning_rate(law, 150, w));
  EXPECT_EQ(browning_rate(law, 200, 0), 0);
  EXPECT_EQ(browning_rate(law, 200, -0.1), 0);  // water that came from neighbours
  EXPECT_EQ(browning_rate(law, 200, 0.9), browning_rate(law, 200, 0.5));
}

TEST(Browning, RateIsWhatTheKeysSay) {
  const BrowningLaw law{150, 600, 40, 0.5};
  EXPECT_DOUBLE_EQ(browning_rate(law, 150, 0.5), 1.0 / 600);
  EXPECT_DOUBLE_EQ(browning_rate(law, 190, 0.5), 10.0 / 600);
  EXPECT_DOUBLE_EQ(browning_rate(law, 150, 0.25), 0.5 / 600);
  const BrowningLaw heat_alone{150, 600, 40, 0};
  EXPECT_DOUBLE_EQ(browning_rate(heat_alone, 190, 0), 10.0 / 600);
  EXPECT_DOUBLE_EQ(browning_rate(heat_alone, 190, -0.1), 10.0 / 600);
}

TEST(Browning, DegreeRisesFromRawToOne) {
  EXPECT_EQ(browning_degree(0), 0);
  EXPECT_DOUBLE_EQ(browning_degree(1), 1 - std::exp(-1));
  for (double b = 0; b < 20; b += 0.5) EXPECT_GT(browning_degree(b + 0.5), browning_degree(b));
}

/// Hot and half dry on the right, warm on the left, and the left stays wet: over t seconds B = t times the rate.
class ARun : public testing::Test {
 protected:
  ARun() {
    write_run(folder / "run", ball, 9, [](const float* p, double t) {
      if (p[0] > 0) return State{150, t < 0.5 ? 1.0f : 0.5f};
      return State{110, 1.0f};
    });
  }
  TemporaryFolder folder;
  const Ball ball{0.1f, 0.05f};
  const BrowningLaw law{150, 4, 40, 0.5};
};

TEST_F(ARun, BrownsByTheIntegralOfTheRate) {
  BrowningHistory history(folder / "run", law);
  history.advance_to(8);
  const auto degrees = history.degrees(ball.ids);
  for (std::size_t i = 0; i < ball.ids.size(); ++i) {
    const double expected = ball.positions[3 * i] > 0 ? 7.5 / 4 : 0;  // dry from 1 s on; the trapezium counts half of the first second
    EXPECT_NEAR(degrees[i], browning_degree(expected), 1e-6);
  }
}

TEST_F(ARun, BrownsOnWithTimeInOneGoOrInSteps) {
  BrowningHistory steps(folder / "run", law);
  double last = -1;
  for (int frame = 1; frame <= 8; ++frame) {
    steps.advance_to(frame);
    const auto degrees = steps.degrees(ball.ids);
    const double most = *std::max_element(degrees.begin(), degrees.end());
    EXPECT_GT(most, last);
    last = most;
  }
  BrowningHistory once(folder / "run", law);
  once.advance_to(8);
  EXPECT_EQ(once.degrees(ball.ids), steps.degrees(ball.ids));
}

TEST_F(ARun, RemembersWhereParticlesWere) {
  BrowningHistory history(folder / "run", law);
  history.advance_to(3);
  const std::vector<std::int64_t> last = {ball.ids.back()};
  EXPECT_EQ(history.first_positions(last)[2], ball.positions[3 * static_cast<std::size_t>(last[0]) + 2]);
  const std::vector<std::int64_t> unknown = {-1, 1000000};
  EXPECT_EQ(history.degrees(unknown), (std::vector<double>{0, 0}));
}

TEST_F(ARun, IsRefusedInOneLineWhereItHasNotCome) {
  BrowningHistory history(folder / "run", law);
  EXPECT_TRUE(has(message_of<InputError>([&] { history.advance_to(9); }), "the run has come to frame 8 only"));
  EXPECT_TRUE(has(message_of<InputError>([&] { BrowningHistory(folder / "nowhere", law); }), "no run is here"));
  EXPECT_TRUE(has(message_of<InputError>([&] { frame_at(folder / "run", 3.5); }), "no frame at 3.5 s"));
  EXPECT_EQ(frame_at(folder / "run", 3), 3);
  put(folder / "run/frames.hdf.series", "{");
  EXPECT_TRUE(has(message_of<InputError>([&] { frame_at(folder / "run", 3); }), "not a list of frames"));
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/run/frame_times.h"

#include <gtest/gtest.h>

#include "solver/core/errors.h"
#include "solver/scene/scene.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

Scene ending_at(double end_s, double frame_rate_per_s) {
  Scene scene;
  scene.file = "bread.toml";
  scene.run.end_s = end_s;
  scene.run.frame_rate_per_s = frame_rate_per_s;
  return scene;
}

TEST(FrameTimes, AreWholeNumbersOverTheRateUpToAnEndThatIsOne) {
  const FrameTimes times(ending_at(0.3, 30));  // 0.3 * 30 is not 9 to the last bit
  EXPECT_EQ(times.last(), 9);
  for (int f = 0; f <= 11; ++f) EXPECT_EQ(times(f), f / 30.0) << "also behind the end, where a longer run has them";
}

TEST(FrameTimes, EndAtAnEndThatIsBetweenTwoFrames) {
  const FrameTimes times(ending_at(1.2, 24));
  EXPECT_EQ(times.last(), 29);
  EXPECT_EQ(times(28), 28 / 24.0);
  EXPECT_EQ(times.end_s(), 1.2);
  EXPECT_GT(times(30), 1.2);
  EXPECT_NE(times(30), 29 / 24.0) << "no longer run has it";
  EXPECT_NE(times(30), 30 / 24.0) << "no longer run has it";
}

TEST(FrameTimes, OfAnEndBeforeTheFirstFrameHaveOneFrame) {
  for (const double end : {0.001, 1e-12, 1e-300}) {
    const FrameTimes times(ending_at(end, 24));
    EXPECT_EQ(times.last(), 1);
    EXPECT_EQ(times.end_s(), end);
  }
}

TEST(FrameTimes, AreThoseOfTheSceneIfARunStopsBeforeItsEnd) {
  const Scene scene = ending_at(1.2, 24);
  const FrameTimes whole(scene), stopped(scene, 28);
  EXPECT_EQ(stopped.last(), 28);
  for (int f = 0; f <= 31; ++f) EXPECT_EQ(stopped(f), whole(f));
}

TEST(FrameTimes, GoOnAtTheRateIfARunGoesBeyondTheScenesEnd) {
  const FrameTimes times(ending_at(1.2, 24), 40);
  EXPECT_EQ(times.last(), 40);
  for (int f = 0; f <= 42; ++f) EXPECT_EQ(times(f), f / 24.0);
}

TEST(FrameTimes, ThatCannotBeCountedAreRefused) {
  EXPECT_EQ(FrameTimes(ending_at(1e9, 1)).last(), 1'000'000'000);
  for (const Scene& scene : {ending_at(1e9, 24), ending_at(1e300, 1e300), ending_at(1, 1e10)}) {
    const std::string message = message_of<InputError>([&] { FrameTimes{scene}; });
    EXPECT_NE(message.find("bread.toml: run.end_s: found"), std::string::npos) << message;
    EXPECT_EQ(FrameTimes(scene, 3).last(), 3) << "three can";
  }
}

}  // namespace
}  // namespace bake

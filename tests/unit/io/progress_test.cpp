// SPDX-License-Identifier: MIT
#include "solver/io/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace bake {
namespace {

/// A run at steady speed, watched through a clock that the test sets.
class Watched {
 public:
  Watched(ProgressStyle style, int frames, int width = 100) : style_(style), frames_(frames), width_(width) {}

  /// Runs `steps` steps of `wall_s` each, with 1 s of simulated time and 100 steps to a frame.
  void run(Progress& progress, int steps, double wall_s) {
    for (int i = 0; i < steps; ++i) {
      now_ += wall_s;
      ++step_;
      progress.update({step_ / 100, frames_, step_ / 100.0, double(frames_), 0.01, std::uint64_t(step_) * 2000000});
    }
  }
  ProgressOutput output() {
    return {out_, style_, [this] { return now_; }, [this] { return width_; }};
  }
  std::string text() const { return out_.str(); }
  auto count(char c) const {
    const auto all = text();
    return std::count(all.begin(), all.end(), c);
  }

 private:
  std::ostringstream out_;
  ProgressStyle style_;
  int frames_, width_;
  int step_ = 0;
  double now_ = 1000;
};

TEST(Progress, SaysNothingWhenQuiet) {
  Watched run(ProgressStyle::quiet, 2);
  {
    Progress progress(run.output());
    run.run(progress, 200, 1);
  }
  EXPECT_EQ(run.text(), "");
}

TEST(Progress, RedrawsItsBarAtMostTenTimesASecond) {
  Watched run(ProgressStyle::bar, 100);
  Progress progress(run.output());
  run.run(progress, 5000, 0.001);
  EXPECT_LE(run.count('\r'), 51);
  EXPECT_GE(run.count('\r'), 45);
  EXPECT_EQ(run.count('\n'), 0);
}

TEST(Progress, DrawsTheLastFrameAlways) {
  Watched run(ProgressStyle::bar, 1);
  Progress progress(run.output());
  run.run(progress, 100, 0.0001);
  const auto last = run.text().substr(run.text().rfind('\r'));
  EXPECT_NE(last.find("frame 1/1"), std::string::npos) << last;
}

TEST(Progress, LeavesTheTerminalOnAFreshLineAfterAnException) {
  Watched run(ProgressStyle::bar, 10);
  try {
    Progress progress(run.output());
    run.run(progress, 10, 1);
    throw std::runtime_error("the dough exploded");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(run.text().back(), '\n');
  EXPECT_EQ(run.count('\n'), 1);
}

TEST(Progress, PrintsALineForEverySlowFrame) {
  Watched run(ProgressStyle::lines, 30);
  Progress progress(run.output());
  run.run(progress, 3000, 0.11);  // 11 s for each frame
  EXPECT_EQ(run.count('\n'), 30);
  EXPECT_EQ(run.count('\r'), 0);
}

TEST(Progress, PrintsFastFramesOnceInTenSecondsOrOnceATenth) {
  Watched slow_run(ProgressStyle::lines, 1000);
  Progress slow(slow_run.output());
  slow_run.run(slow, 50000, 0.01);  // 1 s for each frame, 500 s in all
  EXPECT_NEAR(slow_run.count('\n'), 50, 6);
  Watched fast_run(ProgressStyle::lines, 1000);
  Progress fast(fast_run.output());
  fast_run.run(fast, 100000, 0.0001);  // all done in 10 s
  EXPECT_NEAR(fast_run.count('\n'), 11, 1);
  EXPECT_NE(fast_run.text().find("frame 1000/1000"), std::string::npos);
}

TEST(Progress, EstimatesTheTimeLeftFromTheRecentSpeed) {
  Watched run(ProgressStyle::lines, 100);
  Progress progress(run.output());
  run.run(progress, 5000, 0.001);  // a quick first half
  run.run(progress, 1000, 0.5);    // then 50 s for each frame, 40 frames to go
  const auto last = run.text().substr(run.text().rfind("frame"));
  EXPECT_NE(last.find("left 33:2"), std::string::npos) << last;
  EXPECT_NE(last.find("4.0 M/s"), std::string::npos) << last;
}

TEST(Progress, LeavesNoTimeAtTheEnd) {
  Watched run(ProgressStyle::lines, 1);
  Progress progress(run.output());
  run.run(progress, 100, 1);
  EXPECT_NE(run.text().find("left 0:00"), std::string::npos) << run.text();
}

/// A meter of a mesh in two phases, three seconds apart.
std::string two_phases(ProgressStyle style) {
  std::ostringstream out;
  double now = 0;
  {
    Meter meter("tets", {out, style, [&] { return now; }, [] { return 80; }});
    meter.phase("placing vertices");
    now = 3;
    meter.phase("connecting vertices");
  }
  return out.str();
}

TEST(Meter, RedrawsPhasesOnATerminalAndTellsALogOfThoseThatBeginLate) {
  EXPECT_EQ(two_phases(ProgressStyle::bar), "\rtets  placing vertices\x1b[K\rtets  connecting vertices\x1b[K\r\x1b[K");
  EXPECT_EQ(two_phases(ProgressStyle::lines), "tets: connecting vertices\n");
  EXPECT_EQ(two_phases(ProgressStyle::quiet), "");
}

TEST(Meter, TellsALogItsShareAndTheTimeLeftEveryTenSeconds) {
  std::ostringstream out;
  double now = 100;
  Meter meter("loaf.png", {out, ProgressStyle::lines, [&] { return now; }, [] { return 80; }});
  for (int i = 1; i <= 50; ++i) now += 0.5, meter(i / 100.0);
  EXPECT_EQ(out.str(), "loaf.png   20 %  left 0:40\nloaf.png   40 %  left 0:30\n");
}

TEST(Meter, ShowsItsShareFiveTimesASecondOnATerminal) {
  for (const auto style : {ProgressStyle::bar, ProgressStyle::lines}) {
    std::ostringstream out;
    double now = 100;
    Meter meter("loaf.png", {out, style, [&] { return now; }, [] { return 80; }});
    for (int i = 1; i <= 50; ++i) now += 0.125, meter(i / 100.0);
    const std::string text = out.str();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), style == ProgressStyle::bar ? 25 : 0);
    if (style == ProgressStyle::bar) {
      EXPECT_EQ(text.substr(text.rfind('\r')), "\rloaf.png   49 %  left 0:06\x1b[K");
    }
  }
}

TEST(BarLine, NeverGrowsBeyondItsWidth) {
  const Standing standing{12, 48, 0.5, 2, 1.25e-4, 1};
  for (int width = 0; width < 200; ++width) EXPECT_LE(bar_line(standing, {35.1e6, 192}, width).size(), std::size_t(width));
}

TEST(BarLine, ShowsEverythingWhereThereIsRoom) {
  EXPECT_EQ(bar_line({12, 48, 0.5, 2, 2e-4, 1}, {35.1e6, 192}, 78),
            "[#####..............]  frame 12/48  left 3:12  35.1 M/s  0.500 s  dt 2.0e-04 s");
}

TEST(ClockText, IsReadLikeAClock) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(7.4), "0:07");
  EXPECT_EQ(clock_text(754), "12:34");
  EXPECT_EQ(clock_text(11045), "3:04:05");
  EXPECT_EQ(clock_text(-1), "-:--");
  EXPECT_EQ(clock_text(0.0 / 0.0), "-:--");
}

}  // namespace
}  // namespace bake

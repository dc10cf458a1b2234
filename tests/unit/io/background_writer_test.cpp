// SPDX-License-Identifier: MIT
#include "solver/io/background_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <future>
#include <stdexcept>
#include <vector>

#include "solver/io/frames.h"
#include "solver/io/ledger_file.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

using namespace std::chrono_literals;

TEST(BackgroundWriter, DoesItsJobsInTheirOrder) {
  std::vector<int> done;
  BackgroundWriter writer;
  for (int i = 0; i < 20; ++i) writer.put([&done, i] { done.push_back(i); });
  writer.finish();
  ASSERT_EQ(done.size(), 20u);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundWriter, LetsItsOwnerWaitWhileTwoJobsAreLeft) {
  BackgroundWriter writer;
  std::promise<void> gate;
  writer.put([open = gate.get_future().share()] { open.wait(); });
  writer.put([] {});
  auto third = std::async(std::launch::async, [&] { writer.put([] {}); });
  EXPECT_EQ(third.wait_for(50ms), std::future_status::timeout);
  gate.set_value();
  third.get();
}

TEST(BackgroundWriter, ThrowsWhatAJobThrewAndDropsTheJobsBehindIt) {
  BackgroundWriter writer;
  std::promise<void> gate;
  bool dropped = true;
  writer.put([open = gate.get_future().share()] {
    open.wait();
    throw std::runtime_error("the disk is full");
  });
  writer.put([&] { dropped = false; });
  EXPECT_NO_THROW(writer.check());
  gate.set_value();
  EXPECT_THROW(writer.finish(), std::runtime_error);
  EXPECT_THROW(writer.check(), std::runtime_error);
  EXPECT_THROW(writer.put([&] { dropped = false; }), std::runtime_error);
  EXPECT_TRUE(dropped);
}

TEST(BackgroundWriter, WritesFramesAndLedgerWhileItsOwnerMakesTheNextOnes) {
  const TemporaryFolder folder;
  LedgerFile ledger = LedgerFile::create(folder / "ledger.csv", {"time_s"});
  BackgroundWriter writer;
  FrameWriter frames;
  std::vector<float> x(3 * 40000);
  for (int frame = 0; frame < 5; ++frame) {
    for (float& x_d : x) x_d += 1;
    writer.put([&, frame, written = frames.write(folder / frame_name(frame), frame, {x, {}})] {
      written->put_in_place();
      ledger.append(std::array{static_cast<double>(frame)});
    });
  }
  writer.finish();
  for (int frame = 0; frame < 5; ++frame) {
    const std::vector<double> expected(x.size(), frame + 1);
    EXPECT_EQ(FrameReader(folder / frame_name(frame)).positions(), expected);
    EXPECT_EQ(read_ledger(folder / "ledger.csv").rows.at(static_cast<std::size_t>(frame)).at(0), frame);
  }
}

TEST(BackgroundWriter, DoesWhatIsLeftBeforeItEnds) {
  int done = 0;
  {
    BackgroundWriter writer;
    writer.put([&] {
      std::this_thread::sleep_for(20ms);
      ++done;
    });
    writer.put([&] { ++done; });
  }
  EXPECT_EQ(done, 2);
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include "experiments/make/side_by_side.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace bake {
namespace {

TEST(SideBySide, DoesEachWorkOnce) {
  for (const int at_once : {1, 2, 5}) {
    std::vector<std::atomic<int>> times(12);
    side_by_side(times.size(), at_once, [&](std::size_t i) { ++times[i]; });
    for (const auto& count : times) EXPECT_EQ(count, 1) << at_once;
  }
  side_by_side(0, 2, [](std::size_t) { FAIL(); });
}

TEST(SideBySide, TwoOfTwoAreUnderWayTogether) {
  std::atomic<int> begun = 0;
  bool together[2] = {};
  side_by_side(2, 2, [&](std::size_t i) {
    ++begun;
    for (int waited = 0; begun < 2 && waited < 1000; ++waited) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    together[i] = begun == 2;
  });
  EXPECT_TRUE(together[0] && together[1]);
}

TEST(SideBySide, OneAtATimeGoesInOrderAndEndsWithTheFirstFailure) {
  std::vector<std::size_t> done;
  const auto work = [&](std::size_t i) {
    done.push_back(i);
    if (i >= 2) throw std::runtime_error(std::to_string(i));
  };
  try {
    side_by_side(5, 1, work);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "2");
  }
  EXPECT_EQ(done, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(SideBySide, OfTwoFailuresTheFirstByNumberIsTold) {
  std::atomic<int> begun = 0;
  const auto work = [&](std::size_t i) {
    ++begun;
    for (int waited = 0; begun < 2 && waited < 1000; ++waited) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    throw std::runtime_error(std::to_string(i));
  };
  try {
    side_by_side(2, 2, work);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "0");
  }
}

}  // namespace
}  // namespace bake

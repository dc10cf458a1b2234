// SPDX-License-Identifier: MIT
#include "solver/core/parallel.h"

#include <gtest/gtest.h>

#include "tests/support/threads_restored.h"

namespace bake {
namespace {

TEST(ParallelLoop, DoesEverythingOnceForAnyNumberOfThreadsAndChunk) {
  const ThreadsRestored restored;
  for (const int threads : {1, 2, 3, 5}) {
    omp_set_num_threads(threads);
    for (const std::size_t count : {0, 1, 2, 7, 100})
      for (const std::size_t chunk : {1, 3, 16}) {
        std::vector<std::atomic<int>> done(count);
        for_each_parallel(count, chunk, [&](std::size_t i) { ++done[i]; });
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count << ", " << threads << " threads, " << chunk;
      }
  }
}

TEST(ParallelLoop, OfOneThreadGoesFromFrontToBack) {
  const ThreadsRestored restored;
  omp_set_num_threads(1);
  std::vector<std::size_t> order;
  for_each_parallel(64, 4, [&](std::size_t i) { order.push_back(i); });
  ASSERT_EQ(order.size(), 64u);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

}  // namespace
}  // namespace bake

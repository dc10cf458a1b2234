// SPDX-License-Identifier: MIT
#include "solver/core/parallel.h"

#include <gtest/gtest.h>

namespace bake {
namespace {

TEST(ParallelLoop, DoesEverythingOnceForAnyNumberOfThreadsAndChunk) {
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 3, 5}) {
    omp_set_num_threads(threads);
    for (const std::size_t count : {0, 1, 2, 7, 100})
      for (const std::size_t chunk : {1, 3, 16}) {
        std::vector<std::atomic<int>> done(count);
        for_each_parallel(count, chunk, [&](std::size_t i) { ++done[i]; });
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count << ", " << threads << " threads, " << chunk;
      }
  }
  omp_set_num_threads(before);
}

TEST(ParallelLoop, OfOneThreadGoesFromFrontToBack) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  std::vector<std::size_t> order;
  for_each_parallel(64, 4, [&](std::size_t i) { order.push_back(i); });
  omp_set_num_threads(before);
  ASSERT_EQ(order.size(), 64u);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

}  // namespace
}  // namespace bake

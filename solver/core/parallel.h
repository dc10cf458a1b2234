// SPDX-License-Identifier: MIT
// Parallel loops.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace bake {

/// Calls work(i) once for every i in 0 .. count - 1. Each thread first takes its own part of the range, the same in every loop, so that
/// its caches still hold that part. A thread that is done takes work from the others, `chunk` items at a time. Which thread does which item
/// is left to chance, so `work` must not depend on it.
template <class Work>
void for_each_parallel(std::size_t count, std::size_t chunk, Work work) {
  struct alignas(64) Taken {
    std::atomic<std::size_t> number{0};
  };
  std::vector<Taken> taken(static_cast<std::size_t>(omp_get_max_threads()));
#pragma omp parallel
  {
    const auto threads = static_cast<std::size_t>(omp_get_num_threads()), me = static_cast<std::size_t>(omp_get_thread_num());
    for (std::size_t k = 0; k < threads; ++k) {
      const std::size_t part = (me + k) % threads, first = count * part / threads, size = count * (part + 1) / threads - first;
      for (std::size_t i; (i = taken[part].number.fetch_add(chunk, std::memory_order_relaxed)) < size;)
        for (std::size_t j = i; j < std::min(i + chunk, size); ++j) work(first + j);
    }
  }
}

}  // namespace bake

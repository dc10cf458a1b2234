// SPDX-License-Identifier: MIT
// Tests that set the number of threads.
#pragma once

#include <omp.h>

namespace bake {

/// At its end parallel loops have the number of threads again that they had at its start.
class ThreadsRestored {
 public:
  ThreadsRestored() = default;
  ~ThreadsRestored() { omp_set_num_threads(threads_); }
  ThreadsRestored(const ThreadsRestored&) = delete;
  ThreadsRestored& operator=(const ThreadsRestored&) = delete;

 private:
  const int threads_ = omp_get_max_threads();
};

}  // namespace bake

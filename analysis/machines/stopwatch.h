// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace bake::bench {

/// Time since it was made: of the clock, and of all processors that worked for this program.
class Stopwatch {
 public:
  double wall_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  double cpu_s() const { return process_s() - cpu_start_; }

 private:
  static double process_s() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double cpu_start_ = process_s();
};

}  // namespace bake::bench

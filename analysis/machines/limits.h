// SPDX-License-Identifier: MIT
// Measures the limits of the machine, with which the times of benchmarks and studies are compared.
#pragma once

#include <vector>

namespace bake::bench {

/// The rates that a number of threads reach.
struct Speed {
  double triad_GB_per_s = 0;  ///< a[i] = b[i] + s c[i]; 24 bytes an element (what the caches read before they write is not counted)
  double single_GFLOPs = 0;   ///< multiply-adds in registers, two flops each
  double double_GFLOPs = 0;
};

/// Measures for less than a second, with arrays of 400 MB; every number is the best of several trials.
Speed measure_speed(int threads);

/// Rates with one thread and with all.
struct Rate {
  double one = 0, all = 0;
};

struct Limits {
  int threads = 1;      ///< all
  Rate triad_GB_per_s;  ///< see Speed
  Rate single_GFLOPs;
  Rate double_GFLOPs;

  /// 1, 2, 4, ... and all.
  std::vector<int> thread_counts() const {
    std::vector<int> counts;
    for (int n = 1; n < threads; n *= 2) counts.push_back(n);
    counts.push_back(threads);
    return counts;
  }
};

/// The speed of one thread and of all.
Limits measure_limits();

}  // namespace bake::bench

// SPDX-License-Identifier: MIT
// What the machine itself can do: the limits beside which the benchmarks' figures are read.
#pragma once

#include <vector>

namespace bake::bench {

/// Rates with one thread and with all.
struct Rate {
  double one = 0, all = 0;
};

struct Limits {
  int threads = 1;      ///< all
  Rate triad_GB_per_s;  ///< a[i] = b[i] + s c[i]; 24 bytes an element (what the caches read before they write is not counted)
  Rate single_GFLOPs;   ///< multiply-adds in registers, two flops each
  Rate double_GFLOPs;

  /// 1, 2, 4, ... and all.
  std::vector<int> thread_counts() const {
    std::vector<int> counts;
    for (int n = 1; n < threads; n *= 2) counts.push_back(n);
    counts.push_back(threads);
    return counts;
  }
};

/// Measures for about two seconds; every number is the best of several trials.
Limits measure_limits();

}  // namespace bake::bench

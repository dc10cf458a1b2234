// SPDX-License-Identifier: MIT
// What the machine itself can do: the limits beside which the benchmarks' figures are read.
#pragma once

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
};

/// Measures for about two seconds; every number is the best of several trials.
Limits measure_limits();

}  // namespace bake::bench

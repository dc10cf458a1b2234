// SPDX-License-Identifier: MIT
#include "analysis/machines/limits.h"

#include <omp.h>

#include <algorithm>
#include <vector>

#include "solver/core/lanes.h"
#include "solver/io/progress.h"

namespace bake::bench {

namespace {

constexpr int k_trials = 5;

/// Makes the compiler compute the value, whose use it cannot know.
template <class Value>
void keep(Value& value) {
  asm volatile("" : "+m"(value) : : "memory");
}

/// The seconds of the fastest trial.
template <class Work>
double fastest(Work work) {
  double best = 1e30;
  for (int trial = 0; trial < k_trials; ++trial) {
    const double began = steady_seconds();
    work();
    best = std::min(best, steady_seconds() - began);
  }
  return best;
}

/// Each array is far larger than any cache.
double triad_GB_per_s(int threads) {
  constexpr std::int64_t n = std::int64_t{1} << 24;
  std::vector<double> a(n, 1.0), b(n, 2.0), c(n, 3.0);
  double *const to = a.data(), *const x = b.data(), *const y = c.data();
  const double seconds = fastest([&] {
#pragma omp parallel for simd num_threads(threads) schedule(static)
    for (std::int64_t i = 0; i < n; ++i) to[i] = x[i] + 0.5 * y[i];
    keep(to[n / 2]);
  });
  return 24e-9 * static_cast<double>(n) / seconds;
}

constexpr int k_sums = 12;  ///< independent, enough to fill two units of latency four, few enough for 16 registers
constexpr std::int64_t k_rounds = 4'000'000;

template <class Real>
void multiply_add() {
  Lanes<Real> sum[k_sums], factor = lanes<Real>(Real(0.999)), term = lanes<Real>(Real(0.001));
  keep(factor);
  keep(term);
  for (int i = 0; i < k_sums; ++i) sum[i] = lanes<Real>(static_cast<Real>(i));
  for (std::int64_t round = 0; round < k_rounds; ++round)
#pragma GCC unroll 12
    for (int i = 0; i < k_sums; ++i) sum[i] = sum[i] * factor + term;
  for (int i = 0; i < k_sums; ++i) keep(sum[i]);
}

template <class Real>
double GFLOPs(int threads) {
  const double seconds = fastest([&] {
#pragma omp parallel num_threads(threads)
    multiply_add<Real>();
  });
  return 2e-9 * k_width<Real> * k_sums * static_cast<double>(k_rounds) * threads / seconds;
}

}  // namespace

Speed measure_speed(int threads) { return {triad_GB_per_s(threads), GFLOPs<float>(threads), GFLOPs<double>(threads)}; }

Limits measure_limits() {
  const int all = omp_get_max_threads();
  const Speed one = measure_speed(1), shared = measure_speed(all);
  return {all,
          {one.triad_GB_per_s, shared.triad_GB_per_s},
          {one.single_GFLOPs, shared.single_GFLOPs},
          {one.double_GFLOPs, shared.double_GFLOPs}};
}

}  // namespace bake::bench

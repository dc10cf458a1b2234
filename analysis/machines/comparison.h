// SPDX-License-Identifier: MIT
// Compares machines, compilers or versions of the program: `bake compare a.json b.json [...]`.
#pragma once

#include <string>
#include <vector>

#include "analysis/charts/chart.h"
#include "analysis/machines/bench_file.h"
#include "analysis/machines/statistics.h"

namespace bake::studies {

/// One benchmark in the first file and in another one.
struct BenchRatio {
  enum class Verdict { faster, slower, noise, too_few };

  std::string name;
  std::size_t repetitions_here, repetitions_base;
  double seconds_base, seconds_here;  ///< medians, per iteration
  Estimate ratio;                     ///< how many times as fast as in the first file
  double p;                           ///< of Mann and Whitney
  double triad_ratio, fma_ratio;      ///< of the machines' limits, for the benchmark's threads and precision
  Verdict verdict;

  double per_triad() const { return ratio.value / triad_ratio; }  ///< above 1: the better use of the memory's bandwidth
  double per_fma() const { return ratio.value / fma_ratio; }      ///< above 1: the better use of the multiply-adds
};

/// Compares the benchmarks that both files have, in the order of the first. Throws InputError if there are none.
std::vector<BenchRatio> compare(const BenchFile& base, const BenchFile& here);

/// Geometric mean of the ratios.
double mean_ratio(const std::vector<BenchRatio>& ratios);

/// The comparison as text: warnings about doubtful numbers, both machines, a line per benchmark, and a summary.
std::string in_words(const BenchFile& base, const BenchFile& here, const std::vector<BenchRatio>& ratios);

/// A chart of the ratios with their intervals and of the ratios of the machines' limits, with a panel for each file except the first.
charts::Chart chart_of(const BenchFile& base, const std::vector<BenchFile>& others, const std::vector<std::vector<BenchRatio>>& ratios);

}  // namespace bake::studies

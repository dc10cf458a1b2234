// SPDX-License-Identifier: MIT
// Statistics of repeated measurements, without assumptions about their distribution.
#pragma once

#include <optional>
#include <vector>

namespace bake::studies {

/// The median: the middle value, or the mean of both middle values; 0 if there are no values.
double median(std::vector<double> values);

/// The median, the smallest and the largest value.
struct Spread {
  double median = 0, low = 0, high = 0;
};
Spread spread_of(const std::vector<double>& values);  ///< of at least one

/// The test of Mann and Whitney (1947): is it chance that the numbers of one sample are larger than those of another?
struct MannWhitney {
  double U;           ///< pairs (x, y) with x > y; pairs of equals count half
  double p;           ///< probability of a U at least as far from its mean, to either side, if both samples have one distribution
  double p_smallest;  ///< p of two samples that do not overlap at all; if it is not small, the samples are too small for any decision
};

/// Of up to k_exact numbers together the distribution is counted out: of all ways to hand the pooled ranks (equals share the mean of
/// theirs) to the samples; of more it is taken as normal, with the variance n m / 12 (n + m + 1 - sum (t^3 - t) / ((n + m)(n + m - 1)))
/// for t equals each, and a continuity correction of 1/2. Neither sample may be empty.
MannWhitney mann_whitney(const std::vector<double>& x, const std::vector<double>& y);
inline constexpr std::size_t k_exact = 60;

/// A number with the interval that holds it with a probability of 95 %.
struct Estimate {
  double value;
  std::optional<double> low, high;  ///< none if there are too few numbers for any
};

/// By which factor the y are smaller than the x (x / y): Hodges' and Lehmann's median of all n m ratios. The interval is between
/// those ratios in order that Mann's and Whitney's test would just not tell from 1 (two-sided, 5 %). All numbers are above zero.
Estimate ratio_of(const std::vector<double>& x, const std::vector<double>& y);

/// Two-sided probability below which samples are told apart.
inline constexpr double k_significant = 0.05;

}  // namespace bake::studies

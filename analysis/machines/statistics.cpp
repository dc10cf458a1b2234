// SPDX-License-Identifier: MIT
#include "analysis/machines/statistics.h"

#include <algorithm>
#include <cmath>

namespace bake::studies {
namespace {

/// Twice the rank of every number among all, equals sharing the mean: whole numbers. First those of x, then those of y.
std::vector<int> doubled_ranks(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> all = x;
  all.insert(all.end(), y.begin(), y.end());
  std::vector<double> sorted = all;
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> ranks;
  for (const double value : all) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    ranks.push_back(static_cast<int>((first - sorted.begin()) + (last - sorted.begin()) + 1));
  }
  return ranks;
}

/// ways[s]: number of choices of n of the ranks that sum to s.
std::vector<double> ways_to_sum(const std::vector<int>& ranks, std::size_t n) {
  int total = 0;
  for (const int rank : ranks) total += rank;
  const auto sums = static_cast<std::size_t>(total) + 1;
  std::vector<std::vector<double>> ways(n + 1, std::vector<double>(sums, 0));
  ways[0][0] = 1;
  for (const int rank : ranks)
    for (std::size_t chosen = n; chosen > 0; --chosen)
      for (std::size_t s = sums - 1; s >= static_cast<std::size_t>(rank); --s)
        ways[chosen][s] += ways[chosen - 1][s - static_cast<std::size_t>(rank)];
  return ways[n];
}

/// Probability that the sum of n of the ranks is at least `distance` away from its mean; all numbers doubled.
double exact_p(const std::vector<int>& ranks, std::size_t n, double distance) {
  const auto ways = ways_to_sum(ranks, n);
  double total = 0;
  for (const int rank : ranks) total += rank;
  const double mean = total * static_cast<double>(n) / static_cast<double>(ranks.size());
  double all = 0, far = 0;
  for (std::size_t s = 0; s < ways.size(); ++s) {
    all += ways[s];
    if (std::abs(static_cast<double>(s) - mean) >= distance - 1e-6) far += ways[s];
  }
  return far / all;
}

/// Variance of U, with equals.
double variance(std::vector<int> ranks, double n, double m) {
  std::sort(ranks.begin(), ranks.end());
  double equals = 0;
  for (auto first = ranks.begin(); first != ranks.end();) {
    const auto last = std::upper_bound(first, ranks.end(), *first);
    const auto t = static_cast<double>(last - first);
    equals += t * t * t - t;
    first = last;
  }
  const double all = n + m;
  return n * m / 12 * (all + 1 - equals / (all * (all - 1)));
}

double normal_p(double distance, double variance) {
  if (variance <= 0) return 1;
  return std::min(1., std::erfc(std::max(0., distance - 0.5) / std::sqrt(2 * variance)));
}

/// Largest c with P(U <= c) of at most half of k_significant, for samples without equals; -1 if there is none.
int largest_unlikely(std::size_t n, std::size_t m) {
  if (n + m > k_exact) {
    constexpr double k_quantile = 1.959964;  // of the normal distribution, at 97.5 %
    const auto nm = static_cast<double>(n * m);
    return static_cast<int>(nm / 2 - k_quantile * std::sqrt(nm * static_cast<double>(n + m + 1) / 12) - 0.5);
  }
  std::vector<int> ranks;
  for (std::size_t i = 1; i <= n + m; ++i) ranks.push_back(static_cast<int>(i));
  const auto ways = ways_to_sum(ranks, n);
  double all = 0;
  for (const double w : ways) all += w;
  const std::size_t lowest = n * (n + 1) / 2;
  double below = 0;
  int c = -1;
  for (std::size_t u = 0; u <= n * m; ++u) {
    below += ways[lowest + u] / all;
    if (below > k_significant / 2) break;
    c = static_cast<int>(u);
  }
  return c;
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Spread spread_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {median(values), *low, *high};
}

MannWhitney mann_whitney(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size()), m = static_cast<double>(y.size());
  const std::vector<int> ranks = doubled_ranks(x, y);
  double sum = 0;  // of x's ranks
  for (std::size_t i = 0; i < x.size(); ++i) sum += ranks[i] / 2.;
  const double U = sum - n * (n + 1) / 2, distance = std::abs(U - n * m / 2);
  if (ranks.size() > k_exact) return {U, normal_p(distance, variance(ranks, n, m)), normal_p(n * m / 2, n * m * (n + m + 1) / 12)};
  double choices = 1;
  for (std::size_t i = 1; i <= x.size(); ++i) choices *= (m + static_cast<double>(i)) / static_cast<double>(i);
  return {U, exact_p(ranks, x.size(), 2 * distance), std::min(1., 2 / choices)};
}

Estimate ratio_of(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> ratios;
  for (const double a : x)
    for (const double b : y) ratios.push_back(a / b);
  std::sort(ratios.begin(), ratios.end());
  Estimate estimate{median(ratios), {}, {}};
  const int c = largest_unlikely(x.size(), y.size());
  if (c >= 0) {
    estimate.low = ratios[static_cast<std::size_t>(c)];
    estimate.high = ratios[ratios.size() - 1 - static_cast<std::size_t>(c)];
  }
  return estimate;
}

}  // namespace bake::studies

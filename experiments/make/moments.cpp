// SPDX-License-Identifier: MIT
#include "experiments/make/moments.h"

#include <algorithm>
#include <cmath>

namespace bake {
namespace {

/// Between two rows: the change of a column over its range.
void add_changes(const std::vector<double>& column, std::vector<double>& way) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : column)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (!(high > low)) return;
  for (std::size_t row = 1; row < column.size(); ++row) {
    const double change = std::abs(column[row] - column[row - 1]) / (high - low);
    if (std::isfinite(change)) way[row] += change;
  }
}

}  // namespace

std::vector<int> moments(const std::vector<std::vector<double>>& columns, int count, int first) {
  std::vector<double> way(columns.front().size(), 0.0);
  for (const auto& column : columns) add_changes(column, way);
  std::fill_n(way.begin(), first + 1, 0.0);
  for (std::size_t row = 1; row < way.size(); ++row) way[row] += way[row - 1];
  std::vector<int> rows{first};
  const int last = static_cast<int>(way.size()) - 1;
  for (int k = 1; k < count && rows.back() < last; ++k) {
    const double goal = way.back() * k / (count - 1);
    const auto from = way.begin() + rows.back() + 1;
    const auto above = std::lower_bound(from, way.end() - 1, goal);
    const bool before_is_nearer = above != from && goal - above[-1] < *above - goal;
    rows.push_back(k == count - 1 ? last : static_cast<int>(above - way.begin()) - before_is_nearer);
  }
  return rows;
}

}  // namespace bake

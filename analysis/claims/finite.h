// SPDX-License-Identifier: MIT
// NaN fails. Comparisons, std::max and std::clamp pass over NaN in silence, so numbers are looked at where metrics read them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "solver/core/errors.h"

namespace bake {

/// A metric has no number: it met one that is not finite, or there is nothing to measure. One line: file, row or frame, found, allowed.
/// A claim of that metric is missed.
class NoNumber : public InputError {
 public:
  using InputError::InputError;
};

/// Throws NoNumber if a value is NaN or infinite. `where()` gives the words for its place.
template <class Where>
void expect_finite(double value, Where where) {
  if (!std::isfinite(value)) throw NoNumber(fmt::format("{}: found {}, allowed: a finite number", where(), value));
}

/// The larger of two numbers; NaN if one of them is.
inline double larger(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::quiet_NaN() : std::max(a, b);
}
/// The smaller of two numbers; NaN if one of them is.
inline double smaller(double a, double b) { return -larger(-a, -b); }
/// The largest of a list; NaN if one of them is, or if there is none.
inline double largest_of(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), values.front(), larger);
}
/// The smallest of a list; NaN if one of them is, or if there is none.
inline double smallest_of(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), values.front(), smaller);
}

/// The number of the time that is nearest to `time`. Throws NoNumber if that is more than half a frame away: beyond the first or last
/// one. `where` is the file or folder for the message. Times rise; there is at least one.
template <class Times>
std::size_t nearest_time(const Times& times, double time, const std::string& where) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (std::abs(times[i] - time) < std::abs(times[nearest] - time)) nearest = i;
  const std::size_t beside = nearest > 0 ? nearest - 1 : std::min<std::size_t>(1, times.size() - 1);
  const double half = std::abs(times[nearest] - times[beside]) / 2;
  const bool outside = !(time >= times.front() && time <= times.back());
  if (outside && !(std::abs(times[nearest] - time) <= half * (1 + 1e-9)))
    throw NoNumber(fmt::format("{}: found no frame at {} s, allowed: {} to {} s", where, time, times.front(), times.back()));
  return nearest;
}

}  // namespace bake

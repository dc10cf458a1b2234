// SPDX-License-Identifier: MIT
#include "solver/core/curve.h"

#include <algorithm>
#include <stdexcept>

namespace bake {

double Curve::operator()(double at) const {
  if (points.empty()) throw std::logic_error("a curve without points has no value");
  const auto later = std::upper_bound(points.begin(), points.end(), at, [](double t, const Point& point) { return t < point.at; });
  if (later == points.begin()) return points.front().value;
  if (later == points.end()) return points.back().value;
  const Point& before = *(later - 1);
  const double share = (at - before.at) / (later->at - before.at);
  return before.value + share * (later->value - before.value);
}

}  // namespace bake

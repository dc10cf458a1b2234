// SPDX-License-Identifier: MIT
#include "solver/core/curve.h"

#include <algorithm>
#include <stdexcept>

namespace bake {

template <class Value>
Value CurveOf<Value>::operator()(double at) const {
  if (points.empty()) throw std::logic_error("a curve without points has no value");
  const auto later = std::upper_bound(points.begin(), points.end(), at, [](double t, const Point& point) { return t < point.at; });
  if (later == points.begin()) return points.front().value;
  if (later == points.end()) return points.back().value;
  const Point& before = *(later - 1);
  const double share = (at - before.at) / (later->at - before.at);
  return before.value + share * (later->value - before.value);
}

template <class Value>
Value CurveOf<Value>::mean(double from, double to) const {
  if (!(to > from) || from >= points.back().at || to <= points.front().at) return (*this)(from);
  const Value first = (*this)(from);
  bool constant = first == (*this)(to);
  for (const Point& point : points)
    if (point.at > from && point.at < to) constant &= point.value == first;
  if (constant) return first;  // without round-off
  double at = from;
  Value integral = 0. * points.front().value;
  const auto add = [&](double next) {
    integral = integral + 0.5 * (next - at) * ((*this)(at) + (*this)(next));
    at = next;
  };
  for (const Point& point : points)
    if (point.at > from && point.at < to) add(point.at);
  add(to);
  return (1 / (to - from)) * integral;
}

template struct CurveOf<double>;
template struct CurveOf<Vector3>;

/// Between two points it is nowhere longer than at the longer of them.
double largest_length(const VectorCurve& curve) {
  double largest = 0;
  for (const VectorCurve::Point& point : curve.points) largest = std::max(largest, length(point.value));
  return largest;
}

}  // namespace bake

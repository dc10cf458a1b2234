// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/core/vector3.h"

namespace bake {

/// A quantity that changes with time (or stays constant: one point). It is linear between points and constant outside.
/// In a scene: a value, or a list of [time_s, value] pairs with rising times.
template <class Value>
struct CurveOf {
  struct Point {
    double at;
    Value value;
  };
  std::vector<Point> points;

  CurveOf() = default;
  CurveOf(const Value& constant) : points{{0.0, constant}} {}  // NOLINT: a number is a curve
  Value operator()(double at) const;
  Value mean(double from, double to) const;  ///< over that time, which may be none
};

using Curve = CurveOf<double>;
using VectorCurve = CurveOf<Vector3>;

double largest_length(const VectorCurve& curve);  ///< at any time

}  // namespace bake

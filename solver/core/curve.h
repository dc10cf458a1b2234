// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace bake {

/// A quantity that changes with time (or stays constant: one point). It is linear between points and constant outside.
/// In a scene: a number, or a list of [time_s, value] pairs with rising times.
struct Curve {
  struct Point {
    double at;
    double value;
  };
  std::vector<Point> points;

  Curve() = default;
  Curve(double constant) : points{{0.0, constant}} {}  // NOLINT: a number is a curve
  double operator()(double at) const;
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// Shapes as signed distances: the one description of bodies, colliders, grips and emitters.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "solver/core/parameter.h"

namespace bake {

/// A point or direction in space [m].
using Point = Vector3;

struct Box3 {
  Point low;
  Point high;
};

/// A solid given by its signed distance [m]: negative inside, positive outside, right sign everywhere. Exact for the
/// plain shapes. A superellipsoid is right to first order at its surface; combinations take the smallest or largest
/// distance of their parts. Outside, none claims more than the exact distance, so a ball of that radius is free (unless a
/// superellipsoid is cut out of it: inside, that one may claim more than its depth).
class Shape {
 public:
  virtual ~Shape() = default;
  virtual double distance(const Point& x) const = 0;
  /// Outward unit normal at the nearest surface point (direction of the distance's gradient).
  virtual Point normal(const Point& x) const;
  /// Box that holds the solid; infinite extents for half-spaces and complements.
  virtual Box3 bounds() const = 0;
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace bake

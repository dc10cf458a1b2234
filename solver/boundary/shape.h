// SPDX-License-Identifier: MIT
// Shapes as signed distances: bodies, colliders, grips and emitters are all described like this.
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

/// A solid given by its signed distance [m]: negative inside, positive outside. The sign is right everywhere. The distance is exact for the
/// simple shapes and right to first order at the surface of a superellipsoid; combinations take the smallest or largest distance of their
/// parts. Outside, the value is never larger than the exact distance, so that a ball of this radius is free of the solid. (The exception is
/// a solid from which a superellipsoid is cut out: inside a superellipsoid the value may exceed the depth.)
class Shape {
 public:
  virtual ~Shape() = default;
  virtual double distance(const Point& x) const = 0;
  /// Outward unit normal at the nearest surface point (direction of the distance's gradient).
  virtual Point normal(const Point& x) const;
  /// A box that contains the solid; half-spaces and complements have infinite extents.
  virtual Box3 bounds() const = 0;
  /// [m^3]; infinite for a solid without end. Of combinations and parts of them it is sampled, see sampled_volume (fill.h).
  virtual double volume() const;
};

using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace bake

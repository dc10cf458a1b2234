// SPDX-License-Identifier: MIT
// Shapes as signed distances: the one description of bodies, colliders, grips and emitters.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "solver/scene/parameter.h"

namespace bake {

/// A point or direction in space [m].
using Point = Vector3;

struct Box3 {
  Point low;
  Point high;
};

/// A solid given by its signed distance [m]: negative inside, positive outside. For shapes whose exact distance has
/// no closed form (ellipsoid, superellipsoid, differences) it is a first-order distance: right sign everywhere,
/// right to first order near the surface, never steeper than 1.
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

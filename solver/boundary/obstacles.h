// SPDX-License-Identifier: MIT
// The interface through which effects see solids that act on single particles.
#pragma once

#include "solver/boundary/shape.h"

namespace bake {

class Obstacles {
 public:
  virtual ~Obstacles() = default;
  /// Moves a particle of the mass `mass` [kg] that is inside a solid onto its surface and applies the contact rule to its velocity. Returns
  /// whether it was inside.
  virtual bool push_out(Point& x, Vector3& v, double mass) const = 0;
  /// Is a place inside of a grip that holds its temperature?
  virtual bool holds_temperature(const Point& x) const = 0;
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// Solids that particles may not enter, as the effects see them.
#pragma once

#include "solver/boundary/shape.h"

namespace bake {

class Obstacles {
 public:
  virtual ~Obstacles() = default;
  /// Puts a particle that is inside a solid onto its surface and applies the contact rule to its velocity. Returns whether it
  /// was inside.
  virtual bool push_out(Point& x, Vector3& v) const = 0;
};

}  // namespace bake

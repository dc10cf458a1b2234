// SPDX-License-Identifier: MIT
// The largest step that every effect allows.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/scene/settings.h"

namespace bake {

struct Scene;

/// Maxima over the particles that bound the step.
struct Maxima {
  double speed2 = 0;        ///< [m^2/s^2]
  double wave2 = 0;         ///< [m^2/s^2]
  double heat = 0;          ///< [m^2/s]
  double water = 0;         ///< [m^2/s]
  double deformation2 = 0;  ///< [1/s^2]
};

/// Which limit holds, for messages.
struct StepLimit {
  double dt;
  const char* reason;
};

class StepLimits {
 public:
  explicit StepLimits(const Scene& scene);
  /// `contact_speed`: of the fastest collider [m/s].
  StepLimit largest(const Maxima& maxima, double contact_speed) const;

 private:
  TimeSettings settings_;
  double dx_, gravity_;
  double diffusion_;      ///< what dt D / dx^2 may be
  double heat_factor_;    ///< times forward Euler's limit
  double pouring_speed_;  ///< [m/s]
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// The longest step that every effect and everything that moves by script allows.
#pragma once

#include "solver/engine/physics.h"

namespace bake {

/// `most`: maxima over the particles; `contact_speed`: of the fastest collider or grip [m/s]; `alone`: see StepScale.
template <class Real>
StepLimit largest_step(const Scene& scene, const Physics<Real>& physics, const Bounds& most, double contact_speed, double alone = 1);

}  // namespace bake

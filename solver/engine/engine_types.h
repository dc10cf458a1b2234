// SPDX-License-Identifier: MIT
// What goes into the engine and comes out of it, besides the scene.
#pragma once

#include <cstdint>
#include <functional>

#include "solver/boundary/shape.h"

namespace bake {

struct Body;

/// A particle to be: position [m], volume [m^3], start motion.
struct NewParticle {
  Point x;
  double volume;
  std::int32_t material;
  Vector3 velocity;
  Vector3 angular_velocity;  ///< [rad/s]; its velocity field is already in `velocity`
  const Body* body;          ///< start temperature, saturation, leavener
};

/// A force that no scene has (a study's): the velocity [m/s] that a node at `x` [m] has after it, if the step's other forces left the
/// node with `v`, in the step from `time` on for `dt` [s]. Called by several threads at once.
using NodalForce = std::function<Vector3(const Point& x, const Vector3& v, double time, double dt)>;

/// What a solid or a face of the domain gave to the dough.
struct Given {
  Vector3 impulse{0, 0, 0};  ///< [kg m/s]
  double heat = 0;           ///< [J]
};

/// Counts since the start of the run.
struct Counters {
  std::int64_t steps = 0;
  std::int64_t particle_steps = 0;
  std::int64_t orderings = 0;
  std::int64_t clamped = 0;  ///< times a particle was held at a face of the domain
  std::int64_t retired = 0;  ///< particles that left through open faces
};

/// The start in which the dough settles. The scene's time is 0 all the while.
struct Settling {
  bool now = false;       ///< does the step that comes next belong to it?
  double time = 0;        ///< that it has taken [s]
  double still_for = 0;   ///< no particle was faster than the rule says for so long [s]
  bool is_still = false;  ///< did it end because the dough lay still?
};

/// Where the time of the steps went [s of the clock], since the engine was made.
struct PhaseSeconds {
  double grid = 0;      ///< the grid update: surface, forces, contact
  double transfer = 0;  ///< the pass over the particles: clearing the grid, gather, law, scatter
  double ordering = 0;  ///< particles into new home blocks, and the grid's rows after them
};

}  // namespace bake

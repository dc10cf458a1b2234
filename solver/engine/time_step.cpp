// SPDX-License-Identifier: MIT
#include "solver/engine/time_step.h"

#include "solver/core/vector3.h"
#include "solver/effects/heat.h"
#include "solver/effects/motion.h"
#include "solver/scene/scene.h"

namespace bake {

StepLimits::StepLimits(const Scene& scene)
    : settings_(scene.time),
      dx_(scene.dx()),
      gravity_(scene.lists("motion") ? length(scene.of<Motion>().gravity_m_per_s2) : 0),
      diffusion_(scene.grid.kernel == KernelOrder::quadratic ? 1. / 3 : 1. / 2),
      heat_factor_(scene.of<Heat>().integrator == Heat::Integrator::backward_euler ? scene.of<Heat>().implicit_step_factor : 1),
      pouring_speed_(0) {
  for (const Emitter& emitter : scene.emitters) pouring_speed_ = std::max(pouring_speed_, length(emitter.velocity_m_per_s));
}

StepLimit StepLimits::largest(const Maxima& m, double contact_speed) const {
  StepLimit best{settings_.largest_step_s, "time.largest_step_s"};
  const auto consider = [&](double dt, const char* reason) {
    if (dt < best.dt) best = {dt, reason};
  };
  const double safety = settings_.safety;
  // A wave crosses one cell: the highest frequency of the lumped B-spline grid is below 2 c / dx, explicit integration
  // holds for dt < 2 / frequency.
  if (m.wave2 > 0) consider(safety * dx_ / std::sqrt(m.wave2), "stiffness (elastic, pore gas and water)");
  // Forward Euler: dt < 2 / eigenvalue. With particles everywhere the largest eigenvalue of the moment form is 1.94 D / dx^2
  // (quadratic) or 1.21 D / dx^2 (cubic), for a wave along one axis; light nodes at surfaces and thin filling cost up to two
  // thirds of that (`bake study stability`): dt D / dx^2 below 1/3 and 1/2.
  // Backward Euler is stable with any step; its factor is a bound on the error.
  if (m.heat > 0) consider(heat_factor_ * safety * diffusion_ * dx_ * dx_ / m.heat, "heat conduction");
  if (m.water > 0) consider(safety * diffusion_ * dx_ * dx_ / m.water, "water diffusion");
  // |dt C| below 1/2 keeps I + dt C far from singular.
  if (m.deformation2 > 0) consider(0.5 / std::sqrt(m.deformation2), "rate of deformation");
  const double speed = std::max({std::sqrt(m.speed2), contact_speed, pouring_speed_});  // what is poured arrives between two choices
  if (speed > 0) consider(settings_.cfl * dx_ / speed, "particle travel (time.cfl)");
  if (gravity_ > 0) consider(std::sqrt(settings_.cfl * dx_ / gravity_), "gravity (time.cfl)");
  return best;
}

}  // namespace bake

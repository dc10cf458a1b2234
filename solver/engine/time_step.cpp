// SPDX-License-Identifier: MIT
#include "solver/engine/time_step.h"

#include "solver/scene/scene.h"

namespace bake {

template <class Real>
StepLimit largest_step(const Scene& scene, const Physics<Real>& physics, const Bounds& most, double contact_speed, double alone) {
  StepLimit limit{scene.time.largest_step_s, "time.largest_step_s"};
  const bool quadratic = scene.grid.kernel == KernelOrder::quadratic;
  const double diffusion = quadratic ? 1. / 3 : 1. / 2, diffusion_alone = quadratic ? 1. / 4 : 1. / 3;  // as the effects derive
  physics.limit_step(most, {scene.dx(), scene.time.safety, scene.time.cfl, diffusion, diffusion_alone, alone}, scene, limit);
  double speed = contact_speed;
  for (const Emitter& emitter : scene.emitters)  // what is poured arrives between two choices
    speed = std::max(speed, length(emitter.velocity_m_per_s));
  if (speed > 0) limit.at_most(scene.time.cfl * scene.dx() / speed, "particle travel (time.cfl)");
  return limit;
}

template StepLimit largest_step(const Scene&, const Physics<float>&, const Bounds&, double, double);
template StepLimit largest_step(const Scene&, const Physics<double>&, const Bounds&, double, double);

}  // namespace bake

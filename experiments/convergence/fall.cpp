// SPDX-License-Identifier: MIT
// A cube falls freely: v = g t, z = g t^2 / 2.
#include <fmt/format.h>

#include <cmath>

#include "analysis/claims/finite.h"
#include "experiments/common/study_scene.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

std::vector<Errors> free_fall(bool) {
  constexpr double g = 1, t = 0.5;
  Errors velocity, place;
  velocity.quantity = "velocity, largest of the particles";
  velocity.figure = Errors::Figure::largest_error;
  velocity.high = 1e-12;
  velocity.why = "exact: every node gains g dt, and uniform motion passes between particles and nodes to round-off";
  place.quantity = "path, largest of the particles";
  place.low = 0.999, place.high = 1.001;
  place.why = "first order, exactly: the velocity after the step moves the particles, which are g t dt / 2 ahead";
  velocity.refined = place.refined = "steps";
  velocity.refinements = place.refinements = {20, 40, 80};
  for (const double steps : place.refinements) {
    StudyScene setting("motion, elasticity");
    setting.frame_s = t;
    setting.dx = 0.0625;
    setting.time = fmt::format("largest_step_s = {:.17g}", t / (steps - 0.5));
    setting.gravity = fmt::format("[0, 0, {}]", -g);
    setting.material += "young_modulus_Pa = 1e-3\n";
    setting.tables = "[[body]]\nmaterial = \"dough\"\nshape = { box = { centre_m = [0, 0, 0.3], half_extents_m = [0.2, 0.2, 0.2] } }\n";
    const auto s = setting.begin();
    const Snapshot first = s->snapshot();
    run_to(*s, t);
    const Snapshot now = s->snapshot();
    double of_velocity = 0, of_place = 0;
    for (std::size_t i = 0; i < now.id.size(); ++i) {
      of_velocity = larger(of_velocity, std::abs(now.velocity[i][2] + g * t) / (g * t));
      of_place = larger(of_place, std::abs(now.position[i][2] - first.position[i][2] + g * t * t / 2) / (g * t * t / 2));
    }
    velocity.errors.push_back(of_velocity);
    place.errors.push_back(of_place);
  }
  return {velocity, place};
}

}  // namespace bake::studies

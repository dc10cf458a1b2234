// SPDX-License-Identifier: MIT
#include "experiments/fig15_bread/dough.h"

#include <memory>

#include "solver/boundary/shapes.h"
#include "solver/effects/motion.h"
#include "solver/scene/reader.h"

namespace bake {

Scene bread_scene(const std::vector<std::string>& overrides) {
  ReadOptions options;
  options.overrides = overrides;
  return read_scene(BAKE_SOURCE_DIR "/experiments/fig15_bread/bread.toml", options);
}

void hold_block(Scene& scene, const Curve& held) {
  scene.run.precision = Precision::double_precision;
  scene.time.largest_step_s = held.points.back().at / 1000;
  scene.settings.get<Motion::Settings>().inertia_scale = 1e6;  // nothing moves: no sound has to be followed
  scene.grid.dx_m = 0.1;
  scene.domain.min_m = {-0.5, -0.5, -0.5};
  scene.domain.max_m = {0.5, 0.5, 0.5};
  scene.colliders.clear();
  scene.emitters.clear();
  Box block;
  block.half_extents_m = {0.1, 0.1, 0.1};
  scene.bodies.resize(1);
  scene.bodies[0] = {};
  scene.bodies[0].material = scene.materials[0].name;
  scene.bodies[0].shape = std::make_shared<Box>(block);
  scene.bodies[0].temperature_C = held(0);
  Box hand;
  hand.half_extents_m = {0.5, 0.5, 0.5};
  scene.grips.resize(1);
  scene.grips[0] = {};
  scene.grips[0].name = "hand";
  scene.grips[0].shape = std::make_shared<Box>(hand);
  scene.grips[0].temperature_C = held;
}

}  // namespace bake

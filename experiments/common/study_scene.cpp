// SPDX-License-Identifier: MIT
#include "experiments/common/study_scene.h"

#include <omp.h>

namespace bake::studies {

std::unique_ptr<Simulation> StudyScene::begin() const {
  omp_set_num_threads(threads);
  return Simulation::begin(scene());
}

std::unique_ptr<Simulation> StudyScene::after(double time) const {
  auto simulation = begin();
  run_to(*simulation, time);
  return simulation;
}

void run_to(Simulation& simulation, double time) { simulation.advance(time, time); }

}  // namespace bake::studies

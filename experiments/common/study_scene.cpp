// SPDX-License-Identifier: MIT
#include "experiments/common/study_scene.h"

#include <omp.h>

namespace bake::studies {

std::unique_ptr<Simulation> StudyScene::begin() const {
  omp_set_num_threads(threads);
  return Simulation::begin(scene());
}

void run_to(Simulation& simulation, double time) { simulation.advance(time, time); }

double total(const Simulation& simulation, Total which) { return simulation.totals()[static_cast<std::size_t>(which)]; }
double booked(const Simulation& simulation, Entry which) { return simulation.booked()[static_cast<std::size_t>(which)]; }

}  // namespace bake::studies

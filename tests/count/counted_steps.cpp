// SPDX-License-Identifier: MIT
#include "tests/count/counted_steps.h"

#include <omp.h>
#include <valgrind/callgrind.h>

#include "analysis/machines/scenes.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene.h"

namespace bake::count {

namespace {

constexpr double k_particles = 8000;
constexpr int k_warm_up = 12;  // then most particles flow

}  // namespace

void take_counted_steps() {
  omp_set_num_threads(1);
  for (const bench::Combination& combination : bench::k_combinations) {
    const Scene scene = bench::loaf(combination, Precision::single_precision, k_particles);
    const auto simulation = Simulation::begin(scene);
    bench::take_steps(*simulation, k_warm_up);
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    bench::take_steps(*simulation, 1);
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS_AT(combination.name.c_str());
  }
}

}  // namespace bake::count

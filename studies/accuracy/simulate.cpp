// SPDX-License-Identifier: MIT
#include "studies/accuracy/simulate.h"

#include <omp.h>

#include <cmath>
#include <ctime>

#include "solver/baker/run_error.h"
#include "solver/io/progress.h"
#include "studies/setting.h"

namespace bake::studies::accuracy {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void advance_timed(Simulation& simulation, double time, Found& found) {
  const double wall = steady_seconds(), cpu = processor_seconds();
  run_to(simulation, time);
  found.wall_s += steady_seconds() - wall;
  found.cpu_s += processor_seconds() - cpu;
}

void count(const Simulation& simulation, Found& found) {
  found.particles = static_cast<std::int64_t>(simulation.particles());
  found.steps = simulation.counters().steps;
  found.particle_steps = simulation.counters().particle_steps;
}

Found simulate(const Scene& scene, const std::vector<double>& times, const Compare& compare, const NodalForce& force) {
  omp_set_num_threads(1);
  const auto simulation = Simulation::begin(scene);
  if (force) simulation->set_force(force);
  Found found;
  std::vector<Snapshot> seen;
  try {
    for (const double t : times) {
      if (t > 0) advance_timed(*simulation, t, found);
      seen.push_back(simulation->snapshot());
    }
    found.error = compare(seen);
    if (!std::isfinite(found.error)) found.failure = "the result is no number";
  } catch (const RunError& error) {
    found.failure = error.what();
  }
  count(*simulation, found);
  return found;
}

}  // namespace bake::studies::accuracy

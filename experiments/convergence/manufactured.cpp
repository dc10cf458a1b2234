// SPDX-License-Identifier: MIT
#include "experiments/convergence/manufactured.h"

#include "experiments/common/study_scene.h"
#include "experiments/convergence/bar.h"

namespace bake::studies {

double place_error(const Snapshot& first, const Snapshot& now, double t, const std::function<bool(const Point&)>& counts,
                   Point (*position)(const Point& X, double t)) {
  std::vector<double> off;
  for (std::size_t p = 0; p < now.id.size(); ++p)
    if (counts(first.position[p])) off.push_back(length(now.position[p] - position(first.position[p], t)));
  return root_mean_square(off);
}

double place_error(Simulation& simulation, double t, const std::function<bool(const Point&)>& counts,
                   Point (*position)(const Point& X, double t)) {
  const Snapshot first = simulation.snapshot();
  run_to(simulation, t);
  return place_error(first, simulation.snapshot(), t, counts, position);
}

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
#include "studies/accuracy/simulate.h"

#include <cmath>

#include "solver/baker/run_error.h"

namespace bake::studies::accuracy {

Found simulate(const Scene& scene, By by, const std::vector<double>& times, const Compare& compare, const NodalForce& force) {
  const auto running = begin(scene, by, times.back(), force);
  Found found;
  std::vector<Snapshot> seen;
  try {
    for (const double t : times) {
      if (t > 0) running->advance(t, found);
      seen.push_back(running->snapshot());
    }
    found.error = compare(seen);
    if (!std::isfinite(found.error)) found.failure = "the result is no number";
  } catch (const RunError& error) {
    found.failure = error.what();
  }
  running->count(found);
  return found;
}

}  // namespace bake::studies::accuracy

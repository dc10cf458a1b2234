// SPDX-License-Identifier: MIT
#include "experiments/accuracy/simulate.h"

namespace bake::studies::accuracy {

Found simulate(const Scene& scene, By by, const std::vector<double>& times, const Compare& compare, const NodalForce& force) {
  const auto work = [&](Running& running, Found& found) {
    std::vector<Snapshot> seen;
    for (const double t : times) {
      if (t > 0) running.advance(t, found);
      seen.push_back(running.snapshot());
    }
    found.error = compare(seen);
  };
  return run(scene, by, times.back(), work, force);
}

}  // namespace bake::studies::accuracy

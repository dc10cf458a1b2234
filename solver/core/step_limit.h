// SPDX-License-Identifier: MIT
// The longest step that is allowed, and by what.
#pragma once

#include <limits>

namespace bake {

/// Which limit holds, for messages.
struct StepLimit {
  double dt = std::numeric_limits<double>::infinity();  ///< [s]
  const char* reason = "";

  void at_most(double longest, const char* why) {
    if (longest < dt) *this = {longest, why};
  }
};

/// What limits are measured by.
struct StepScale {
  double dx;         ///< node distance [m]
  double safety;     ///< share of a limit of stability that is used
  double cfl;        ///< largest travel per step, in dx
  double diffusion;  ///< largest dt D / dx^2 of explicit diffusion on this kernel
  double alone;      ///< of omega^2 of a particle alone, the share that the particles have which have the fewest others around them
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// The longest step that is allowed, and by what.
#pragma once

#include <algorithm>
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
  double dx;               ///< node distance [m]
  double safety;           ///< share of a limit of stability that is used
  double cfl;              ///< largest travel per step, in dx
  double diffusion;        ///< largest dt D / dx^2 of explicit diffusion on this kernel
  double diffusion_alone;  ///< and of a particle alone on its nodes
  double alone;            ///< of omega^2 of a particle alone, the share that the particles have which have the fewest others around them
};

/// Of a limit that is exact: more than 0.9 only where `safety` says so.
inline double share_of_exact(const StepScale& at) { return std::max(0.9, at.safety); }

/// Forward Euler of a diffusivity D [m^2/s]. A particle alone gets back from its nodes the gradient that its own flux made there in the
/// last step, -dt D D_kernel^-1 times that of the step before: it grows without end above 1.
inline void limit_diffusion(double D, const StepScale& at, StepLimit& limit, const char* why) {
  if (D > 0) limit.at_most(std::min(at.safety * at.diffusion, share_of_exact(at) * at.diffusion_alone) * at.dx * at.dx / D, why);
}

}  // namespace bake

// SPDX-License-Identifier: MIT
// Shares of the volume of a frame, and when shares are reached, as metrics measure them.
#pragma once

#include <cmath>
#include <vector>

#include "analysis/claims/finite.h"
#include "analysis/claims/results.h"

namespace bake {

/// The volume of the particles for which `counted(row)`, over that of those for which `asked(row)` (all rows from 0 on). Those that are
/// counted are among those that are asked. Not a number if nothing is asked.
template <class Asked, class Counted>
double volume_share(const CheckedFrame& frame, Asked asked, Counted counted) {
  const auto volumes = frame.column("volume");
  double all = 0, some = 0;
  for (std::size_t row = 0; row < volumes.size(); ++row) {
    if (!asked(row)) continue;
    all += static_cast<double>(volumes[row]);
    if (counted(row)) some += static_cast<double>(volumes[row]);
  }
  return all > 0 ? some / all : std::nan("");
}

/// The same of the volume of all particles.
template <class Counted>
double volume_share(const CheckedFrame& frame, Counted counted) {
  return volume_share(
      frame, [](std::size_t) { return true; }, counted);
}

/// The first time, linear between frames, at which a share reaches `share`; infinite if it does not.
inline double time_of_share(const std::vector<double>& times, const std::vector<double>& shares, double share) {
  for (std::size_t i = 1; i < times.size(); ++i)
    if (shares[i] >= share && shares[i - 1] < share)
      return times[i - 1] + (times[i] - times[i - 1]) * (share - shares[i - 1]) / (shares[i] - shares[i - 1]);
  return k_infinity;
}

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/core/lanes.h"

#include <Eigen/Core>

namespace bake {

// An Eigen packet is as wide as a register, so it holds exactly one pack of lanes.
#define BAKE_LANE_FUNCTION(name, Real)                                                       \
  Lanes<Real> name(Lanes<Real> a) {                                                          \
    using Array = Eigen::Array<Real, k_width<Real>, 1>;                                      \
    Lanes<Real> result;                                                                      \
    Eigen::Map<Array, Eigen::Aligned16>(reinterpret_cast<Real*>(&result)) =                  \
        Eigen::Map<const Array, Eigen::Aligned16>(reinterpret_cast<const Real*>(&a)).name(); \
    return result;                                                                           \
  }
BAKE_LANE_FUNCTION(exp, float)
BAKE_LANE_FUNCTION(exp, double)
BAKE_LANE_FUNCTION(log, float)
BAKE_LANE_FUNCTION(log, double)
BAKE_LANE_FUNCTION(expm1, float)
BAKE_LANE_FUNCTION(expm1, double)
BAKE_LANE_FUNCTION(log1p, float)
BAKE_LANE_FUNCTION(log1p, double)

}  // namespace bake

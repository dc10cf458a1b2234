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
BAKE_LANE_FUNCTION(log1p, float)

// Eigen would call glibc's functions of one double, whose bits depend on the processor [cf. Kahan's way in Higham, "Accuracy and Stability
// of Numerical Algorithms", Sec. 1.14.1: the error of u is the same above and below].
Lanes<double> expm1(Lanes<double> a) {
  const Lanes<double> u = exp(a), less = u - 1;
  const Lanes<double> value = less * (a / log(u));
  return u == 1 ? a : less == -1 ? less : value;
}
Lanes<double> log1p(Lanes<double> a) {
  const Lanes<double> u = 1 + a;
  const Lanes<double> value = log(u) * (a / (u - 1));
  return u == 1 ? a : value;
}

}  // namespace bake

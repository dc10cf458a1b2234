// SPDX-License-Identifier: MIT
#include "solver/core/lanes.h"

#include <Eigen/Core>
#include <numbers>

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

namespace {

/// The angle is taken from a tangent of at most 1, halved twice by tan(x/2) = tan(x) / (1 + sqrt(1 + tan(x)^2)) to below 0.2, where few
/// terms of the power series are enough.
template <int terms, class V>
V angle_of_tangent(V a) {
  using Real = std::decay_t<decltype(a[0])>;
  const V magnitude = abs(a);
  const auto steep = magnitude > 1;
  V t = steep ? 1 / magnitude : magnitude;
  for (int halving = 0; halving < 2; ++halving) t = t / (1 + sqrt(1 + t * t));
  V sum{};
  for (int n = terms; n >= 0; --n) sum = Real(n % 2 == 0 ? 1. : -1.) / Real(2 * n + 1) + t * t * sum;
  const V angle = 4 * t * sum, whole = steep ? Real(std::numbers::pi / 2) - angle : angle;
  return a < 0 ? -whole : whole;
}

}  // namespace

Lanes<float> atan(Lanes<float> a) { return angle_of_tangent<5>(a); }
Lanes<double> atan(Lanes<double> a) { return angle_of_tangent<11>(a); }

}  // namespace bake

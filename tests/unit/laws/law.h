// SPDX-License-Identifier: MIT
// Laws are statements over all inputs: each is tried on random ones, and the simplest counterexample is shown.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>

#include "solver/core/symmetric.h"

namespace bake {

/// A random number from `low` to `high`, both included.
inline double between(double low, double high, const std::string& name) {
  constexpr int k_parts = 1'000'000;
  return *rc::gen::map(rc::gen::inRange(0, k_parts + 1), [=](int i) { return low + (high - low) * i / k_parts; }).as(name);
}
/// A random number from 10^low to 10^high, every decade alike.
inline double decades(double low, double high, const std::string& name) { return std::pow(10, between(low, high, "log10 " + name)); }
/// A random symmetric matrix with components up to `most`.
inline Symmetric<double> random_symmetric(double most, const std::string& name) {
  Symmetric<double> a;
  for (double& x : a.at) x = between(-most, most, name);
  return a;
}

inline void expect_near(double a, double b, double bound) {
  if (!(std::abs(a - b) <= bound)) RC_FAIL(fmt::format("{:.17g} is not {:.17g} to {:.3g}", a, b, bound));
}

template <class Real>
class Law : public testing::Test {
 public:
  using V = Lanes<Real>;
  static constexpr double eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
  static V all(double x) { return lanes<Real>(static_cast<Real>(x)); }
  static double first(V x) { return static_cast<double>(x[0]); }
  /// The number as the solver sees it.
  static double seen(double x) { return static_cast<double>(static_cast<Real>(x)); }
  static Symmetric<V> all(const Symmetric<double>& a) {
    Symmetric<V> result;
    for (int i = 0; i < 6; ++i) result.at[i] = all(a.at[i]);
    return result;
  }
};
using Reals = testing::Types<float, double>;

}  // namespace bake

// SPDX-License-Identifier: MIT
// What the studies of films on soft ground share: from the strains at which waves of several lengths would grow to the first that does.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace bake::studies::film {

using Waves = std::array<double, 3>;  ///< of one number for each wave

struct Wrinkle {
  double wavelength, onset;
};

/// The least value of a k^2 + b / k, fitted to strains at three wave numbers k by least squares: the onset, and where it is.
inline Wrinkle least_of_fit(const Waves& k, const Waves& strains) {
  double aa = 0, ab = 0, bb = 0, a_e = 0, b_e = 0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    const double p = k[i] * k[i], q = 1 / k[i];
    aa += p * p, ab += p * q, bb += q * q, a_e += p * strains[i], b_e += q * strains[i];
  }
  const double det = aa * bb - ab * ab, a = (a_e * bb - b_e * ab) / det, b = (b_e * aa - a_e * ab) / det;
  const double at = std::cbrt(b / (2 * a));
  return {2 * std::numbers::pi / at, a * at * at + b / at};
}

/// The strains at which the stiffness would be zero, from what waves yield without strain and at the strain `e`: it falls evenly with it.
inline Waves critical_strains(const Waves& free, const Waves& pressed, double e) {
  Waves found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double S_0 = 1 / free[i], S_e = 1 / pressed[i];
    found[i] = e * S_0 / (S_0 - S_e);
  }
  return found;
}

/// Of two loads of opposite sign: what dough moves by itself is not in it.
inline Waves mean(const Waves& up, const Waves& down) {
  Waves mean;
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (up[i] + down[i]) / 2;
  return mean;
}

}  // namespace bake::studies::film

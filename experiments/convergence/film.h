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

}  // namespace bake::studies::film

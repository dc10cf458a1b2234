// SPDX-License-Identifier: MIT
// What the studies of films on soft ground share: how the piece is pressed and loaded, and the way from the strains at which waves of
// several lengths would grow to the first that does.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "experiments/common/study_scene.h"
#include "solver/core/errors.h"

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

/// The strains at which the stiffness would be zero, from what waves yield at the strain `e` and at a lower one: it falls evenly with it.
inline Waves critical_strains(const Waves& at_lower, double lower, const Waves& at_e, double e) {
  Waves found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double S_lower = 1 / at_lower[i], S_e = 1 / at_e[i];
    found[i] = lower + (e - lower) * S_lower / (S_lower - S_e);
  }
  return found;
}

inline constexpr double k_pressed = 1;  ///< until then the piece is compressed [s]

/// A wall that holds the piece once it is compressed; point and normal in x and z.
inline std::string wall(const char* contact, double x, double z, int n_x, int n_z) {
  return fmt::format(
      "[[collider]]\nshape = {{ half_space = {{ point_m = [{:.17g}, 0, {:.17g}], normal = [{}, 0, {}] }} }}\ncontact = \"{}\"\n"
      "from_s = {}\n",
      x, z, n_x, n_z, contact, k_pressed);
}

/// Compresses the piece evenly by the logarithmic strain `e`, free of stress along z.
inline void press(Simulation& simulation, double e, double poisson_ratio) {
  const double nu = poisson_ratio, along = (std::exp(-e) - 1) / k_pressed, up = (std::exp(nu / (1 - nu) * e) - 1) / k_pressed;
  simulation.set_force([=](const Point& x, const Vector3&, double t, double) {
    return Vector3{along * x[0] / (1 + along * t), 0, up * x[2] / (1 + up * t)};  // places change linearly: exact for steps of any length
  });
  run_to(simulation, k_pressed);
}

/// Then lets it yield to an acceleration push(x) along z, while all motion is damped by `rate` and by the transfers, until it is at rest.
/// What `measure` finds then. It is asked at times that double, until it changes by less than a hundredth: what would still come is of the
/// order of the square of that. Throws RunError if it does not come to rest.
template <class Push, class Measure>
Waves load(Simulation& simulation, double rate, Push push, Measure measure) {
  simulation.set_force([=](const Point& x, const Vector3& v, double t, double dt) {
    if (t <= k_pressed) return Vector3{0, 0, 0};
    return std::exp(-rate * dt) * (v + Vector3{0, 0, dt * push(x)});
  });
  Waves before{};
  for (double after = 16 / rate; after < 2000 / rate; after *= 2) {
    run_to(simulation, k_pressed + after);
    const Waves now = measure();
    bool at_rest = true;
    for (std::size_t i = 0; i < now.size(); ++i) at_rest = at_rest && std::abs(now[i] - before[i]) < 0.01 * std::abs(now[i]);
    if (at_rest) return now;
    before = now;
  }
  throw RunError("a loaded film does not come to rest");
}

/// Of two loads of opposite sign: what dough moves by itself is not in it.
inline Waves mean(const Waves& up, const Waves& down) {
  Waves mean;
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (up[i] + down[i]) / 2;
  return mean;
}

}  // namespace bake::studies::film

// SPDX-License-Identifier: MIT
// Exact solutions and their scenes that other studies measure, too.
#pragma once

#include "experiments/convergence/bar.h"

namespace bake::studies {

/// A slab from 0 to 1 at temperature 0 whose faces are held at 1 (x = 0) and 0 (x = 1): theta at x after `fourier` = D t / L^2.
double held_slab_temperature(double x, double fourier);

/// Root n = 0, 1, ... of z tan z = Bi, between n pi and (n + 1/2) pi: a slab that cools at both faces.
double cooling_root(int n, double biot);
/// Where a slab at 0 that melts between 0 and `width`, held at 1 at x = 0, has molten: x / (2 sqrt(t)), for a latent heat of c times 1 K.
double melting_front(double width);

/// Barenblatt's source of water, s_t = (s s_x)_x, in a bar from the time when its front stands at 0.15 m from the middle until it
/// stands at 0.3 m.
namespace source {
Bar bar(int cells);
double duration_s();
/// rms over the bar at the end, relative to the peak's.
double saturation_error(const Snapshot& end);
}  // namespace source

/// An elastic bar with free ends in its first mode: velocity `speed` cos(pi x) cos(pi t). The first sample is after a quarter of a period.
namespace first_mode {
inline constexpr double period_s = 2;
Bar bar(int cells, double speed);
/// What the velocity has of the mode's shape, as a share of `speed`: cos(pi t).
double share(const Snapshot& now, double speed);
}  // namespace first_mode

/// A ball of radius 1 m with rho c = 1 J/(m^3 K), at 1 C, in air at 0 C that takes 1 W/(m^2 K): Bi = 1 / `conductivity_W_per_mK`.
namespace ball_in_air {
inline constexpr Point centre{0.011, -0.017, 0.023};  ///< on no plane of the grid
StudyScene setting(double cells_in_radius, double conductivity_W_per_mK);
/// That of a ball of 1 W/(m K), where Bi = 1, at the distance r [m] from its centre after `time` [s]: theta = sum C exp(-z^2 t) sin(z r) /
/// (z r) over the roots of 1 - z cot z = 1, z = (n - 1/2) pi, with C = 4 (sin z - z cos z) / (2 z - sin 2 z).
double temperature(double r, double time);
}  // namespace ball_in_air

}  // namespace bake::studies

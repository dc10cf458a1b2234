// SPDX-License-Identifier: MIT
#include "tests/unit/boundary/sampling.h"

#include <numbers>

namespace bake {

std::vector<Sample> exact_shapes() {
  constexpr double pi = std::numbers::pi;
  const auto rounded = make<RoundedBox>([](RoundedBox& s) {
    s.centre_m = {0.01, 0, 0}, s.half_extents_m = {0.12, 0.08, 0.05}, s.radius_m = 0.03;
  });
  const auto capsule = make<Capsule>([](Capsule& s) { s.from_m = {-0.05, 0, 0}, s.to_m = {0.05, 0.03, 0.06}, s.radius_m = 0.04; });
  const double a = 0.09, b = 0.05, c = 0.02, r = 0.03;  // rounded box: its core, then faces, edges, corners
  const double rounded_volume = 8 * a * b * c + 8 * r * (a * b + b * c + c * a) + 2 * pi * r * r * (a + b + c) + 4 * pi / 3 * r * r * r;
  const double capsule_length = length({0.1, 0.03, 0.06}), cylinder_length = length({0.1, 0.03, 0.08});
  return {
      {"box", make_box({0.01, -0.02, 0}, {0.1, 0.05, 0.07}), {0.1, 0, 0.05}, {0.112, 0, 0}, 8 * 0.1 * 0.05 * 0.07},
      {"rounded_box", rounded, {0.1, 0.05, 0}, {0.125, 0.075, 0.045}, rounded_volume},
      {"sphere", make_sphere({0, 0.01, 0}, 0.1), {0.09, 0.01, 0}, {0.08, 0.08, 0.08}, 4 * pi / 3 * 1e-3},
      {"ellipsoid", make_ellipsoid({0, 0, 0.01}, {0.12, 0.05, 0.08}), {0.1, 0, 0}, {0.1, 0.04, 0.01}, 4 * pi / 3 * 0.12 * 0.05 * 0.08},
      {"spheroid", make_ellipsoid({0, 0, 0}, {0.1, 0.1, 0.03}), {0.09, 0, 0}, {0.09, 0, 0.02}, 4 * pi / 3 * 0.1 * 0.1 * 0.03},
      {"cylinder",
       make_cylinder({-0.05, 0.01, 0}, {0.05, 0.04, 0.08}, 0.06),
       {0, 0.02, 0.04},
       {0.05, 0.04, 0.15},
       pi * 0.06 * 0.06 * cylinder_length},
      {"capsule", capsule, {-0.07, 0, 0}, {-0.05, 0.05, 0}, pi * 0.04 * 0.04 * capsule_length + 4 * pi / 3 * 0.04 * 0.04 * 0.04},
      {"truncated cone",
       make_cone({0, 0, -0.05}, {0, 0.06, 0.03}, 0.09, 0.04),
       {0, 0.01, 0},
       {0.08, 0.05, 0.02},
       pi / 3 * 0.1 * (0.09 * 0.09 + 0.09 * 0.04 + 0.04 * 0.04)},
      {"cone", make_cone({0, 0, -0.05}, {0, 0, 0.07}, 0.1, 0), {0, 0, 0.06}, {0.06, 0, 0.03}, pi / 3 * 0.12 * 0.1 * 0.1},
  };
}

}  // namespace bake

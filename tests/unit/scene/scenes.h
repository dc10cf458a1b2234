// SPDX-License-Identifier: MIT
// Small scenes for the tests of the reader.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "solver/scene/reader.h"
#include "tests/support/temporary_folder.h"

namespace bake::test {

/// The least that a scene must say: 8 lines.
inline const std::string k_least = R"([run]
end_s = 2
[grid]
dx_m = 0.01
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 1]

)";

/// A scene with something of everything.
inline const std::string k_full = R"(title = "a full kitchen"
effects = ["leavening", "heat", "plasticity", "elasticity", "motion", "water"]
[run]
end_s = 3
frame_rate_per_s = 30
precision = "double"
[grid]
dx_m = 0.004
kernel = "cubic"
[domain]
min_m = [-1, -1, 0]
max_m = [1, 1, 1.5]
z_max = "open"
[time]
largest_step_s = 0.01
[oven]
temperature_C = [[0, 20], [60, 200]]
heat_transfer_coefficient_W_per_m2K = 25
[motion]
gravity_m_per_s2 = [0, 0, -1.62]
[heat]
integrator = "backward_euler"
[[material]]
name = "dough"
density_kg_per_m3 = 600
initial_saturation = 0.2
young_modulus_Pa = 1e5
specific_heat_J_per_kgK = 2800
conductivity_W_per_mK = 0.2
yield_stress_Pa = [200, 100, 50, 1000]
viscosity_Pa_s = 40
[[material]]
name = "chip"
density_kg_per_m3 = 1300
young_modulus_Pa = 1e6
specific_heat_J_per_kgK = 1600
conductivity_W_per_mK = 0.3
yield_stress_Pa = 500
[[body]]
material = "dough"
shape = { difference = [ { superellipsoid = { half_axes_m = [0.1, 0.05, 0.05] } }, { box = { half_extents_m = [1, 1, 1] }, move_m = [0, 0, -1] } ], rotate_deg = [0, 0, 90], scale = 2 }
temperature_C = 5
[[body]]
material = "chip"
particles_file = "chips/all.h5"
[[collider]]
name = "tray"
shape = { half_space = { normal = [0, 0, 1] } }
contact = "sticky"
temperature_C = [[0, 20], [30, 180]]
[[grip]]
name = "hand"
shape = { sphere = { centre_m = [0, 0, 0.5], radius_m = 0.05 } }
motion = [ { time_s = 0 }, { time_s = 1, position_m = [0, 0, 0.3], rotation_deg = [0, 0, 45] } ]
until_s = 2.5
[[emitter]]
name = "jug"
material = "dough"
shape = { union = [ { sphere = { radius_m = 0.02 } }, { capsule = { from_m = [0, 0, 0], to_m = [0, 0, 0.1], radius_m = 0.01 } } ] }
velocity_m_per_s = [0, 0, -0.5]
)";

inline Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "bread.toml", ReadOptions{Quality::paper, overrides});
}

/// The message with which the scene is refused, one line.
inline std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const std::string message = message_of<InputError>([&] { parse(text, overrides); });
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
  EXPECT_NE(message, "nothing was thrown") << text;
  return message;
}

/// `text` with the first `from` replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace bake::test

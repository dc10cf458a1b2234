// SPDX-License-Identifier: MIT
// One material with every effect, for its ParticleOfEverything.
#pragma once

#include "solver/effects/particle_of_everything.h"
#include "solver/scene/reader.h"

namespace bake {

/// One material in a box, with every effect; `material` and `tables` are added to it.
inline Scene scene_of_everything(const std::string& material, const std::string& tables = "") {
  return parse_scene(R"(
effects = ["motion", "heat", "water", "elasticity", "plasticity", "leavening"]
[run]
end_s = 1
[grid]
dx_m = 0.1
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 1]
)" + tables + R"(
[[material]]
name = "dough"
density_kg_per_m3 = 500
young_modulus_Pa = 2e3
specific_heat_J_per_kgK = 20
conductivity_W_per_mK = 100
)" + material,
                     "everything.toml", {});
}

}  // namespace bake

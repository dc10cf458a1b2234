// SPDX-License-Identifier: MIT
// One material with every effect, for its ParticleOfEverything.
#pragma once

#include "solver/effects/particle_of_everything.h"
#include "solver/scene/scene_builder.h"

namespace bake {

/// One material in a box, with every effect; `material` and `tables` are added to it.
inline Scene scene_of_everything(const std::string& material, const std::string& tables = "") {
  SceneBuilder builder;
  builder.effects = k_everything;
  builder.precision = "single";
  builder.gravity = "";
  builder.low = {0, 0, 0};
  builder.material =
      "density_kg_per_m3 = 500\nyoung_modulus_Pa = 2e3\nspecific_heat_J_per_kgK = 20\nconductivity_W_per_mK = 100\n" + material;
  builder.tables = tables;
  return builder.scene();
}

}  // namespace bake

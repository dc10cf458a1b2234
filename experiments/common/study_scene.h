// SPDX-License-Identifier: MIT
// What all scenes of the studies share: double precision, density 1 kg/m^3, the longest stable steps, no gravity unless told.
#pragma once

#include <memory>

#include "solver/effects/all_effects.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"

namespace bake::studies {

struct StudyScene : SceneBuilder {
  int threads = 1;  ///< most are too small to share
  explicit StudyScene(const std::string& listed = "heat") {
    effects = listed;
    time = "safety = 1";
    material = "density_kg_per_m3 = 1\n";
  }
  std::unique_ptr<Simulation> begin() const;
  std::unique_ptr<Simulation> after(double time) const;  ///< begun, and stepped until then
};

/// Steps until `time`, at which everything is sampled. Throws RunError.
void run_to(Simulation& simulation, double time);

}  // namespace bake::studies

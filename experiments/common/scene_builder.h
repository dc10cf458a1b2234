// SPDX-License-Identifier: MIT
// Builds the scenes of the studies. They have double precision, a density of 1 kg/m^3 and, by default, no gravity.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/core/vector3.h"
#include "solver/effects/all_effects.h"
#include "solver/run/simulation.h"

namespace bake::studies {

struct SceneBuilder {
  std::string effects = "\"heat\"";  ///< in quotes, with commas
  double end_s = 1;                  ///< the first sample
  double dx = 0.1;
  std::string kernel = "quadratic";
  Vector3 low{-1, -1, -1}, high{1, 1, 1};  ///< of the domain [m]
  std::string faces;                       ///< keys of [domain] besides its corners
  std::string surface;                     ///< keys of [surface]
  std::string time = "safety = 1";         ///< keys of [time]
  std::string motion = "gravity_m_per_s2 = [0, 0, 0]";
  std::string material;                ///< keys of the material "dough" besides its density
  std::string tables;                  ///< further tables, the bodies among them
  int threads = 1;                     ///< most of these scenes are too small for several threads
  std::vector<std::string> overrides;  ///< `key=value`, as for parse_scene

  Scene scene() const;
  std::unique_ptr<Simulation> begin() const;
};

/// Takes steps until `time`, at which all quantities are sampled. Throws RunError.
void run_to(Simulation& simulation, double time);

}  // namespace bake::studies

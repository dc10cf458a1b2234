// SPDX-License-Identifier: MIT
// The scenes that ./bake bench, ./bake count and the study of effects time.
#pragma once

#include <string>
#include <vector>

#include "solver/run/simulation.h"
#include "solver/scene/settings.h"

namespace bake::bench {

/// A combination of effects: one line of solver/engine/model_list.h.
struct Combination {
  std::string name;
  std::vector<std::string> effects;
  bool flip = false;
};

inline const std::vector<Combination> k_combinations = {
    {"heat", {"heat"}},
    {"water", {"water"}},
    {"heat+water", {"heat", "water"}},
    {"elastic", {"motion", "elasticity"}},
    {"elastic+heat", {"motion", "elasticity", "heat"}},
    {"elastic+water", {"motion", "elasticity", "water"}},
    {"elastic+heat+water", {"motion", "elasticity", "heat", "water"}},
    {"plastic", {"motion", "elasticity", "plasticity"}},
    {"plastic+heat", {"motion", "elasticity", "plasticity", "heat"}},
    {"plastic+water", {"motion", "elasticity", "plasticity", "water"}},
    {"plastic+heat+water", {"motion", "elasticity", "plasticity", "heat", "water"}},
    {"plastic+heat+leavening", {"motion", "elasticity", "plasticity", "heat", "leavening"}},
    {"all", {"motion", "elasticity", "plasticity", "heat", "water", "leavening"}},
    {"elastic/flip", {"motion", "elasticity"}, true},
    {"plastic/flip", {"motion", "elasticity", "plasticity"}, true},
    {"all/flip", {"motion", "elasticity", "plasticity", "heat", "water", "leavening"}, true},
};

/// A warm loaf on a tray in a hot oven, with about the given number of particles, seven per cell.
Scene loaf(const Combination& combination, Precision precision, double particles);

/// An elastic cube without gravity, with the given number of cells per side and eight particles per cell at quarter offsets.
Scene elastic_block(Precision precision, int cells);

/// A grape of 28 thousand particles that dries, bare or in a skin of 7 thousand triangles: 0.26 a particle, as in the paper's heap of
/// grapes (96 to 346 thousand).
Scene grape(Precision precision, bool in_skin);

/// Takes so many steps, of which none is shortened to hit a time.
inline void take_steps(Simulation& simulation, int steps) {
  constexpr double never = 1e6;  // [s]
  simulation.advance(never, never, [&] { return --steps > 0; });
}

}  // namespace bake::bench

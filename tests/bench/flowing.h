// SPDX-License-Identifier: MIT
#pragma once

#include "solver/run/simulation.h"

namespace bake::bench {

/// Share of the particles that flow: viscous return leaves them outside their yield surface. For scenes of one material with
/// plasticity; 0 without.
double flowing_share(const Simulation& simulation, const Scene& scene);

}  // namespace bake::bench

// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/make/computed.h"

namespace bake {

/// Figure 7: the yield surface for several porosities, as the solver's return mapping without viscosity finds it.
Computed fig07_yield_surface();

}  // namespace bake

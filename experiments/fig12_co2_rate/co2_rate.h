// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/make/computed.h"

namespace bake {

/// Figure 12: rate of the leavening against temperature, and the gas that the solver makes of it in a block that is warmed.
Computed fig12_co2_rate();

}  // namespace bake

// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/make/computed.h"

namespace bake {

/// Figure 14: trial stresses and their images, without and with viscosity, without and with pores.
Computed fig14_return_map();

}  // namespace bake

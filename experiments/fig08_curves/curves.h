// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/make/computed.h"

namespace bake {

/// Figure 8: yield stress and viscosity against temperature, on the way up and, past gelatinisation, on the way down.
Computed fig08_curves();

}  // namespace bake

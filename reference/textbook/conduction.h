// SPDX-License-Identifier: MIT
// Backward Euler for conduction.   [Ding19 Sec. 6.3, gamma = 1]
#pragma once

#include <vector>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"

namespace bake::textbook {

/// Solves (H + dt K) theta' = H theta* for the nodes' temperatures: theta* is what update_heat left, H their heat per degree,
/// K = sum_p V kappa grad w (grad w)^T. Nodes whose temperature is held keep it. Conjugate gradients to the last digit.
void conduct_implicitly(const std::vector<Particle>&, double dt, Grid&);

}  // namespace bake::textbook

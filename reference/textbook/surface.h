// SPDX-License-Identifier: MIT
// The surface of the dough, and what is on its other side.
#pragma once

#include <vector>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"

namespace bake::textbook {

/// Fills area, heat_transfer and heat_transfer_source of every node from the volumes V_i:
///     phi_i = V_i / dx^3;  phi~ = B phi                        B: (1, 2, 1)/4 along each axis
///     psi_i = clamp((phi~_i - 0.2) / 0.6, 0, 1)
///     r_i   = |grad psi|_i / phi~_i                            differences over two nodes, (1, 6, 1)/8 across
///     A_i   = V_i (B r)_i
/// DEPARTS [Ding19 Sec. 6.6]: the printed measure (below) does not converge.
void measure_surface(const Surroundings&, Grid&);

/// As printed: every node with volume that has a neighbour without marks the particle nearest to it, and a marked particle
/// stands for a disc S = pi r^2 of the sphere (4/3) pi r^3 = V.   [Ding19 Sec. 6.6]
void measure_published_surface(const std::vector<Particle>&, const Surroundings&, Grid&);

}  // namespace bake::textbook

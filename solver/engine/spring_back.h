// SPDX-License-Identifier: MIT
// How fast dough springs back when all of it is strained alike. Inside of dough neighbours hold each other; a particle alone, a crumb, a
// thread or a corner has nodes of its own to push, and vibrates faster than waves cross a cell.
//
//     a_i = sum_p V_0 K D^-1 w r / sum_p w m;   omega_p^2 = tr C(a) = D^-1 sum_i w r . a_i
//
// which is 3 K / (rho D) for a particle alone, as it should be, and was within 0.77 and 1.4 of the largest eigenvalue for crumbs of one to
// eight particles at any distance from other dough, clumps, threads, sheets, balls and cubes, where that is above what dough has inside.
#pragma once

#include <vector>

#include "solver/engine/block_colours.h"
#include "solver/engine/block_kernel.h"

namespace bake {

/// The largest omega_p^2 of all particles [1/s^2]; 0 without any. About as dear as a step without the effects; same bits for any number of
/// threads. `blocks`: of the grid.
template <class Real>
double spring_back(KernelOrder order, const ParticleStore<Real>& store, const Physics<Real>& physics, double dx,
                   const std::vector<BlockColumns>& colours, std::size_t blocks);

}  // namespace bake

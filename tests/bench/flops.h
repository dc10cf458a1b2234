// SPDX-License-Identifier: MIT
// Useful floating-point operations of a particle in a step, a multiply-add being two, anything else one; and the bytes that memory
// must move for it at least.
//
// Transfers, from their formulas, for the quadratic kernel (27 nodes):
//   gather a channel    sums of w n and of o w n along z (27 products, 27 sums), then y (18 and 15), then x (9 and 7),
//                       and three gradients of three operations                                             = 112
//   scatter a channel   27 multiply-adds                                                                    =  54
//   with moments        the same, 6 operations that make a', 26 sums that make a' + j B_x + k B_y + l B_z   =  86
//   weights             before the particle has moved; after, with 36 products                              =  50 and 86
// The law, from the machine code (g++ 12, AVX-512, single precision) of Model::advance: the packed operations of a tile, each counted
// once (so is Newton's iteration, which dough as viscous as the benchmarks' needs once); as differences of models that differ in one
// effect.
// The double precision's longer series are not counted as useful.
//
// Bytes: what would have to move if the caches held nothing from one step to the next and everything within a step. A particle's
// columns are read and written once. A node's scattered row is read and cleared by the grid update, then read and written by the scatter;
// its gathered row is written by the update and read by the gather. What a block's neighbours read again is taken to come from the caches.
#pragma once

#include "solver/engine/block_kernel.h"
#include "solver/engine/physics.h"
#include "solver/scene/scene.h"

namespace bake::bench {

template <class Real>
double gather_flops(const Physics<Real>& physics) {
  return 112 * physics.gather_channels + 50;
}

template <class Real>
double scatter_flops(const Physics<Real>& physics) {
  return 54 * (physics.scatter_channels - physics.moment_channels) + 86 * physics.moment_channels + 86;
}

inline double law_flops(const Scene& scene) {
  const bool moves = scene.lists("motion");
  double flops = 0;
  if (moves) flops += 650;  // with elasticity
  if (scene.lists("plasticity")) flops += 595;
  if (scene.lists("heat")) flops += moves ? 46 : 32;
  if (scene.lists("water")) flops += moves ? 118 : 46;
  if (scene.lists("leavening")) flops += 75;
  return flops;
}

template <class Real>
double flops_per_particle_step(const Physics<Real>& physics, const Scene& scene) {
  return gather_flops(physics) + scatter_flops(physics) + law_flops(scene);
}

/// Of a polynomial of a symmetric matrix with so many terms (solver/core/symmetric.h): its square 30, invariants 27, six a term of
/// Horner's scheme but the first, the sum 26, the norm that is looked at 12.
constexpr double polynomial_flops(int terms) { return 30 + 27 + 6 * (terms - 1) + 26 + 12; }

template <class Real>
double bytes_moved_per_node(const BlockKernel<Real>& kernel) {
  return static_cast<double>(sizeof(Real)) * (4 * kernel.scattered_row() + 2 * kernel.gathered_row());
}

}  // namespace bake::bench

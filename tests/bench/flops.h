// SPDX-License-Identifier: MIT
// Useful floating-point operations of a particle in a step: a multiply-add is two, anything else one.
//
// Transfers, from their formulas, for the quadratic kernel (27 nodes):
//   gather a channel    value and three derivatives, z then y then x: (54 + 27 + 12) multiply-adds          = 186
//   scatter a channel   27 multiply-adds with 9 products of weights                                         =  63
//   with moments        the same, 18 more multiply-adds and 17 operations that make a' + j B_x + k B_y      = 116
//   weights             before and after the particle has moved                                             = 100
// The law, from the machine code (g++ 12, AVX-512, single precision) of Model::advance: the packed operations of a tile, each counted
// once but the body of Newton's iteration three times, as differences of models that differ in one effect.
// The double precision's longer series are not counted as useful.
#pragma once

#include "solver/effects/physics.h"

namespace bake::bench {

template <class Real>
double flops_per_particle_step(const Physics<Real>& physics, const Scene& scene) {
  constexpr double gather = 186, scatter = 63, scatter_moments = 116, weights = 100;
  const int plain = physics.scatter_channels - physics.moment_channels;
  double flops = gather * physics.gather_channels + scatter * plain + scatter_moments * physics.moment_channels + weights;
  const bool moves = scene.lists("motion");
  if (moves) flops += 650;  // with elasticity
  if (scene.lists("plasticity")) flops += 630;
  if (scene.lists("heat")) flops += moves ? 46 : 32;
  if (scene.lists("water")) flops += moves ? 118 : 46;
  if (scene.lists("leavening")) flops += 75;
  return flops;
}

}  // namespace bake::bench

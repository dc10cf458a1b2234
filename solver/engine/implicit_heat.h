// SPDX-License-Identifier: MIT
// Backward Euler for heat conduction: (H + dt K) theta = H theta*, by conjugate gradients on the grid.
//
// theta* is what the explicit node update leaves (content, heat transfer, expansion, latent heat), H the nodes' heat per degree with
// the heat transfer in it, K = sum_p V kappa D^-1 w r (D^-1 w r)^T conduction, applied by one pass over the particles. [Ding19 Sec. 6.3,
// gamma = 1]
#pragma once

#include <vector>

#include "solver/engine/block_kernel.h"

namespace bake {

template <class Real>
class ImplicitHeat {
 public:
  /// Corrects the temperature (and its change, one channel before) in the gathered rows of `grid`. Nodes of weight 0 keep
  /// their temperature; `heat_transfer`: of the nodes with their surroundings [W/K]. Returns the heat that the correction brings in through
  /// surfaces and held nodes [J].
  double solve(const BlockKernel<Real>& kernel, BlockWork<Real> work, const std::vector<BlockColumns>& colours,
               std::vector<Scratch<Real>>& scratch, const std::vector<Real>& weight, const std::vector<Real>& heat_transfer,
               int temperature_channel, double dt, double tolerance, AlignedBuffer<Real>& grid);

 private:
  AlignedBuffer<Real> in_, out_;
  std::vector<Real> x_, r_, p_, Kp_;
};

extern template class ImplicitHeat<float>;
extern template class ImplicitHeat<double>;

}  // namespace bake

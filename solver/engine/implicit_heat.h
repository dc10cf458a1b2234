// SPDX-License-Identifier: MIT
// Backward Euler for heat conduction: (H + dt K) theta = H theta*, by conjugate gradients on the grid.
//
// theta* is what the explicit node update leaves (content, heat transfer, expansion, latent heat), H the nodes' heat per degree with
// the heat transfer in it, K theta = sum_p V kappa D^-1 w r (D^-1 w r)^T theta conduction (conduction.h). [Ding19 Sec. 6.3, gamma = 1]
#pragma once

#include <vector>

#include "solver/engine/block_colours.h"
#include "solver/engine/block_kernel.h"

namespace bake {

template <class Real>
class ImplicitHeat {
 public:
  explicit ImplicitHeat(KernelOrder order) : order_(order) {}

  /// Corrects the temperature, channel Physics::temperature_channel, and its change, one channel before, in the gathered rows of `grid`,
  /// which have `row` numbers. `weight`: H of the nodes [J/K], those of weight 0 keep their temperature; `heat_transfer`: of the nodes
  /// with their surroundings [W/K]. Stops at the relative residual Physics::heat_tolerance, or where round-off ends. The heat that
  /// nodes gain is what was conducted to them, whatever the residual. Returns the heat that the correction brings in through surfaces
  /// and held nodes [J].
  double solve(const BlockWork<Real>& work, const std::vector<BlockColumns>& colours, const std::vector<Real>& weight,
               const std::vector<Real>& heat_transfer, double dt, std::size_t row, Real* grid);

 private:
  /// K_ = K theta.
  void conduct(const BlockWork<Real>& work, const std::vector<BlockColumns>& colours, const std::vector<Real>& theta);
  /// Sums visit(first node) over the blocks of 64 nodes, in their order: same bits for any number of threads.
  template <class Visit>
  double sum_over_blocks(Visit visit);

  KernelOrder order_;
  std::vector<Real> theta_, r_, z_, p_, d_, K_;
  std::vector<double> parts_;
};

extern template class ImplicitHeat<float>;
extern template class ImplicitHeat<double>;

}  // namespace bake

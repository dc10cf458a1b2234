// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "solver/engine/block_kernel_instances.h"

namespace bake {

template <class Real>
std::unique_ptr<BlockKernel<Real>> make_block_kernel(KernelOrder order, const Physics<Real>& physics) {
  const int scattered = physics.scatter_channels, gathered = physics.gather_channels;
  if (physics.moment_channels > k_most_moments) throw std::logic_error("a model with more moments than a row holds");
  const auto rows = [&]<KernelOrder o>() -> std::unique_ptr<BlockKernel<Real>> {
    if (scattered <= 4 && gathered <= 4) return make_block_kernel_4_4<Real, o>();
    if (scattered <= 8 && gathered <= 8) return make_block_kernel_8_8<Real, o>();
    if (scattered <= 16 && gathered <= 8) return make_block_kernel_16_8<Real, o>();
    if (scattered <= 16 && gathered <= 16) return make_block_kernel_16_16<Real, o>();
    if (scattered <= 32 && gathered <= 16) return make_block_kernel_32_16<Real, o>();
    throw std::logic_error("a model with more channels than a row holds");
  };
  return order == KernelOrder::quadratic ? rows.template operator()<KernelOrder::quadratic>()
                                         : rows.template operator()<KernelOrder::cubic>();
}

template std::unique_ptr<BlockKernel<float>> make_block_kernel(KernelOrder, const Physics<float>&);
template std::unique_ptr<BlockKernel<double>> make_block_kernel(KernelOrder, const Physics<double>&);

}  // namespace bake

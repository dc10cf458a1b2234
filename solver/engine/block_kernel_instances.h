// SPDX-License-Identifier: MIT
// One function per row size, each compiled in a file of its own (solver/CMakeLists.txt) so that they build side by side.
#pragma once

#include <memory>

#include "solver/engine/block_kernel.h"

namespace bake {

template <class Real, KernelOrder order>
std::unique_ptr<BlockKernel<Real>> make_block_kernel_4_4();
template <class Real, KernelOrder order>
std::unique_ptr<BlockKernel<Real>> make_block_kernel_8_8();
template <class Real, KernelOrder order>
std::unique_ptr<BlockKernel<Real>> make_block_kernel_16_8();
template <class Real, KernelOrder order>
std::unique_ptr<BlockKernel<Real>> make_block_kernel_16_16();
template <class Real, KernelOrder order>
std::unique_ptr<BlockKernel<Real>> make_block_kernel_32_16();

}  // namespace bake

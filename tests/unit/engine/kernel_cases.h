// SPDX-License-Identifier: MIT
// Kernels of either order in either precision, as types of a typed test.
#pragma once

#include <gtest/gtest.h>

#include "solver/grid/kernel.h"

namespace bake {

template <class Scalar, KernelOrder k_order>
struct KernelCase {
  using Real = Scalar;
  static constexpr KernelOrder order = k_order;
};

using KernelCases = testing::Types<KernelCase<float, KernelOrder::quadratic>, KernelCase<float, KernelOrder::cubic>,
                                   KernelCase<double, KernelOrder::quadratic>, KernelCase<double, KernelOrder::cubic>>;

}  // namespace bake

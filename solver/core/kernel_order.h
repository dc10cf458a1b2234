// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace bake {

/// The degree of the B-spline that couples particles and nodes.
enum class KernelOrder { quadratic, cubic };
constexpr auto choice_names(KernelOrder) { return std::array{"quadratic", "cubic"}; }

}  // namespace bake

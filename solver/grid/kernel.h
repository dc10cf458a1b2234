// SPDX-License-Identifier: MIT
// The B-spline weights of W particles (lanes) on each axis.
//
// Positions are measured in node distances from the block's first node. `base` is the first node of the stencil,
// `offset` the distance from the reference node base + 1, in which the nodes of the stencil stand at the integers
// o_j = j - 1. Gradients are taken in the moment form of Hu et al. 2018: grad N_i(x_p) is replaced by
// D^-1 w_ip (x_i - x_p), D = dx^2/4 (quadratic) or dx^2/3 (cubic): linear fields are exact, and the same C advances
// positions and strains.
#pragma once

#include "solver/core/kernel_order.h"
#include "solver/core/lanes.h"

namespace bake {

template <KernelOrder>
struct Kernel;

template <>
struct Kernel<KernelOrder::quadratic> {
  static constexpr int support = 3;
  static constexpr int inverse_d = 4;  ///< D^-1 dx^2
  static constexpr double base_shift = 0.5;
  /// The bases with which a stencil stays inside the 8x8x8 tile of nodes -1..6 around a block.
  static constexpr int lowest_base = -1, highest_base = 4;

  template <class Real>
  BAKE_INLINE static void weights(Lanes<Real> f, Lanes<Real>* w) {
    const Lanes<Real> low = Real(0.5) - f, high = Real(0.5) + f;
    w[0] = Real(0.5) * low * low;
    w[1] = Real(0.75) - f * f;
    w[2] = Real(0.5) * high * high;
  }
};

template <>
struct Kernel<KernelOrder::cubic> {
  static constexpr int support = 4;
  static constexpr int inverse_d = 3;
  static constexpr double base_shift = 1;
  static constexpr int lowest_base = -1, highest_base = 3;

  template <class Real>
  BAKE_INLINE static void weights(Lanes<Real> f, Lanes<Real>* w) {
    const Lanes<Real> g = 1 - f;
    w[0] = Real(1. / 6) * g * g * g;
    w[3] = Real(1. / 6) * f * f * f;
    // The inner two, 2/3 - f^2 + f^3/2 and its mirror image, from sum w = 1 and sum o w = f: whatever the rounding of 1/6, which is the
    // same in every step, a uniform velocity stays what it is. With a rounded 2/3 the sum of the weights would be too large for ever.
    w[1] = g + w[3] - 2 * w[0];
    w[2] = f + w[0] - 2 * w[3];
  }
};

/// The stencils of W particles.
template <class Real, KernelOrder order>
struct Stencil {
  using V = Lanes<Real>;
  using K = Kernel<order>;
  V base[3];    ///< first node per axis, as a whole number
  V offset[3];  ///< x - (base + 1), in node distances
  V weight[3][K::support];

  /// `x`: positions in node distances from the block's first node.
  BAKE_INLINE explicit Stencil(const V (&x)[3]) {
    constexpr Real k_lift = 8;  // positive, so that truncation rounds down
    for (int d = 0; d < 3; ++d) {
      const V lifted = x[d] + Real(k_lift - K::base_shift);
      base[d] = __builtin_convertvector(__builtin_convertvector(lifted, LaneMask<Real>), V) - k_lift;
      offset[d] = x[d] - base[d] - 1;
      K::template weights<Real>(offset[d], weight[d]);
    }
  }

  /// Lanes whose stencil leaves the block's tile (or whose position is not a number).
  BAKE_INLINE LaneMask<Real> outside() const {
    LaneMask<Real> out = LaneMask<Real>{};
    for (int d = 0; d < 3; ++d) out |= ~((base[d] >= lanes<Real>(K::lowest_base)) & (base[d] <= lanes<Real>(K::highest_base)));
    return out;
  }
};

}  // namespace bake

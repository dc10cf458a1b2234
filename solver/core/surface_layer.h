// SPDX-License-Identifier: MIT
#pragma once

#include "solver/core/lanes.h"

namespace bake {

/// The layer between a surface and the nodes that fluxes through it are taken at, which resists them: beta becomes beta / (1 + beta d /
/// kappa). With K = sum V kappa grad w grad w^T, b_i = sum V grad w_i . n and a steady flux q that enters by areas A_i, the nodes have
/// theta = q x / kappa + e, K e = q (A - b), for K x = kappa b, and the sum of b_i x_i lies at the surface. Taken with A, theta is that of
/// a depth
///     d = 2 d_A - kappa (A - b)^T K^-1 (A - b),
/// d_A = 0.51 dx being the depth of the areas' centroid, and 0.25 dx the second term. A strong flux bends theta between the nodes that it
/// enters by: d grows to 0.94 dx as beta dx / kappa does. Over all offsets and fillings it varies by 0.04 dx (quadratic, cubic alike).
template <class Real>
struct SurfaceLayer {
  Real dx = 0;     ///< [m]; 0: nothing resists
  Real least = 0;  ///< d / dx of a weak flux

  /// d / dx. `strength`: 0 to 1, b / (1 + b) with b = beta dx / kappa.
  template <class V>
  BAKE_INLINE V depth(V strength) const {
    return least + Real(0.18) * strength;
  }
  /// kappa / d, what the layer alone conducts under a surface whose temperature is held [W/(m^2 K)], with `conductivity` V kappa.
  Real conductance(Real conductivity, Real volume) const { return conductivity / (volume * dx * depth(Real(1))); }
  /// 1 / (1 + beta d / kappa), with `conductance` V beta and `conductivity` V kappa.
  Real share_that_passes(Real conductance, Real conductivity) const {
    const Real h = conductance * dx, passes = conductivity / (conductivity + h * depth(h / (conductivity + h)));
    return h > 0 ? passes : Real(1);
  }
};

}  // namespace bake

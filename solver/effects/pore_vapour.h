// SPDX-License-Identifier: MIT
// Vapour over the water of dough, in its pores. [not in Ding19; Philip and de Vries 1957]
#pragma once

#include <limits>
#include <type_traits>

#include "solver/core/surface_layer.h"
#include "solver/effects/fields.h"

namespace bake::pore_vapour {

// rho_sat = p_sat M / (R theta_K) = e^(k_first - k_slope / (theta + k_shift)) / theta_K by Antoine's equation, log10(p_sat / mmHg)
// = 8.07131 - 1730.63 / (233.426 + theta), with M = 0.018015 kg/mol: within 0.5 % from 1 to 120 C.
inline constexpr double k_first = 17.343156726379224, k_slope = 3984.9228394882853, k_shift = 233.426;

/// Density of vapour over water at theta [C], in kg/m^3. Below 0 C, where water does not move, that of 0 C.
template <class V>
BAKE_INLINE V saturated(V theta) {
  using Real = std::decay_t<decltype(theta[0])>;
  const V warm = max(theta, 0 * theta);
  return exp(Real(k_first) - Real(k_slope) / (warm + Real(k_shift))) / (warm + Real(273.15));
}

/// d ln rho_sat / d theta [1/K]; 0 below 0 C.
template <class V>
BAKE_INLINE V saturated_slope(V theta) {
  using Real = std::decay_t<decltype(theta[0])>;
  const V none = 0 * theta, from = theta + Real(k_shift);
  return theta > none ? Real(k_slope) / (from * from) - 1 / (theta + Real(273.15)) : none;
}

/// a_w = X^3 / (X^3 + X_h^3): Oswin's isotherm X = X_h (a_w / (1 - a_w))^(1/3), the exponent being that of wheat (1 / 3.08). Wet dough has
/// nearly 1, and as dough dries below X_h it falls to 0. `water` and `hygroscopic`: m_w and m_s X_h [kg], the first of them at least 0.
template <class V>
BAKE_INLINE V activity(V water, V hygroscopic) {
  using Real = std::decay_t<decltype(water[0])>;
  const V dryness = hygroscopic / max(water, 0 * water + std::numeric_limits<Real>::min());
  return 1 / (1 + dryness * dryness * dryness);
}

/// Vapour that leaves the surface per area [kg/(m^2 s)], before the step: h_v rho_v of the node, resisted by the layer of depth d between
/// the nodes and the surface, which conducts vapour as it does heat: h_v rho_v / (1 + h_v d / (n D_v)).
template <class Node, class Real>
BAKE_INLINE auto through_surface(const Node& node, const SurfaceLayer<Real>& layer) {
  const auto& mobility = node[channel::vapour_mobility];
  const auto& transfer = node[channel::vapour_transfer];
  const auto& volume = node[channel::volume];
  const auto density = activity(node[channel::water_mass], node[channel::hygroscopic_water]) *
                       saturated(node[channel::heat_content] / node[channel::heat_capacity]);
  const auto h = layer.dx * transfer, none = 0 * h;
  const auto passes = mobility / (mobility + h * layer.depth(h / (mobility + h)));
  return ((transfer > none) & (volume > none)) ? passes * density * transfer / volume : none;
}

}  // namespace bake::pore_vapour

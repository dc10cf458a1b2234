// SPDX-License-Identifier: MIT
// Vapour in the pores, which evaporates where it is hot and condenses where it is cold.   [not in Ding19]
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"

namespace bake::textbook {

/// rho_sat = p_sat M / (R theta_K), p_sat in mmHg by Antoine's equation; below 0 C that of 0 C.
inline double saturated_vapour(double theta) {
  const double warm = std::max(theta, 0.0);
  const double pressure = 133.322368 * std::pow(10, 8.07131 - 1730.63 / (233.426 + warm));
  return pressure * 0.018015 / (k_gas_constant * (warm + k_zero_celsius));
}

/// rho_v = a_w rho_sat, a_w = X^3 / (X^3 + X_h^3) with X = m_w / m_s. `water`, `hygroscopic`: m_w and m_s X_h.
inline double vapour_over(double water, double hygroscopic, double theta) {
  return water > 0 ? saturated_vapour(theta) / (1 + std::pow(hygroscopic / water, 3)) : 0;
}

/// n D_v, n = 1 - (1 - n_0) / J: the solid keeps its volume.
inline double vapour_mobility(const Particle& p, const Material& m) { return m.D_v * std::max(1 - (1 - m.initial_porosity) / p.J, 0.0); }

/// What evaporation and the pores' vapour need.
inline void scatter_vapour(const Particle& p, const Material& m, const Overlap& o, Node& node) {
  node.hygroscopic_water += o.w * m.X_h * p.m_s;
  node.vapour_mobility += o.w * p.V() * vapour_mobility(p, m);
  node.vapour_transfer += o.w * p.V() * m.h_v;
}

/// + dt L_v V j_v . grad w; alpha_w theta j_v is a part of what the water carries, q.
inline void scatter_latent_heat(const Particle& p, const Recipe& recipe, double dt, const Overlap& o, Node& node) {
  node.heat_change += dt * recipe.latent_heat * p.V() * dot(p.j_v, o.grad_w);
}

/// h_v rho_v of the node before the step, less what the layer of depth d below the surface resists: h_v / (1 + h_v d / (n D_v)).
inline double vapour_through_surface(const Recipe& recipe, const Node& node) {
  if (!(node.vapour_transfer > 0)) return 0;
  const double h = node.vapour_transfer / node.volume, D = node.vapour_mobility / node.volume;
  const double d = recipe.surface_form == Form::standard ? layer_depth(recipe, recipe.dx * h / (D + recipe.dx * h)) : 0;
  return vapour_over(node.water, node.hygroscopic_water, node.heat_content / node.heat_capacity) * h / (1 + h * d / D);
}

inline void update_vapour(Node& node) {
  node.vapour_density = vapour_over(node.water + node.moved_water, node.hygroscopic_water, node.theta);
}

/// What a particle sees of the nodes' vapour.
struct SeenVapour {
  Vector grad_density;  ///< [kg/m^4]
  void add(const Node& node, const Overlap& o) { grad_density += node.vapour_density * o.grad_w; }
};

/// j_v = - n D_v grad rho_v
inline void take_vapour(const SeenVapour& seen, const Material& m, Particle& p) { p.j_v = (-vapour_mobility(p, m)) * seen.grad_density; }

}  // namespace bake::textbook

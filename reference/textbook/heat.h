// SPDX-License-Identifier: MIT
// Heat: conduction, heat transfer at the surface, expansion, and what moving water carries.   [Ding19 Sec. 4, 6.3]
#pragma once

#include <algorithm>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"

namespace bake::textbook {

/// c = alpha_s m_s + alpha_w m_w
/// DEPARTS [Ding19 Sec. 6.3]: printed with the solid's mass only.
inline double heat_capacity(const Particle& p, const Recipe& recipe, const Material& m) {
  return m.alpha_s * p.m_s + recipe.alpha_w * p.m_w;
}

/// beta_T = 3 K alpha_l: thermal stress per degree [Pa/K]
inline double thermal_stress_per_degree(const Recipe& recipe, const Material& m) {
  return recipe.elasticity ? 3 * m.bulk() * m.alpha_l : 0;
}

/// c_i = sum w c;  c_i theta_i = sum w c theta   [Ding19 Eq. 17]
inline void scatter_heat(const Particle& p, const Recipe& recipe, const Material& m, const Overlap& o, Node& node) {
  node.heat_capacity += o.w * heat_capacity(p, recipe, m);
  node.heat_content += o.w * heat_capacity(p, recipe, m) * p.theta;
  // what subgrid diffusion gave in the last step is taken back
  node.heat_change -= o.w * (heat_capacity(p, recipe, m) * p.theta_lent + recipe.alpha_w * p.m_w_lent * (p.theta - p.theta_lent));
  node.conductivity += o.w * m.kappa * p.V();
}

/// - dt V kappa grad theta . grad w
/// DEPARTS [Ding19 Sec. 6.3]: printed without kappa and with the wrong sign.
inline void scatter_conduction(const Particle& p, const Material& m, double dt, const Overlap& o, Node& node) {
  node.heat_change -= dt * p.V() * m.kappa * dot(p.grad_theta, o.grad_w);
}

/// - dt w V_0 beta_T theta_K d(tr epsilon)/dt: the heat that elastic expansion takes; as printed, with div v.
inline void scatter_expansion(const Particle& p, const Recipe& recipe, const Material& m, double dt, const Overlap& o, Node& node) {
  const double theta = recipe.expansion_form == Form::published ? p.theta : p.theta + k_zero_celsius;
  node.heat_change -= dt * o.w * p.V_0 * thermal_stress_per_degree(recipe, m) * theta *
                      (recipe.expansion_form == Form::published ? p.div_v() : p.div_v() - p.dilation);
}

/// + dt alpha_w theta V q . grad w: water brings its heat with it; what the printed div v term of (25) takes away, takes it along.
/// DEPARTS [Ding19 Eq. 9]: printed for the mixture's own motion; relative to the solid, moving water carries heat.
inline void scatter_carried_heat(const Particle& p, const Recipe& recipe, double dt, const Overlap& o, Node& node) {
  node.heat_change += dt * recipe.alpha_w * p.theta * p.V() * dot(p.q, o.grad_w);
  if (recipe.motion && recipe.water_form == Form::published) node.heat_change -= dt * o.w * recipe.alpha_w * p.theta * p.m_w * p.div_v();
}

/// theta_i' = (content + change - latent + dt A beta theta_out) / (c_i' + dt A beta): the transfer is implicit at the node. c_i' knows
/// of the water that came or went; vapour leaves after the step with theta_i'.
/// DEPARTS [Ding19 Sec. 4, 6.3]: as printed the flux is beta (theta - theta_out), and a hot body heats itself.
inline void update_heat(const Recipe& recipe, double dt, Node& node) {
  if (!(node.heat_capacity > 0)) return;
  const double old = node.heat_content / node.heat_capacity;
  const double capacity = node.heat_capacity + recipe.alpha_w * (node.moved_water + node.evaporated);
  const double content = node.heat_content + node.heat_change - recipe.latent_heat * node.evaporated;
  if (recipe.heat_transfer_form == Form::published)
    node.theta = (content + dt * (node.heat_transfer * old - node.heat_transfer_source)) / capacity;
  else
    node.theta = (content + dt * node.heat_transfer_source) / (capacity + dt * node.heat_transfer);
  node.heat_weight = capacity + dt * node.heat_transfer;
  node.theta_change = node.theta - old;
  if (node.held) {  // and so are the particles inside of the grip
    node.theta = *node.held;
    node.heat_weight = 0;
    node.theta_change = 0;
  }
}

/// What a particle sees of the nodes' temperatures.
struct SeenHeat {
  double change = 0, theta = 0;  ///< [K], [C]
  Vector grad_theta;             ///< [C/m]

  void add(const Node& node, const Overlap& o) {
    change += o.w * node.theta_change;
    theta += o.w * node.theta;
    grad_theta += node.theta * o.grad_w;
  }
};

/// Of a difference between a particle and its nodes, the share that goes in a step: x / (1 + x), x = rate dt diffusivity / dx^2.
inline double evened_out(double rate, double diffusivity, double dt, double dx) {
  const double x = rate * dt * diffusivity / (dx * dx);
  return x / (1 + x);
}

/// Heat of melting or setting that a particle of this temperature holds [J].
inline double latent_heat(double theta, const Particle& p, const Material& m) {
  return m.transition_heat * p.m_s * std::clamp((theta - m.transition_from) / (m.transition_to - m.transition_from), 0.0, 1.0);
}

/// The temperature at which c theta and latent heat together are `heat`, which rises with it: by bisection.
inline double temperature_of(double heat, double capacity, const Particle& p, const Material& m) {
  double low = (heat - m.transition_heat * p.m_s) / capacity, high = heat / capacity;
  for (;;) {
    const double middle = low + 0.5 * (high - low);
    if (middle <= low || middle >= high) return middle;
    (capacity * middle + latent_heat(middle, p, m) < heat ? low : high) = middle;
  }
}

/// theta += sum w (theta_i' - theta_i)   [Ding19 Eq. 21], then subgrid diffusion; theta = sum w theta_i' where a grip holds the temperature
/// DEPARTS [Ding19 Eq. 21]: without it, what differs within a cell stays for ever.
inline void take_heat(const SeenHeat& seen, const Recipe& recipe, const Material& m, double dt, bool is_held, Particle& p) {
  const double capacity = heat_capacity(p, recipe, m), latent = latent_heat(p.theta, p, m);
  p.theta += seen.change;
  const double diffusivity = m.kappa * p.V() / capacity;
  p.theta_lent = evened_out(recipe.heat_subgrid, diffusivity, dt, recipe.dx) * (seen.theta - p.theta);
  if (is_held) p.theta = seen.theta, p.theta_lent = 0;
  p.theta += p.theta_lent;
  if (m.transition_heat > 0) p.theta = temperature_of(capacity * p.theta + latent, capacity, p, m);
  p.theta_peak = std::max(p.theta_peak, p.theta);
  p.grad_theta = seen.grad_theta;
}

/// 3 alpha_l (theta - theta_0): the volumetric strain that is free of stress.
inline double thermal_strain(const Particle& p, const Recipe& recipe, const Material& m) {
  return recipe.heat && recipe.expansion_form == Form::standard ? 3 * m.alpha_l * (p.theta - m.theta_0) : 0;
}

/// beta_T (theta - theta_0), as a pressure; as printed c lambda J theta per volume now, with c = beta_T / lambda   [Ding19 Eq. 10]
inline double thermal_pressure(const Particle& p, const Recipe& recipe, const Material& m) {
  const double beta_T = thermal_stress_per_degree(recipe, m);
  return recipe.expansion_form == Form::published ? beta_T * p.J * p.J * p.theta : beta_T * (p.theta - m.theta_0);
}

}  // namespace bake::textbook

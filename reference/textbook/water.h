// SPDX-License-Identifier: MIT
// Water that moves through the solid.   [Ding19 Sec. 3.2, 5.5, 6.2]
#pragma once

#include "reference/textbook/heat.h"
#include "reference/textbook/particle.h"
#include "reference/textbook/vapour.h"

namespace bake::textbook {

/// m_i^w = sum w m_w, and what evaporation and saturation need   [Ding19 Eq. 15, 18]
inline void scatter_water(const Particle& p, const Material& m, const Overlap& o, Node& node) {
  node.water += o.w * p.m_w;
  node.water_room += o.w * m.rho_w * p.V();
  node.evaporability += o.w * m.beta_w * p.clamped_temperature() * p.V();
  node.permeability += o.w * m.rho_w * m.K * p.clamped_temperature() * p.V();
  node.water_spread += o.w * p.V() * p.water_spread;
  node.water_flux -= o.w * p.m_w_lent;  // what subgrid diffusion gave in the last step is taken back
}

/// + dt V q . grad w; as printed also - dt w m_w div v   [Ding19 Eq. 25]
/// DEPARTS [Ding19 Eq. 25]: no div v term: as printed half of the water is gone at doubled volume.
inline void scatter_water_flux(const Particle& p, const Recipe& recipe, double dt, const Overlap& o, Node& node) {
  node.water_flux += dt * p.V() * dot(p.q, o.grad_w);
  if (recipe.motion && recipe.water_form == Form::published) node.water_flux -= dt * o.w * p.m_w * p.div_v();
}

/// The momentum that water carries, + dt V (v_w (x) q) grad w (with vapour, which comes to dry dough, v_w = v), and the change of its own,
/// - w [V q - (V q)_old]. [Ding19 Eq. 27] DEPARTS [Ding19 Eq. 27]: no div v term: as printed it takes velocity out of a body that expands.
inline void scatter_water_momentum(const Particle& p, const Recipe& recipe, double dt, const Overlap& o, Node& node) {
  const Vector v_w = p.m_w > 0 && !recipe.has_vapour() ? p.v + (p.V() / p.m_w) * p.q : p.v;
  Vector change = (dt * p.V() * dot(p.q, o.grad_w)) * v_w - o.w * (p.Q() - p.Q_scattered);
  if (recipe.water_form == Form::published) change = change - (dt * o.w * p.div_v()) * (p.mass() * p.v + p.Q());
  node.momentum += recipe.inertia_scale * change;
}

/// s at the surface: what evaporates there comes through a layer of depth d,
///     rho K theta (s_i^2 - s^2) / (2 d) = beta_w theta (s - s_out),   a = rho K / (2 d beta_w)
/// d is that of the nodes, or what a half-space has that dried since tau = 0, the integral of K theta dt, before drying has gone so deep.
inline double surface_saturation(const Recipe& recipe, const Node& node, double s_i, double s_out, double dt) {
  if (!(node.evaporability > 0)) return s_i;
  if (!(node.permeability > 0)) return s_out;
  const double tau = node.water_spread / node.volume + dt * node.permeability / node.water_room;
  const double h = node.evaporability / node.permeability, z = h * h * tau;
  const double first = 2 / std::sqrt(std::acos(-1.)), last = 1 / (2 * 0.33206);  // of a constant flux, and of a dry surface
  const double reach = z > 0 ? std::sqrt(s_i * tau) * (first + (last - first) * z / (z + 2.15 * s_i)) : 0;
  const double e = recipe.dx * node.evaporability;
  const double d = std::min(layer_depth(recipe, e / (e + s_i * node.permeability)), reach);
  const double a = std::min(node.permeability / (2 * d * node.evaporability), 1e12);
  const double b = s_out + a * s_i * s_i;
  return 2 * b / (1 + std::sqrt(1 + 4 * a * b));
}

/// m_i^w' = m_i^w + flux - dt A beta_w theta (s - s_out), never below zero; s_i' = m_i^w' / (rho_w V_i)   [Ding19 Eq. 24-25]
inline void update_water(const Recipe& recipe, const Surroundings& surroundings, double dt, Node& node) {
  if (!(node.water_room > 0)) return;
  const double rate = node.volume > 0 ? node.area * node.evaporability / node.volume : 0;
  const double s_i = node.water / node.water_room;
  const double s = recipe.surface_form == Form::standard ? surface_saturation(recipe, node, s_i, surroundings.air.s_out, dt) : s_i;
  const double after_flux = node.water + node.water_flux;
  const double wanted = dt * (rate * (s - surroundings.air.s_out) + node.area * vapour_through_surface(recipe, node));
  node.evaporated = std::min(wanted, std::max(after_flux, 0.0));
  const double kept = std::max(after_flux - node.evaporated, 0.0);
  node.moved_water = kept - node.water;
  node.saturation = kept / node.water_room;
}

/// What a particle sees of the nodes' water.
struct SeenWater {
  double loss = 0, gain = 0;  ///< sum w dm_i / m_i^w and sum w dm_i / (rho_w V_i)
  double s = 0;
  Vector grad_s;  ///< [1/m]

  void add(const Node& node, const Overlap& o, Form form) {
    const bool by_water = form == Form::published || node.moved_water < 0;
    if (by_water && node.water > 0) loss += o.w * node.moved_water / node.water;
    if (!by_water && node.water_room > 0) gain += o.w * node.moved_water / node.water_room;
    s += o.w * node.saturation;
    grad_s += node.saturation * o.grad_w;
  }
};

/// Losses are shared as the particles' water, gains as their volume; then subgrid diffusion; q = - K theta rho_w s grad s, rho_w s = m_w /
/// V [Ding19 Eq. 19, 20, 22] DEPARTS [Ding19 Eq. 19]: as printed, gains are shared as the water that is there, and dry dough stays dry.
/// DEPARTS [Ding19 Eq. 20]: the volume is that of the new time.
inline void take_water(const SeenWater& seen, const Recipe& recipe, const Material& m, double dt, Particle& p) {
  const double room = m.rho_w * p.V_before;
  p.m_w += p.m_w * seen.loss + room * seen.gain;
  const double diffusivity = m.K * p.clamped_temperature() * p.m_w / (m.rho_w * p.V());
  p.m_w_lent = evened_out(recipe.water_subgrid, diffusivity, dt, recipe.dx) * (room * seen.s - p.m_w);
  p.m_w += p.m_w_lent;
  p.water_spread += dt * m.K * p.clamped_temperature();
  p.q = (-m.K * p.clamped_temperature() * p.m_w / p.V()) * seen.grad_s + p.j_v;
}

/// J p_water = J c_hat (s - s_0)   [Ding19 Eq. 14]
inline double water_pressure(const Particle& p, const Material& m) {
  const double s = p.m_w / (m.rho_w * p.V());
  return p.J * m.c_hat * (s - m.s_0);
}

}  // namespace bake::textbook

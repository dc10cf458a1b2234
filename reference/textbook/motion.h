// SPDX-License-Identifier: MIT
// Momentum of the mixture.   [Ding19 Sec. 6.1, 6.4]
#pragma once

#include <limits>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"

namespace bake::textbook {

/// m_i = sum w m;  m_i v_i = sum w m (v + C r): APIC. PIC and FLIP leave out C.   [Ding19 Eq. 15-16]
/// DEPARTS [Ding19 Eq. 16]: weighted by the mass of solid and water; by the solid's alone momentum is lost.
inline void scatter_momentum(const Particle& p, const Recipe& recipe, const Overlap& o, Node& node) {
  const double m = recipe.inertia_scale * p.mass();
  const Vector v = recipe.transfer == Transfer::apic ? p.v + p.C * o.r : p.v;
  node.mass += o.w * m;
  node.momentum += (o.w * recipe.inertia_scale * (p.mass() - p.m_w_lent)) * v;  // without what subgrid diffusion lent
  node.old_momentum += (o.w * m) * p.v;
}

/// - dt V sigma grad w = - dt V_0 tau grad w   [Ding19 Eq. 27]
inline void scatter_stress(const Particle& p, double dt, const Overlap& o, Node& node) {
  node.momentum += (-dt * p.V_0) * (p.tau * o.grad_w);
}

/// v_i' = momentum / mass + dt g. Vapour leaves after the step with this velocity, so that drying pushes nothing.
/// [Ding19 Eq. 26-27]
inline void update_velocity(const Recipe& recipe, const Vector& gravity, double dt, Node& node) {
  const double mass = node.mass + recipe.inertia_scale * (node.moved_water + node.evaporated);
  if (node.mass > 0) node.old_v = (1 / node.mass) * node.old_momentum;
  if (mass > 0) node.v = (1 / mass) * node.momentum + (dt / recipe.inertia_scale) * gravity;
}

/// What a particle sees of the nodes' velocities.
struct SeenVelocity {
  Vector v, old_v;
  Matrix affine, gradient;

  void add(const Node& node, const Overlap& o, double D) {
    v += o.w * node.v;
    old_v += o.w * node.old_v;
    affine += (o.w / D) * outer(node.v, o.r);
    gradient += outer(node.v, o.grad_w);
  }
};

/// The volume at which a particle fills the room of its nodes alone, sum w w V = dx^3, on average over the places in a cell [m^3]. No bound
/// is needed where pores hold a vacuum, which resists opening.
inline double room_of_nodes(const Recipe& recipe) {
  if (recipe.leavening && !recipe.pores_open) return std::numeric_limits<double>::infinity();
  const double overlap = recipe.kernel == Kernel::quadratic ? 11. / 20 : 151. / 315;  // integral of N^2
  return std::pow(recipe.dx / overlap, 3);
}

/// x += dt v;  J *= det(I + dt grad v), but no particle opens beyond the room of its nodes: alone there it only remembers that it did.
inline void move(const SeenVelocity& seen, const Recipe& recipe, double dt, Particle& p) {
  p.x += dt * seen.v;
  p.v = recipe.transfer == Transfer::flip ? seen.v + recipe.flip_blend * (p.v - seen.old_v) : seen.v;
  p.C = seen.affine;
  p.grad_v = seen.gradient;
  p.V_before = p.V();
  const double opened = p.J * determinant(identity() + dt * p.grad_v), widest = std::max(p.J, room_of_nodes(recipe) / p.V_0);
  if (opened > widest) {
    const Matrix opening = (std::max(p.div_v(), 0.) / 3) * identity();
    p.C = p.C - opening;
    p.grad_v = p.grad_v - opening;
  }
  p.J = std::min(opened, widest);
}

}  // namespace bake::textbook

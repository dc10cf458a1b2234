// SPDX-License-Identifier: MIT
// Colliders, grips and the faces of the domain act on the velocities of nodes.
#pragma once

#include <algorithm>

#include "reference/textbook/grid.h"

namespace bake::textbook {

/// A node this close to a solid is in it: faces are often drawn through nodes, whose positions are rounded [m].
inline double touching(const Recipe& recipe) { return 1e-6 * recipe.dx; }

/// Velocity after contact of dough that moves with `u` relative to a surface with outward normal `n`. Coulomb: friction takes
/// as much tangential speed as `friction` times the normal speed that the surface takes.
inline Vector after_contact(const Vector& u, const Vector& n, Rule rule, double friction) {
  if (rule == Rule::open) return u;
  if (rule == Rule::sticky) return {};
  const double normal_speed = dot(u, n);
  if (rule == Rule::separating && normal_speed >= 0) return u;
  const Vector along = u - normal_speed * n;
  const double speed = length(along), taken = rule == Rule::separating ? friction * -normal_speed : 0;
  return speed > taken ? (1 - taken / speed) * along : Vector{};
}

/// `line`: the velocity relative to the solid that dough has at x which touches it.
inline void touch_solid(const Solid& solid, const Vector& x, Vector& v, const Vector& line = {}) {
  const Vector wall = solid.velocity(x) + line;
  v = solid.rule == Rule::sticky ? wall : wall + after_contact(v - wall, solid.normal(x), solid.rule, solid.friction);
}

/// What moves at a node: vapour leaves after the step.
inline double moving_mass(const Recipe& recipe, const Node& node) {
  return node.mass + recipe.inertia_scale * (node.moved_water + node.evaporated);
}

/// Where dough touches a collider, its velocity relative to that goes to zero at the collider's face, in proportion to the distance d from
/// it (here in node distances): (d / d_k) v_k, with node k of the column along the axis nearest to the normal, the first that is at least
/// dx away. It touches where the masses of the column's nodes up to that node are those of dough that fills the column up to the face.
inline std::optional<Vector> line_beside(const Grid& grid, const Solid& solid, const Index& i) {
  const Recipe& recipe = grid.recipe();
  const Vector n = solid.normal(grid.position(i));
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (std::abs(n[d]) > std::abs(n[axis]) + 1e-6) axis = d;
  const auto node = [&](int steps) {
    Index j = i;
    j[static_cast<std::size_t>(axis)] += n[axis] > 0 ? steps : -steps;
    return j;
  };
  const auto d = [&](int steps) { return solid.distance(grid.position(node(steps))) / recipe.dx; };
  const auto mass = [&](int steps) { return grid.has(node(steps)) ? moving_mass(recipe, grid[node(steps)]) : 0; };
  if (d(0) < -2) return std::nullopt;
  int k = 0;
  while (k < 6 && d(k) < 1 - 1e-6) ++k;
  if (d(k) < 1 - 1e-6 || !(mass(k) > 0)) return std::nullopt;
  double filled = 0, found = 0;
  for (int j = k - 1; j >= k - 6 && d(j) < d(j + 1) && d(j) >= -1.5; --j) {
    filled += 1 - beyond(d(j));
    found += mass(j) / mass(k) * (1 - beyond(d(k)));
  }
  if (filled - found >= 0.1 || filled - found <= -0.55) return std::nullopt;
  return (d(0) / d(k)) * (grid[node(k)].v - solid.velocity(grid.position(node(k))));
}

/// The velocity of a node after contact, one after the other: colliders and grips in their order, then the domain's faces. Nodes of the
/// grid have those before contact.
inline Vector after_touching(const Grid& grid, const Surroundings& surroundings, const Index& i) {
  const Recipe& recipe = grid.recipe();
  const Vector x = grid.position(i);
  Vector v = grid[i].v;
  for (const Solid& solid : surroundings.solids) {
    const double distance = solid.distance(x);
    std::optional<Vector> line;
    if (!solid.is_grip && !solid.expels && distance <= (1 - 1e-6) * recipe.dx) line = line_beside(grid, solid, i);
    if (line || distance <= touching(recipe)) touch_solid(solid, x, v, line.value_or(Vector{}));
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t side = 0; side < 2; ++side) {
      const int face = grid.faces(axis)[side];
      if (side == 0 ? i[axis] > face : i[axis] < face) continue;
      Vector inward;
      inward.at[axis] = side == 0 ? 1 : -1;
      v = after_contact(v, inward, recipe.faces[axis][side], recipe.face_friction);
    }
  return v;
}

/// A grip holds the temperature of nodes in it, and heats the next ones as through the dough between them and its face. Particles between
/// see the held nodes' temperature, as if the face were d_0 further out: that is made good.
inline void hold_temperature(const Recipe& recipe, const Surroundings& surroundings, const Vector& x, Node& node) {
  const bool conducts = recipe.heat_transfer_form == Form::standard;
  const double d_0 = !conducts ? 0 : recipe.kernel == Kernel::quadratic ? 0.11 : 0.15;
  const Solid* nearest = nullptr;
  for (const Solid& solid : surroundings.solids)
    if (solid.is_grip && solid.theta && (!nearest || solid.distance(x) < nearest->distance(x))) nearest = &solid;
  if (!nearest) return;
  const double s = nearest->distance(x) / recipe.dx;
  if (s <= d_0 + 1e-6) {
    node.held = *nearest->theta;
  } else if (conducts && s <= 1 + d_0) {
    const double conductance = node.conductivity / (recipe.dx * recipe.dx) * (1 + d_0 - s) / (s - d_0);
    node.heat_transfer += conductance;
    node.heat_transfer_source += conductance * *nearest->theta;
  }
}

/// Is a particle inside of a grip that holds its temperature?
inline bool is_held(const Surroundings& surroundings, const Vector& x) {
  return std::any_of(surroundings.solids.begin(), surroundings.solids.end(),
                     [&](const Solid& solid) { return solid.is_grip && solid.theta && solid.distance(x) <= 0; });
}

/// A particle inside a solid that expels is put on its surface, by at most dx in a step, and feels the contact itself.
inline void expel(const Recipe& recipe, const Surroundings& surroundings, Vector& x, Vector& v) {
  for (const Solid& solid : surroundings.solids) {
    const double depth = -solid.distance(x);
    if (!solid.expels || depth <= 0) continue;
    touch_solid(solid, x, v);
    x += std::min(depth, recipe.dx) * solid.normal(x);
  }
}

/// A particle never leaves the domain: it is held at a closed face, and what passes a periodic one comes in at the other. Returns whether
/// it left through an open one.
inline bool leaves(const Recipe& recipe, Vector& x) {
  bool left = false;
  for (int d = 0; d < 3; ++d) {
    const double low = recipe.low[d], high = low + recipe.cells[d] * recipe.dx;
    if (recipe.periodic[d]) {
      x[d] -= (high - low) * std::floor((x[d] - low) / (high - low));
      continue;
    }
    left |= (x[d] < low && recipe.faces[d][0] == Rule::open) || (x[d] > high && recipe.faces[d][1] == Rule::open);
    x[d] = std::clamp(x[d], low, high);
  }
  return left;
}

}  // namespace bake::textbook

// SPDX-License-Identifier: MIT
// A skin: triangles whose corners move with the grid.   [Ding19 Sec. 7.1; Jiang et al. 2015]
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"

namespace bake::textbook {

/// What a skin is made of.
struct Sheet {
  double young_modulus = 0, poisson_ratio = 0, thickness = 0, density = 0;
  double permeance = 1;  ///< share of the evaporation that it lets pass
  double inertia = 1;    ///< inertial mass per mass, beside the recipe's own

  double mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }
  double lambda() const { return young_modulus * poisson_ratio / (1 - poisson_ratio * poisson_ratio); }  ///< plane stress
  double bending() const { return young_modulus * std::pow(thickness, 3) / (12 * (1 - poisson_ratio * poisson_ratio)); }
};

struct Vertex {
  Vector x, v;
  Matrix C;
  double area = 0;    ///< at rest [m^2]
  double covers = 1;  ///< area of the surface above it, over its own
};

struct Skin {
  Sheet sheet;
  std::vector<Vector> rest;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Vertex> vertices;

  double mass(const Vertex& p) const { return sheet.density * sheet.thickness * p.area; }
};

inline Vector cross_product(const Vector& a, const Vector& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

inline double triangle_area(const std::vector<Vector>& x, const std::array<int, 3>& t) {
  const auto at = [&](int k) { return x[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
  return length(cross_product(at(1) - at(0), at(2) - at(0))) / 2;
}

/// E = A_0 h (mu/2 (tr C - 2 - ln det C) + lambda/8 ln^2 det C). With the dual basis g^1, g^2 of the triangle at rest C = F^T F has the
/// components a_i . a_j there, and f_i = - A_0 h S^ij a_j with S = mu (G^-1 - C^-1) + lambda/2 ln(det C) C^-1, all in components.
inline void pull_triangle(const Sheet& sheet, const std::vector<Vector>& rest, const std::vector<Vector>& x, const std::array<int, 3>& t,
                          std::vector<Vector>& force) {
  const auto edge = [&](const std::vector<Vector>& points, std::size_t k) {
    return points[static_cast<std::size_t>(t[k])] - points[static_cast<std::size_t>(t[0])];
  };
  double metric[2][2], now[2][2];  // a_i . a_j, at rest and now
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      metric[i][j] = dot(edge(rest, i + 1), edge(rest, j + 1));
      now[i][j] = dot(edge(x, i + 1), edge(x, j + 1));
    }
  const double det_rest = metric[0][0] * metric[1][1] - metric[0][1] * metric[1][0], det = now[0][0] * now[1][1] - now[0][1] * now[1][0];
  const double ln = std::log(det / det_rest), volume = std::sqrt(det_rest) / 2 * sheet.thickness;
  for (std::size_t i = 0; i < 2; ++i) {
    Vector f;
    for (std::size_t j = 0; j < 2; ++j) {
      const double sign = i == j ? 1 : -1;
      const double inverse_rest = sign * metric[1 - j][1 - i] / det_rest, inverse = sign * now[1 - j][1 - i] / det;
      const double S = sheet.mu() * (inverse_rest - inverse) + sheet.lambda() / 2 * ln * inverse;
      f += (-volume * S) * edge(x, j + 1);
    }
    force[static_cast<std::size_t>(t[i + 1])] += f;
    force[static_cast<std::size_t>(t[0])] += (-1) * f;
  }
}

/// The angle between the normals of two triangles p q r and q p s.
inline double bend_angle(const Vector& p, const Vector& q, const Vector& r, const Vector& s) {
  const Vector e = q - p, n = cross_product(e, r - p), m = cross_product(s - p, e);
  return std::atan2(dot(cross_product(n, m), (1 / length(e)) * e), dot(n, m));
}

/// E = B/2 |e|^2 / (A_1 + A_2) (theta - theta_0)^2. A tip that moves by its height along the normal of its triangle turns that by 1.
inline void pull_hinge(const Sheet& sheet, const std::vector<Vector>& rest, const std::vector<Vector>& x,
                       const std::array<std::size_t, 4>& h, std::vector<Vector>& force) {
  const auto angle = [&](const std::vector<Vector>& at) { return bend_angle(at[h[0]], at[h[1]], at[h[2]], at[h[3]]); };
  const auto area = [&](std::size_t tip) { return length(cross_product(rest[h[1]] - rest[h[0]], rest[tip] - rest[h[0]])) / 2; };
  const double edge_2 = dot(rest[h[1]] - rest[h[0]], rest[h[1]] - rest[h[0]]);
  const double moment = sheet.bending() * edge_2 / (area(h[2]) + area(h[3])) * (angle(x) - angle(rest));
  const Vector e = x[h[1]] - x[h[0]];
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t tip = h[2 + side];
    const Vector up = x[tip] - x[h[0]], normal = side == 0 ? cross_product(e, up) : cross_product(up, e);
    const double height = length(normal) / length(e), share = dot(up, e) / dot(e, e);
    const Vector f = (moment / height / length(normal)) * normal;  // d theta / dx = - normal / height
    force[tip] += f;
    force[h[1]] += (-share) * f;
    force[h[0]] += (share - 1) * f;
  }
}

/// The forces on all vertices where they are now [N].
inline std::vector<Vector> skin_forces(const Skin& skin) {
  std::vector<Vector> x, force(skin.vertices.size());
  for (const Vertex& p : skin.vertices) x.push_back(p.x);
  std::map<std::pair<int, int>, int> tip_of;  // of an edge in the direction of its triangle
  for (const auto& t : skin.triangles) {
    pull_triangle(skin.sheet, skin.rest, x, t, force);
    for (std::size_t k = 0; k < 3; ++k) tip_of[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  }
  for (const auto& [edge, tip] : tip_of) {
    const auto other = tip_of.find({edge.second, edge.first});
    if (edge.first > edge.second || other == tip_of.end()) continue;
    const auto number = [](int v) { return static_cast<std::size_t>(v); };
    pull_hinge(skin.sheet, skin.rest, x, {number(edge.first), number(edge.second), number(tip), number(other->second)}, force);
  }
  return force;
}

/// Mass and momentum of a vertex, with the impulse dt f of the step. Gravity pulls its mass, not its inertia. The areas are for water.
inline void scatter_vertex(const Skin& skin, const Vertex& p, const Vector& force, const Vector& gravity, const Recipe& recipe, double dt,
                           const Overlap& o, Node& node) {
  const double mass = skin.mass(p), inertia = recipe.inertia_scale * skin.sheet.inertia * mass;
  const Vector v = recipe.transfer == Transfer::apic ? p.v + p.C * o.r : p.v;
  node.mass += o.w * inertia;
  node.momentum += o.w * (inertia * v + dt * force + (-dt * (skin.sheet.inertia - 1) * mass) * gravity);
  node.skin_area += o.w * p.covers * p.area;
  node.closed_area += o.w * (1 - skin.sheet.permeance) * p.covers * p.area;
}

/// S_open = S - (1 - permeance) min(S, S_skin).
inline double open_area(const Node& node) {
  return node.skin_area > 0 ? node.area - node.closed_area / node.skin_area * std::min(node.area, node.skin_area) : node.area;
}

}  // namespace bake::textbook

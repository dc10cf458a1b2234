// SPDX-License-Identifier: MIT
#include "reference/textbook/conduction.h"

namespace bake::textbook {

namespace {

using Nodal = std::vector<double>;

/// K theta
Nodal conduction(const std::vector<Particle>& particles, const Grid& grid, const Nodal& theta) {
  const Recipe& recipe = grid.recipe();
  Nodal heat(theta.size(), 0);
  for (const Particle& p : particles) {
    Vector grad_theta;
    for_each_node(grid, p.x, recipe.kernel,
                  [&](const Index& i, const Overlap& o) { grad_theta += theta[grid.number(grid.home(i))] * o.grad_w; });
    const double kappa = recipe.materials[static_cast<std::size_t>(p.material)].kappa;
    for_each_node(grid, p.x, recipe.kernel,
                  [&](const Index& i, const Overlap& o) { heat[grid.number(grid.home(i))] += p.V() * kappa * dot(grad_theta, o.grad_w); });
  }
  return heat;
}

double product(const Nodal& a, const Nodal& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void conduct_implicitly(const std::vector<Particle>& particles, double dt, Grid& grid) {
  const std::size_t n = grid.count();
  Nodal H(n, 0), theta(n, 0);
  grid.for_each([&](const Index& i, const Node& node) {
    H[grid.number(i)] = grid.home(i) == i ? node.heat_weight : 0;
    theta[grid.number(i)] = node.theta;
  });
  const auto residual_of = [&](Nodal heat) {  // only of the nodes that are free to change
    for (std::size_t i = 0; i < n; ++i) heat[i] = H[i] > 0 ? -dt * heat[i] : 0;
    return heat;
  };
  const auto preconditioned = [&](Nodal r) {
    for (std::size_t i = 0; i < n; ++i) r[i] = H[i] > 0 ? r[i] / H[i] : 0;
    return r;
  };
  Nodal r = residual_of(conduction(particles, grid, theta)), z = preconditioned(r), direction = z;
  double rz = product(r, z);
  constexpr double k_last_digit = 1e-17;
  const double enough = k_last_digit * k_last_digit * rz;
  for (int iteration = 0; iteration < 10000 && rz > enough; ++iteration) {
    Nodal change = residual_of(conduction(particles, grid, direction));
    for (std::size_t i = 0; i < n; ++i) change[i] -= H[i] * direction[i];
    const double alpha = -rz / product(direction, change);
    for (std::size_t i = 0; i < n; ++i) theta[i] += alpha * direction[i], r[i] += alpha * change[i];
    z = preconditioned(r);
    const double next = product(r, z);
    for (std::size_t i = 0; i < n; ++i) direction[i] = z[i] + next / rz * direction[i];
    rz = next;
  }
  grid.for_each([&](const Index& i, Node& node) {
    node.theta_change += theta[grid.number(i)] - node.theta;
    node.theta = theta[grid.number(i)];
  });
}

}  // namespace bake::textbook

// SPDX-License-Identifier: MIT
#include "reference/textbook/surface.h"

#include <algorithm>
#include <cmath>

namespace bake::textbook {

namespace {

/// A number per node; zero outside the grid, of which there is a margin of one node.
struct Field {
  const Grid& grid;
  std::array<std::size_t, 3> stride;
  std::vector<double> values;
  explicit Field(const Grid& of) : grid(of) {
    const auto& [x, y, z] = of.size();
    stride = {static_cast<std::size_t>((y + 2) * (z + 2)), static_cast<std::size_t>(z + 2), 1};
    values.resize(static_cast<std::size_t>(x + 2) * stride[0], 0);
  }
  std::size_t number(const Index& i) const {
    std::size_t number = 0;
    for (std::size_t d = 0; d < 3; ++d) number += static_cast<std::size_t>(i[d] + 1) * stride[d];
    return number;
  }
  double& operator[](const Index& i) { return values[number(i)]; }
  double operator()(const Index& i) const { return values[number(i)]; }
};

/// sum over the 27 nodes around i of weight[0][dx] weight[1][dy] weight[2][dz] field
double around(const Field& field, const Index& i, const double (&weight)[3][3]) {
  const double* first = &field.values[field.number({i[0] - 1, i[1] - 1, i[2] - 1})];
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t c = 0; c < 3; ++c)
        sum += weight[0][a] * weight[1][b] * weight[2][c] * first[a * field.stride[0] + b * field.stride[1] + c];
  return sum;
}

double blurred(const Field& field, const Index& i) {
  constexpr double k_weights[3][3] = {{0.25, 0.5, 0.25}, {0.25, 0.5, 0.25}, {0.25, 0.5, 0.25}};
  return around(field, i, k_weights);
}

Vector gradient(const Field& psi, const Index& i) {
  Vector g;
  for (int axis = 0; axis < 3; ++axis) {
    double weight[3][3] = {{0.125, 0.75, 0.125}, {0.125, 0.75, 0.125}, {0.125, 0.75, 0.125}};
    weight[axis][0] = -1, weight[axis][1] = 0, weight[axis][2] = 1;
    g[axis] = around(psi, i, weight) / (2 * psi.grid.dx());
  }
  return g;
}

/// Faces of the domain that pass no heat are mirrors: node i and its images in all faces that are at most four nodes away.
double mirrored_volume(const Grid& grid, Index i, std::size_t axis = 0) {
  if (axis == 3) return grid.has(i) ? grid[i].volume : 0;
  double sum = mirrored_volume(grid, i, axis + 1);
  const int here = i[axis];
  for (std::size_t side = 0; side < 2; ++side) {
    const int face = grid.faces(axis)[side];
    if (std::abs(here - face) > 4 || !grid.recipe().mirrors[axis][side]) continue;
    i[axis] = 2 * face - here;
    sum += mirrored_volume(grid, i, axis + 1);
  }
  return sum;
}

/// Colliders that cover, then walls.
std::vector<const Solid*> what_covers(const Surroundings& surroundings) {
  std::vector<const Solid*> all;
  for (const Solid& solid : surroundings.solids)
    if (solid.covers) all.push_back(&solid);
  for (const Solid& wall : surroundings.walls) all.push_back(&wall);
  return all;
}

/// The share that they leave of what is averaged into phi~ at x: blurred as phi is, and at least 0.05.
double room(const Surroundings& surroundings, const Vector& x, double dx) {
  double room = 1;
  for (const Solid* solid : what_covers(surroundings)) {
    const double d = solid->distance(x) / dx;
    room *= 1 - 0.25 * beyond(d - 1) - 0.5 * beyond(d) - 0.25 * beyond(d + 1);
  }
  return std::max(room, 0.05);
}

/// The first of them within `reach` of x.
const Solid* covering(const Surroundings& surroundings, const Vector& x, double reach) {
  for (const Solid* solid : what_covers(surroundings))
    if (solid->distance(x) <= reach) return solid;
  return nullptr;
}

/// A solid before a surface, and its share of the surface.
struct Facing {
  const Solid* solid;
  double share;
};

/// Those of them within `reach` of x, of the outward normal n there, that look at it or that come nearer along n. One must do so by a half;
/// of several each has a share: walls at right angles n . n_s, solids side by side half of it.
std::vector<Facing> covering(const Surroundings& surroundings, const Vector& x, const Vector& n, double reach) {
  std::vector<Facing> all;
  double most = 0;
  for (const Solid* solid : what_covers(surroundings)) {
    if (solid->distance(x) > reach || all.size() == 4) continue;
    double facing = -dot(solid->normal(x), n);
    if (facing < 0.5) facing = std::max(facing, (solid->distance(x) - solid->distance(x + reach * n)) / reach);
    if (facing < 0.2) continue;
    all.push_back({solid, facing});
    most = std::max(most, facing);
  }
  if (most < 0.5) return {};
  if (all.size() == 1) return {{all[0].solid, 1}};
  std::vector<Facing> shares;
  for (const Facing& f : all) {
    double alike = 0;
    for (const Facing& other : all) alike += std::max(dot(f.solid->normal(x), other.solid->normal(x)), 0.0);
    shares.push_back({f.solid, f.share / alike});
  }
  return shares;
}

/// beta, theta and flux behind a surface: of the solid that covers it (none if it passes no heat), or else of the air.
struct Behind {
  bool is_solid;
  double beta, theta, flux;
  Behind(const Solid* solid, const Air& air)
      : is_solid(solid),
        beta(!solid         ? air.beta
             : solid->theta ? solid->beta
                            : 0),
        theta(!solid ? air.theta : solid->theta.value_or(0)),
        flux(solid ? solid->flux : 0) {}
};

/// r, r K dx and r K^2 dx^2, averaged over the nodes around.
struct Bent {
  double r, r_K, r_K2;
};

/// r with what smoothing by sigma^2 = 0.83 dx^2 (cubic: 0.91) took off it: sigma^2 K^2 / 2 of a surface with the curvatures' sum K, and at
/// edges 9 times the variance of K dx, less that of noise and of levels one within the other.
double unrounded(const Recipe& recipe, const Bent& bent) {
  const double half_variance = recipe.kernel == Kernel::quadratic ? 0.415 : 0.457;
  if (!(bent.r > 0)) return 0;
  const double K = bent.r_K / bent.r, variance = bent.r_K2 / bent.r - std::pow(K, 2) - 0.01 - 0.03 * std::pow(K, 4);
  return bent.r * (1 + std::min(half_variance * K * K, 0.5) + std::min(9 * std::max(variance, 0.0), 1.0));
}

/// r = |grad psi| / phi, r K dx and r K^2 dx^2 of nodes.
struct Density {
  Field r, r_K, r_K2;
  explicit Density(const Grid& grid) : r{grid}, r_K{grid}, r_K2{grid} {}
  /// A share of another's; `edge`: share of K^2 that counts as an edge's.
  void add(const Density& other, const Index& i, double share, double edge) {
    r[i] += share * other.r(i), r_K[i] += share * other.r_K(i), r_K2[i] += edge * other.r_K2(i);
  }
  Bent around(const Index& i) const { return {blurred(r, i), blurred(r_K, i), blurred(r_K2, i)}; }
};

/// K dx = -(tr H - n.H n) / |grad phi|, n = grad phi / |grad phi|, from the gradient times dx; nothing where phi is level.
double curvature(const Field (&slope)[3], const Index& i) {
  const Vector n{{slope[0](i), slope[1](i), slope[2](i)}};
  double trace = 0, along = 0;
  for (int d = 0; d < 3; ++d) {
    const Vector H_d = slope[d].grid.dx() * gradient(slope[d], i);
    trace += H_d[d];
    along += n[d] * dot(H_d, n);
  }
  return (along - trace * dot(n, n)) / std::pow(dot(n, n) + 0.02 * 0.02, 1.5);
}

/// The surface of what fills the nodes, and the outward normal; zero where there is none.
struct Levels : Density {
  Field normal[3];
  Levels(Grid& grid, const Field& fill) : Density(grid), normal{Field{grid}, Field{grid}, Field{grid}} {
    constexpr double k_no_dough = 1e-3;
    const double dx = grid.dx();
    Field phi{grid}, psi{grid};
    Field slope[3] = {Field{grid}, Field{grid}, Field{grid}};
    grid.for_each([&](const Index& i, const Node&) {
      psi[i] = std::clamp((fill(i) - 0.2) / 0.6, 0.0, 1.0);
      phi[i] = fill(i) < k_no_dough ? 0 : fill(i);
    });
    grid.for_each([&](const Index& i, const Node&) {
      const Vector g = dx * gradient(phi, i);
      for (int d = 0; d < 3; ++d) slope[d][i] = g[d];
    });
    grid.for_each([&](const Index& i, const Node&) {
      if (fill(i) < k_no_dough) return;
      const Vector g = gradient(psi, i);
      if (length(g) == 0) return;
      for (int d = 0; d < 3; ++d) normal[d][i] = -g[d] / length(g);
      const double K = curvature(slope, i);
      r[i] = length(g) / fill(i);
      r_K[i] = r[i] * K;
      r_K2[i] = r[i] * K * K;
    });
  }
};

}  // namespace

void measure_surface(const Surroundings& surroundings, Grid& grid) {
  constexpr double k_no_dough = 1e-3;
  const double dx = grid.dx();
  Field phi{grid}, smooth{grid}, fill{grid};
  Density free(grid);
  std::vector<Behind> seen;  // what is in front of surfaces, and how much surface
  std::vector<Density> facing;
  grid.for_each([&](const Index& i, const Node&) { phi[i] = mirrored_volume(grid, i) / (dx * dx * dx); });
  grid.for_each([&](const Index& i, const Node&) {
    smooth[i] = fill[i] = blurred(phi, i);
    if (smooth[i] >= k_no_dough && smooth[i] < 1) fill[i] = std::min(smooth[i] / room(surroundings, grid.position(i), dx), 1.0);
  });
  const Levels beside_air(grid, fill), beside_solids(grid, smooth);
  for (const bool solid : {false, true}) {
    const Levels& levels = solid ? beside_solids : beside_air;
    grid.for_each([&](const Index& i, const Node&) {
      if (levels.r(i) == 0) return;
      const Vector outward{{levels.normal[0](i), levels.normal[1](i), levels.normal[2](i)}};
      std::vector<Facing> covers = covering(surroundings, grid.position(i), outward, 2.5 * dx);
      if (solid == covers.empty()) return;
      const double edge = solid ? 0 : std::max(1 - 24 * (1 - smooth(i) / fill(i)), 0.0);  // a face that meets a solid ends: that is no edge
      if (!solid) free.add(levels, i, 1, edge), covers = {{nullptr, 1}};
      for (const auto& [cover, share] : covers) {
        const Behind behind(cover, surroundings.air);
        const auto same = [&](const Behind& other) {
          return other.is_solid == behind.is_solid && other.beta == behind.beta && other.theta == behind.theta && other.flux == behind.flux;
        };
        const auto at = std::find_if(seen.begin(), seen.end(), same);
        const auto number = static_cast<std::size_t>(at - seen.begin());
        if (at == seen.end()) seen.push_back(behind), facing.emplace_back(grid);
        facing[number].add(levels, i, share, edge);
      }
    });
  }
  grid.for_each([&](const Index& i, Node& node) {
    if (node.volume == 0) return;
    node.area = node.volume * unrounded(grid.recipe(), free.around(i));
    for (std::size_t b = 0; b < seen.size(); ++b) {
      const double area = node.volume * unrounded(grid.recipe(), facing[b].around(i));
      const bool is_held = std::isinf(seen[b].beta);
      double passes = is_held ? area * node.conductivity / node.volume / layer_depth(grid.recipe(), 1) : seen[b].beta * area;
      if (!is_held && passes > 0 && grid.recipe().heat_transfer_form == Form::standard) {
        const double per_dx = seen[b].beta * node.volume / node.conductivity, strength = 1 / (1 + 1 / (per_dx * dx));
        passes /= 1 + per_dx * layer_depth(grid.recipe(), strength);
      }
      node.heat_transfer += passes;
      node.heat_transfer_source += passes * seen[b].theta + area * seen[b].flux;
    }
  });
}

void measure_published_surface(const std::vector<Particle>& particles, const Surroundings& surroundings, Grid& grid) {
  const auto at_boundary = [&](const Index& i) {
    if (!(grid[i].volume > 0)) return false;
    for (std::size_t d = 0; d < 3; ++d)
      for (const int step : {-1, 1}) {
        Index next = i;
        next[d] += step;
        if (!grid.has(next) || !(grid[next].volume > 0)) return true;
      }
    return false;
  };
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    const Particle* particle = nullptr;
  };
  std::vector<Nearest> nearest(grid.count());
  std::vector<char> boundary(grid.count());
  grid.for_each([&](const Index& i, const Node&) { boundary[grid.number(i)] = at_boundary(i); });
  for (const Particle& p : particles)
    for_each_node(grid, p.x, grid.recipe().kernel, [&](const Index& i, const Overlap& o) {
      const std::size_t number = grid.number(grid.home(i));
      Nearest& best = nearest[number];
      if (boundary[number] && length(o.r) < best.distance) best = {length(o.r), &p};
    });
  std::vector<const Particle*> marked;
  for (const Nearest& n : nearest)
    if (n.particle && std::find(marked.begin(), marked.end(), n.particle) == marked.end()) marked.push_back(n.particle);
  for (const Particle* p : marked) {
    const double pi = std::acos(-1.0), radius = std::cbrt(3 * p->V() / (4 * pi)), S = pi * radius * radius;
    for_each_node(grid, p->x, grid.recipe().kernel, [&](const Index& i, const Overlap& o) { grid[grid.home(i)].area += o.w * S; });
  }
  grid.for_each([&](const Index& i, Node& node) {
    if (!(node.area > 0)) return;
    const Solid* cover = covering(surroundings, grid.position(i), grid.dx());
    const Behind behind(cover, surroundings.air);
    node.heat_transfer = node.area * behind.beta;
    node.heat_transfer_source = node.area * (behind.beta * behind.theta + behind.flux);
    if (cover) node.area = 0;
  });
}

}  // namespace bake::textbook

// SPDX-License-Identifier: MIT
// All nodes of the domain and a margin around it, and the weights that couple them to particles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "reference/textbook/recipe.h"

namespace bake::textbook {

struct Node {
  // sums over the particles: sum_p w ...
  double volume = 0;             ///< V_i [m^3]
  double mass = 0;               ///< inertial [kg]
  Vector momentum;               ///< with the impulses of the step [kg m/s]
  Vector old_momentum;           ///< without them, for FLIP [kg m/s]
  double water = 0;              ///< m_i^w [kg]
  double water_flux = 0;         ///< what the step brings [kg]
  double water_room = 0;         ///< rho_w V: the water that would fill the node [kg]
  double evaporability = 0;      ///< beta_w theta V [kg m/s]
  double permeability = 0;       ///< rho_w K theta V [kg m^2/s]
  double water_spread = 0;       ///< V times that of the particles [m^5]
  double hygroscopic_water = 0;  ///< X_h m_s [kg]
  double vapour_mobility = 0;    ///< n D_v V [m^5/s]
  double vapour_transfer = 0;    ///< h_v V [m^4/s]
  double heat_capacity = 0;      ///< [J/K]
  double heat_content = 0;       ///< [J]
  double heat_change = 0;        ///< what the step brings [J]
  double conductivity = 0;       ///< kappa V [W m^2/K]
  double skin_area = 0;          ///< of skin [m^2]
  double closed_area = 0;        ///< of it, the share that holds water back [m^2]
  // surroundings
  double area = 0;                  ///< A_i, touching air [m^2]
  double heat_transfer = 0;         ///< sum A beta, of air and solids [W/K]
  double heat_transfer_source = 0;  ///< sum A beta theta_out [W]
  std::optional<double> held;       ///< theta that a grip holds [C]
  // after the step
  double moved_water = 0;     ///< change of m_i^w, evaporation included [kg]
  double evaporated = 0;      ///< [kg]
  double saturation = 0;      ///< s_i
  double vapour_density = 0;  ///< rho_v [kg/m^3]
  double theta = 0;           ///< theta_i' [C]
  double theta_change = 0;    ///< theta_i' - theta_i [K]
  double heat_weight = 0;     ///< heat per degree; 0 if theta is held [J/K]
  Vector v, old_v;            ///< [m/s]

  /// The sums over the particles of the same node beyond a periodic face.
  void add(const Node& other) {
    momentum += other.momentum, old_momentum += other.old_momentum;
    for (double Node::*sum : {&Node::volume, &Node::mass, &Node::water, &Node::water_flux, &Node::water_room, &Node::evaporability,
                              &Node::permeability, &Node::water_spread, &Node::hygroscopic_water, &Node::vapour_mobility,
                              &Node::vapour_transfer, &Node::heat_capacity, &Node::heat_content, &Node::heat_change, &Node::conductivity})
      this->*sum += other.*sum;
  }
};

using Index = std::array<int, 3>;

class Grid {
 public:
  /// Particles reach two nodes beyond a face, the surface measure sees two more.
  static constexpr int k_margin = 5;

  explicit Grid(const Recipe& recipe) : recipe_(recipe) {
    for (std::size_t d = 0; d < 3; ++d) size_[d] = recipe.cells[d] + 1 + 2 * k_margin;
    nodes_.resize(count(recipe));
  }
  static std::size_t count(const Recipe& recipe) {
    std::size_t product = 1;
    for (const int cells : recipe.cells) product *= static_cast<std::size_t>(cells + 1 + 2 * k_margin);
    return product;
  }
  void clear() { nodes_.assign(nodes_.size(), Node{}); }

  Node& operator[](const Index& i) { return nodes_[number(i)]; }
  const Node& operator[](const Index& i) const { return nodes_[number(i)]; }
  std::size_t number(const Index& i) const {
    return (static_cast<std::size_t>(i[0]) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(i[1])) *
               static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(i[2]);
  }
  /// The node between the periodic faces that is the same as node i.
  Index home(Index i) const {
    for (std::size_t d = 0; d < 3; ++d) {
      if (!recipe_.periodic[d]) continue;
      const int cells = recipe_.cells[d];
      i[d] = k_margin + ((i[d] - k_margin) % cells + cells) % cells;
    }
    return i;
  }
  /// Nodes that are the same get the sums of all of them.
  void join() {
    if (!recipe_.is_periodic()) return;
    for_each([&](const Index& i, const Node& node) {
      if (home(i) != i) (*this)[home(i)].add(node);
    });
    repeat();
  }
  /// Nodes beyond a periodic face become what the same node between them is.
  void repeat() {
    if (!recipe_.is_periodic()) return;
    for_each([&](const Index& i, Node& node) {
      if (home(i) != i) node = (*this)[home(i)];
    });
  }
  bool has(const Index& i) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (i[d] < 0 || i[d] >= size_[d]) return false;
    return true;
  }
  Vector position(const Index& i) const {
    Vector x = recipe_.low;
    for (int d = 0; d < 3; ++d) x[d] += recipe_.dx * (i[static_cast<std::size_t>(d)] - k_margin);
    return x;
  }
  /// Node numbers of the two faces of an axis.
  std::array<int, 2> faces(std::size_t axis) const { return {k_margin, k_margin + recipe_.cells[axis]}; }

  template <class Visit>
  void for_each(Visit visit) {
    for (int i = 0; i < size_[0]; ++i)
      for (int j = 0; j < size_[1]; ++j)
        for (int k = 0; k < size_[2]; ++k) visit(Index{i, j, k}, (*this)[{i, j, k}]);
  }
  std::size_t count() const { return nodes_.size(); }
  /// Nodes along each axis.
  const Index& size() const { return size_; }
  double dx() const { return recipe_.dx; }
  const Recipe& recipe() const { return recipe_; }

 private:
  const Recipe& recipe_;
  Index size_;
  std::vector<Node> nodes_;
};

/// B-spline at distance u, in node distances.
inline double spline(Kernel kernel, double u) {
  u = std::abs(u);
  if (kernel == Kernel::quadratic) {
    if (u < 0.5) return 0.75 - u * u;
    return u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0;
  }
  if (u < 1) return 2. / 3 - u * u + 0.5 * u * u * u;
  return u < 2 ? (2 - u) * (2 - u) * (2 - u) / 6 : 0;
}

/// Its derivative.
inline double spline_slope(Kernel kernel, double u) {
  const double sign = u < 0 ? -1 : 1;
  u = std::abs(u);
  if (kernel == Kernel::quadratic) {
    if (u < 0.5) return -2 * sign * u;
    return u < 1.5 ? -sign * (1.5 - u) : 0;
  }
  if (u < 1) return sign * (-2 * u + 1.5 * u * u);
  return u < 2 ? -0.5 * sign * (2 - u) * (2 - u) : 0;
}

/// The quadratic B-spline's integral from d on: the share of what is averaged at a distance d from a solid that lies in it.
inline double beyond(double d) {
  if (d < 0) return 1 - beyond(-d);
  return d < 0.5 ? 0.5 - 0.75 * d + d * d * d / 3 : d < 1.5 ? std::pow(1.5 - d, 3) / 6 : 0;
}

/// The second moment of the weights, sum_i w r r^T = D I [m^2].
inline double second_moment(Kernel kernel, double dx) { return dx * dx / (kernel == Kernel::quadratic ? 4 : 3); }

/// The weights that couple a node i and a particle p.
struct Overlap {
  double w;       ///< N_i(x_p)
  Vector grad_w;  ///< grad N_i(x_p), or D^-1 w r [1/m]
  Vector r;       ///< x_i - x_p [m]
};

/// visit(node index, overlap) for every node i that sees a particle at x.
template <class Visit>
void for_each_node(const Grid& grid, const Vector& x, Kernel kernel, Visit visit) {
  const double reach = kernel == Kernel::quadratic ? 1.5 : 2, dx = grid.dx();
  Index first, last;
  for (int d = 0; d < 3; ++d) {
    const double u = (x[d] - grid.position({0, 0, 0})[d]) / dx;
    first[static_cast<std::size_t>(d)] = static_cast<int>(std::floor(u - reach)) + 1;
    last[static_cast<std::size_t>(d)] = static_cast<int>(std::ceil(u + reach)) - 1;
  }
  for (int i = first[0]; i <= last[0]; ++i)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int k = first[2]; k <= last[2]; ++k) {
        Overlap o;
        o.r = grid.position({i, j, k}) - x;
        double N[3], slope[3];
        for (int d = 0; d < 3; ++d) {
          N[d] = spline(kernel, o.r[d] / dx);
          slope[d] = -spline_slope(kernel, o.r[d] / dx) / dx;  // N depends on x_i - x: minus
        }
        o.w = N[0] * N[1] * N[2];
        if (grid.recipe().gradient == Gradient::spline)
          o.grad_w = {{slope[0] * N[1] * N[2], N[0] * slope[1] * N[2], N[0] * N[1] * slope[2]}};
        else
          o.grad_w = (o.w / second_moment(kernel, dx)) * o.r;
        visit(Index{i, j, k}, o);
      }
}

}  // namespace bake::textbook

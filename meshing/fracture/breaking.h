// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/fracture/topology.h"

namespace bake {

/// When an edge between two particles counts as broken. [Wang et al. 2019, "Simulation and visualization of ductile fracture with the
/// material point method", do not give a threshold]
struct BreakingRule {
  /// The length divided by that at the reference time. Dough that rises to three times its volume stretches by 3^(1/3) = 1.44, and
  /// unevenly.
  double stretch = 2;
  /// Length [m]. Particles share nodes of a quadratic spline until they are three nodes apart; at half
  /// of that distance they hardly move each other any more.
  double smallest_gap_m = 0;
  /// The volume of the tetrahedra around the edge over that of the dough in them; 0: not asked. Dough that rises where it cannot spread, as
  /// beside a tray that it sticks to, or that is sheared has long edges, too, but nothing between its particles.
  double void_ratio = 0;
};

/// Follows the edges of a mesh over the frames of a run. An edge breaks if it exceeds all bounds in two consecutive frames. It never
/// heals.
class Breaking {
 public:
  /// `reference`: positions of the vertices at the reference time.
  Breaking(const Topology& topology, const std::vector<Point>& reference, const BreakingRule& rule);
  /// Call it for every frame in order. `growth`: of the dough at each vertex, its volume over that at the reference time; read only if the
  /// rule asks for a void.
  void advance(int frame, const std::vector<Point>& positions, const std::vector<double>& growth = {});
  /// For each edge the frame in which it broke; -1 if it is whole.
  const std::vector<std::int32_t>& broken_at() const { return broken_at_; }

 private:
  /// For each edge the volume of the tetrahedra around it, less void_ratio times that of their dough [m^3].
  std::vector<double> voids(const std::vector<Point>& positions, const std::vector<double>& growth) const;

  const Topology& topology_;
  double void_ratio_;
  std::vector<double> tet_volumes_;  ///< at the reference time [m^3]
  std::vector<float> limits_;        ///< of the squared lengths [m^2]
  std::vector<char> beyond_;         ///< at the frame before
  std::vector<std::int32_t> broken_at_;
};

/// For each vertex the number of its piece, along whole edges; pieces are numbered by their number of vertices, the largest first.
std::vector<std::int32_t> pieces(const Topology& topology, const std::vector<std::int32_t>& broken_at);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
// Describes a cut surface: its cracks, its pieces, and whether they are closed.
#pragma once

#include <vector>

#include "meshing/fracture/cut.h"

namespace bake {

/// A connected crack, measured in the reference mesh; only one of its two sides counts.
struct Crack {
  double area_m2 = 0;
  double length_m = 0;  ///< extent along the direction in which it is longest
  Point centre_m{0, 0, 0};
  Point low_m{0, 0, 0}, high_m{0, 0, 0};           ///< its box
  std::vector<std::array<std::int32_t, 2>> edges;  ///< that it cuts, by their vertices: each once, rising
};

/// The cracks, the largest first. `points`: of the nodes, in the reference mesh.
std::vector<Crack> cracks(const CutSurface& surface, const std::vector<Point>& points);

/// `broken_at` with the edges whole again that are cut by cracks smaller than `smallest_m2`.
std::vector<std::int32_t> without_specks(const Topology& topology, std::vector<std::int32_t> broken_at, const std::vector<Crack>& cracks,
                                         double smallest_m2);

struct Piece {
  std::size_t vertices = 0;
  double volume_m3 = 0;  ///< enclosed
  bool closed = true;    ///< every edge of a triangle has its opposite edge
};

/// `piece_of`: for each vertex of the mesh the number of its piece; `points`: of the nodes.
std::vector<Piece> take_census(const CutSurface& surface, const std::vector<std::int32_t>& piece_of, const std::vector<Point>& points);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of tetrahedra whose vertices become particles.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "solver/boundary/shape.h"
#include "solver/io/mesh_file.h"

namespace bake {

using Tet = std::array<std::int32_t, 4>;       ///< four vertices of positive volume (see `tet_volume`)
using Triangle = std::array<std::int32_t, 3>;  ///< three vertices, counter-clockwise from outside

/// Is called with a description at the beginning of each phase of long work.
using Tell = std::function<void(const std::string&)>;
inline void tell_nobody(const std::string&) {}

struct TetMesh {
  std::vector<Point> points;  ///< [m]
  std::vector<Tet> tets;
};

/// Corners of the face opposite to corner k of a tetrahedron of positive volume, counter-clockwise from outside.
inline constexpr std::array<std::array<int, 3>, 4> k_faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// det[b - a, c - a, d - a] / 6 [m^3]
double tet_volume(const Point& a, const Point& b, const Point& c, const Point& d);

inline double tet_volume(const std::vector<Point>& points, const Tet& tet) {
  return tet_volume(points[tet[0]], points[tet[1]], points[tet[2]], points[tet[3]]);
}

double volume(const TetMesh& mesh);  ///< [m^3]

/// The volume of each vertex, a quarter of those of its tetrahedra [m^3]; they add up to the volume of the mesh.
std::vector<double> vertex_volumes(const TetMesh& mesh);

/// For each tetrahedron and corner the tetrahedron behind the opposite face; -1: none. Throws InputError if more than two share a face.
std::vector<Tet> tet_neighbours(const std::vector<Tet>& tets, std::size_t vertices);

/// The points that cells use, in their order; the cells get their new numbers.
template <class Cell>
std::vector<Point> take_used_points(const std::vector<Point>& points, std::vector<Cell>& cells) {
  std::vector<std::int32_t> number(points.size(), -1);
  for (const Cell& cell : cells)
    for (const std::int32_t v : cell) number[v] = 0;
  std::vector<Point> used;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<std::int32_t>(used.size());
    used.push_back(points[v]);
  }
  for (Cell& cell : cells)
    for (std::int32_t& v : cell) v = number[v];
  return used;
}

/// The faces that belong to one tetrahedron only.
std::vector<Triangle> boundary_triangles(const std::vector<Tet>& tets, const std::vector<Tet>& neighbours);

/// The quality of a mesh.
struct TetQuality {
  double volume = 0;          ///< [m^3]
  double inner_spread = 0;    ///< standard deviation over mean of the volumes of vertices that are not on the boundary; 0 if there are none
  double least_angle = 0;     ///< smallest dihedral angle [degree]
  std::size_t boundary = 0;   ///< vertices on the boundary
  std::size_t loose = 0;      ///< vertices without a tetrahedron
  std::size_t odd_edges = 0;  ///< edges of the boundary that do not have two triangles: 0 if it is watertight and edge-manifold
};
TetQuality tet_quality(const TetMesh& mesh);

/// Number of edges of a closed surface that are not between two triangles of opposite direction: 0 if watertight and edge-manifold.
std::size_t count_odd_edges(const std::vector<Triangle>& triangles);

/// The mesh as a particles file stores it, with the field `volume`.
Mesh to_particles_mesh(const TetMesh& mesh);

/// Tetrahedra out of a file, all of positive volume. Throws InputError: `mesh` holds triangles, or a tetrahedron that is inside out.
TetMesh to_tet_mesh(const Mesh& mesh);

}  // namespace bake

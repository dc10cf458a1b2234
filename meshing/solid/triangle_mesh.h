// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// A closed surface of triangles.
struct TriangleMesh {
  std::vector<Point> points;        ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise from outside
};

/// An edge is sharp if the normals of its triangles differ by more than this [degree].
inline constexpr double k_sharp_deg = 40;

bool has_sharp_edges(const TriangleMesh& mesh);

/// Volume enclosed and area.
double enclosed_volume(const TriangleMesh& mesh);
double area(const TriangleMesh& mesh);

/// Whether `read_triangle_mesh` can read a file with this name.
bool is_triangle_file(const std::filesystem::path& file);

/// Reads STL, OBJ, PLY or OFF; faces with more corners are split into triangles. Throws InputError, one line with what is wrong and where:
/// the file cannot be read or is empty, a corner is no vertex or not finite, a triangle has no area, neighbours are oriented differently,
/// or the surface is open, not manifold (at an edge or a vertex), inside out or self-intersecting.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file);

/// The solid inside the surface, as a signed distance.
ShapePtr make_triangle_solid(const TriangleMesh& mesh);

}  // namespace bake

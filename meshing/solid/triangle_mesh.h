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

/// How the numbers of a file are understood, and who is told what was mended.
struct SurfaceReading {
  double unit_m = 1;           ///< length of 1 in the file [m]
  bool unit_is_given = false;  ///< by the user: no doubt about a large surface
  bool y_is_up = false;        ///< y of the file becomes z
  Tell say = tell_nobody;      ///< gets one line: what was mended, or a doubt about the unit
};

/// Reads a closed surface from STL, OBJ, PLY or OFF (polygon_soup.h) and mends it (cleaning.h): corners at one place or a
/// rounding apart are joined, polygons split, faces without area or doubled left out, triangles turned outwards. Throws InputError, one
/// line with what is wrong and where: the file cannot be read or is empty, a corner is no vertex or not finite, or the surface is open, not
/// manifold (at an edge or a vertex), has a shell within a shell that both hold, or intersects itself.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file, const SurfaceReading& reading = {});

/// The solid inside the surface, as a signed distance.
ShapePtr make_triangle_solid(const TriangleMesh& mesh);

}  // namespace bake

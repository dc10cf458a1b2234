// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "solver/boundary/shape.h"

namespace bake {

/// Faces as a file of a surface has them. Nothing is known of them but that their corners exist.
struct PolygonSoup {
  std::vector<Point> points;  ///< in the unit of the file; perhaps not finite
  std::vector<std::vector<std::int64_t>> faces;
  bool repeats_corners = false;  ///< the format knows no shared corners (STL)
};

/// Whether `read_polygon_soup` knows the ending of this name: .stl, .obj, .ply or .off.
bool is_surface_file(const std::filesystem::path& file);

/// Reads the faces of STL (text and binary), OBJ, PLY (text and binary) or OFF (text). What a surface does not need is passed over:
/// colours, normals, textures, lines, points. The readers are our own: those of CGAL 5.5 refuse OBJ with lines or continued lines and STL
/// in upper case, tell no reason, and believe any count. Throws InputError, one line: cannot be opened, is a folder, or what is damaged
/// where; a corner is no vertex.
PolygonSoup read_polygon_soup(const std::filesystem::path& file);

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
// Makes triangles that share corners and turn one way out of the faces of a file, before any library sees them.
#pragma once

#include <string>

#include "meshing/solid/polygon_soup.h"
#include "meshing/solid/triangle_mesh.h"

namespace bake {

/// What was mended of a surface.
struct Mended {
  std::size_t joined = 0;        ///< corners that stood at the place of another one
  double farthest_joined_m = 0;  ///< ... and how far from it at most
  std::size_t without_area = 0;  ///< faces
  std::size_t doubled = 0;       ///< faces
  std::size_t concave = 0;       ///< faces that were split otherwise than as a fan
  bool turned = false;           ///< triangles, so that all look outwards

  /// One line without what is only the way of the format; empty if nothing was mended.
  std::string text() const;
};

/// Triangles with finite corners of sane size, all used, no two at the same place, none without area and none twice; the triangles of a
/// part that is connected through edges turn one way (perhaps inwards). It may still be open, not manifold or cross itself. Throws
/// InputError (one line without the name of the file): a corner is not finite, too large or too small against its distance from the origin;
/// no triangle is left; the parts cannot be turned one way.
TriangleMesh clean_surface(const PolygonSoup& soup, Mended& mended);

}  // namespace bake

// SPDX-License-Identifier: MIT
// Technical drawings of meshes by VTK: parallel projection, plain colours, edges on request. They need no display.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "analysis/image/image.h"
#include "solver/io/mesh_file.h"

namespace bake {

struct DrawnMesh {
  const Mesh* mesh;             ///< triangles
  std::vector<Colour> colours;  ///< sRGB, one per vertex; empty: light grey
  bool lit = true;              ///< shaded by a lamp at the camera, or in its colours as they are
  bool edges = false;
};

/// A window on the plane through `centre`, seen from `towards_eye`.
struct Projection {
  Eigen::Vector3d centre, towards_eye, up;  ///< the directions of length 1, at right angles
  double half_height_m;
};

/// On white; smoothed by drawing at twice the size. Throws std::runtime_error if OpenGL cannot be had.
Image draw(const std::vector<DrawnMesh>& meshes, const Projection& projection, int width, int height);

}  // namespace bake

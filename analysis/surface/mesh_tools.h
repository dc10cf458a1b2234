// SPDX-License-Identifier: MIT
// Operations on meshes that pictures need.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "solver/io/mesh_file.h"

namespace bake {

/// The box around points x, y, z; an empty one if there is none.
template <class Real>
Eigen::AlignedBox<Real, 3> box_around(std::span<const Real> points) {
  Eigen::AlignedBox<Real, 3> box;
  for (std::size_t i = 0; i < points.size(); i += 3) box.extend(Eigen::Map<const Eigen::Vector<Real, 3>>(&points[i]));
  return box;
}

/// The boundary of a mesh of tetrahedra: the faces that only one tetrahedron has, facing outwards, with the fields of their vertices.
Mesh boundary_of_tetrahedra(const Mesh& tetrahedra);

/// Normals at the corners of each triangle: the mean, weighted by area, over those triangles around the vertex whose normals are within
/// `crease_deg` of the triangle's own. Edges that are sharper stay sharp.
std::vector<std::array<Eigen::Vector3f, 3>> corner_normals(const Mesh& triangles, double crease_deg);

/// Moves every vertex along the mean normal of its triangles.
void move_outwards(Mesh& triangles, double distance_m);

/// The mesh without those connected parts that enclose less than `share` of what the largest encloses: crumbs of a particle or two, and
/// bubbles inside.
Mesh without_specks(const Mesh& triangles, double share);

struct CutMesh {
  Mesh kept;
  Mesh face;  ///< on the plane, in triangles with no edge longer than was asked for, without fields; may be empty
};

/// The part of a closed surface behind a plane (against its normal, which need not have length 1), and the face that closes it again.
/// Throws std::invalid_argument if the normal is zero.
CutMesh cut(const Mesh& triangles, const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double longest_edge_m);

}  // namespace bake

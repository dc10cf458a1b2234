// SPDX-License-Identifier: MIT
// Even meshes of triangles on shapes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/boundary/shape.h"
#include "solver/core/errors.h"

namespace bake {

using SurfaceTriangle = std::array<std::int32_t, 3>;

/// A surface, closed or open.
struct SurfaceMesh {
  std::vector<Point> points;               ///< [m]
  std::vector<SurfaceTriangle> triangles;  ///< corners counter-clockwise from outside
};

/// Two triangles that share an edge: its corners in the direction of the first of them, and the tips of both.
struct SurfaceHinge {
  std::int32_t edge[2], tips[2];
  std::int32_t triangles[2];
};

/// What hinges_of complains of.
struct TornSurface : InputError {
  using InputError::InputError;
};

/// All hinges, in the order of their edges. Throws TornSurface, one clause, if more than two triangles share an edge, or two in the same
/// direction.
std::vector<SurfaceHinge> hinges_of(const std::vector<SurfaceTriangle>& triangles);

/// A closed mesh with edges of about `edge_m` on the surface that lies `depth_m` below that of a bounded shape. Mean edges are within a few
/// per cent of those asked, the longest are below 1.6 of it; where the shape has a sharp edge the mesh has a bevel of one triangle.
/// The same bits every time. Throws InputError, one clause, if the shape is too large or too thin for such triangles.
SurfaceMesh cover(const Shape& shape, double edge_m, double depth_m);

/// The triangles whose centres are inside `region`, with the vertices that they need, in their order.
SurfaceMesh part_inside(const SurfaceMesh& mesh, const Shape& region);

/// Moves every vertex so far against the mean normal of its triangles.
void move_inwards(SurfaceMesh& mesh, double depth_m);

/// The area of a triangle [m^2].
double area_of(const SurfaceMesh& mesh, const SurfaceTriangle& triangle);

/// The area of each vertex, a third of its triangles' [m^2].
std::vector<double> vertex_areas(const SurfaceMesh& mesh);

}  // namespace bake

// SPDX-License-Identifier: MIT
// Makes the skins of a scene: meshes for the run's dx on the bodies that they cover, and what a frame shows of them.
#pragma once

#include <string>
#include <vector>

#include "solver/boundary/surface_mesh.h"
#include "solver/engine/engine_types.h"
#include "solver/io/frames.h"
#include "solver/io/mesh_file.h"
#include "solver/scene/scene.h"

namespace bake {

inline constexpr double k_skin_edge_dx = 0.6;  ///< edges of meshes that are made, in dx

/// A skin at rest; one mesh, whatever it covers.
struct MadeSkin {
  SurfaceMesh mesh;
  std::vector<std::int32_t> body;  ///< of each vertex
  std::vector<double> covers;      ///< of each vertex, the area of the body's surface above it over its own
};

/// The skins of a scene, in its order. Throws InputError, one line: a mesh cannot be made or read, has a triangle without area or no
/// triangle at all, or reaches out of the domain.
std::vector<MadeSkin> make_skins(const Scene& scene);

/// Their vertices as particles, skin after skin. They move as the bodies do, whose particles are among `particles`.
std::vector<NewParticle> vertices_of(const Scene& scene, const std::vector<MadeSkin>& skins, const std::vector<NewParticle>& particles);

/// What may be doubtful about the skins of a scene at its quality, one sentence each; none if it has none. Throws InputError as make_skins.
std::vector<std::string> doubts_about_skins(const Scene& scene);

/// Columns of frames that meshes of skins show, too: the mean over the flesh around each vertex, with the quadratic B-spline's weights. 0
/// where there is none within 1.5 dx.
std::vector<MeshField> flesh_at(const std::vector<double>& points, const FrameData& frame, double dx);

}  // namespace bake

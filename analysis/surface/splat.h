// SPDX-License-Identifier: MIT
// Makes a closed smooth surface around particles that have no mesh.
#pragma once

#include "analysis/surface/particles.h"
#include "solver/io/mesh_file.h"

namespace bake {

struct SplatSettings {
  double spacing_m = 0;  ///< typical distance of particles; 0: Particles::spacing()
  int threads = 1;
};

/// The level set of Zhu and Bridson (2005, Sec. 4.5): distance to a weighted mean of near particles, less half a spacing; sampled at
/// half a spacing, meshed by flying edges, smoothed by a windowed sinc (volume changes little). Fields are weighted means of the
/// particles near each vertex.
/// Closed, and oriented outwards. Sheets thinner than one spacing and gaps narrower than about one are not resolved; lone particles
/// may vanish. Throws InputError if nothing is left, or if the particles are strewn too far for the grid.
Mesh splat_surface(const Particles& particles, const SplatSettings& settings = {});

/// Interpolates the particles' fields at other points, as weighted means of the particles within 1.8 spacings (or the nearest one).
/// Throws InputError naming `what` if more than one point in a hundred has no particle within 4 spacings: then the points belong to another
/// run or time. (Single points may be that far away: where crumbs separate, the surface between them is extrapolated.) `spacing`: of the
/// surface that the points are of, if that is coarser than the particles [m].
std::vector<MeshField> fields_at(const std::vector<double>& points, const Particles& particles, const std::vector<MeshField>& fields,
                                 int threads, const std::string& what, float spacing = 0);

}  // namespace bake

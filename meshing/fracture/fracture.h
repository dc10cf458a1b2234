// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the surfaces of the pieces from the frames of a run.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "meshing/fracture/breaking.h"

namespace bake {

struct FractureOptions {
  std::filesystem::path mesh;     ///< tetrahedra whose vertices are the run's particles
  std::filesystem::path results;  ///< folder of the run
  std::filesystem::path out;      ///< folder of the surfaces
  double reference_time_s = 0;    ///< lengths of edges are compared with those of the frame nearest to this time
  std::vector<int> frames;        ///< the frames to make; empty: every `every`-th, or the last
  int every = 0;
  double stretch = BreakingRule{}.stretch;
  std::optional<double> smallest_gap_m;  ///< default: k_smallest_gap node distances of the run
  double void_ratio = BreakingRule{}.void_ratio;
  double smallest_crack = 0;        ///< faces of a cell of the run's grid: smaller cracks are not cut
  std::int64_t first_particle = 0;  ///< the particle that is vertex 0
  int smoothing_passes = 8;
};

/// Smallest gap in node distances: half of the three at which a quadratic spline parts two particles for good.
inline constexpr double k_smallest_gap = 1.5;

/// Writes <out>/NNNN.hdf for each wanted frame, a surface with the run's fields, `piece`, `crack` and `depth`, and <out>/fracture.json.
/// There, volume_m3 is the volume of all pieces in that frame, cut_volume_m3 that of the same pieces in the reference mesh.
/// `tell` is called with a line after each surface, `progress` with the share that is done before each frame.
/// Throws InputError (mesh, run, frames that do not exist) and OutputError.
void write_fracture(
    const FractureOptions& options, const std::function<void(const std::string&)>& tell,
    const std::function<void(double)>& progress = [](double) {});

}  // namespace bake

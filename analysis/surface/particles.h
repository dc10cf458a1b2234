// SPDX-License-Identifier: MIT
// The particles of a frame with all their scalar fields, as pictures and surfaces need them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "solver/io/mesh_file.h"

namespace bake {

struct Particles {
  double time_s = 0;
  std::vector<float> positions;   ///< x, y, z of each [m]
  std::vector<float> volumes;     ///< [m^3]
  std::vector<std::int64_t> ids;  ///< empty if the file has none
  std::vector<MeshField> fields;  ///< all scalars of the frame but volume, and velocity

  std::size_t count() const { return positions.size() / 3; }
  const MeshField* find(std::string_view name) const { return find_field(fields, name); }
  /// Typical distance of neighbours: cube root of the median volume [m].
  float spacing() const;
};

/// Throws InputError if the file is missing, damaged or not a frame, if it has no particle or no volumes, or if a position or volume is not
/// finite.
Particles read_particles_of_frame(const std::filesystem::path& path);

}  // namespace bake

// SPDX-License-Identifier: MIT
// Reads particles that another program made (bake-mesh, or any program that writes HDF5).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "solver/core/parameter.h"

namespace bake {

struct ParticlesFile {
  std::vector<Vector3> positions;       ///< [m]
  std::vector<double> volumes;          ///< [m^3], one per position
  std::vector<std::int32_t> materials;  ///< index into the scene's materials, one per position; empty if the file has none
};

/// Reads datasets `positions` [n, 3], `volumes` [n] and, if there, `material` [n]. Throws InputError naming file and dataset:
/// missing or damaged file, missing dataset, wrong shape or type, n = 0, position not finite, volume not finite and positive,
/// negative material. A VTKHDF file with Points, PointData/volume and PointData/material is read as well: a mesh of tetrahedra
/// whose vertices become the particles, or a frame of another run.
ParticlesFile read_particles(const std::filesystem::path& path);

}  // namespace bake

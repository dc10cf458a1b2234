// SPDX-License-Identifier: MIT
#include "solver/io/particles_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/core/errors.h"
#include "solver/io/hdf5.h"

namespace bake {
namespace {

template <class Found>
InputError refused(const Hdf5Reader& file, const char* dataset, std::size_t particle, const Found& found, const char* allowed) {
  return InputError(fmt::format("{}: {}: particle {} has {}, must be {}", file.path().string(), dataset, particle, found, allowed));
}

/// Throws for the first value that is not `allowed`; each particle has `components` values.
template <class Value, class Test>
void check_each(const Hdf5Reader& file, const char* dataset, const std::vector<Value>& values, std::size_t components, Test allowed,
                const char* words) {
  const auto bad = std::find_if_not(values.begin(), values.end(), allowed);
  if (bad != values.end()) throw refused(file, dataset, static_cast<std::size_t>(bad - values.begin()) / components, *bad, words);
}

void check_count(const Hdf5Reader& file, const char* dataset, std::size_t found, std::size_t particles) {
  if (found == particles) return;
  throw InputError(fmt::format("{}: {}: holds {} values for {} positions", file.path().string(), dataset, found, particles));
}

/// The names of the three datasets, in a plain HDF5 file or in a VTKHDF file.
struct Names {
  const char *positions, *volumes, *material;
};
Names names_in(const Hdf5Reader& file) {
  if (file.has("VTKHDF")) return {"VTKHDF/Points", "VTKHDF/PointData/volume", "VTKHDF/PointData/material"};
  return {"positions", "volumes", "material"};
}

std::vector<Vector3> read_positions(const Hdf5Reader& file, const char* name) {
  const auto flat = file.table<double>(name, 3);
  check_each(
      file, name, flat, 3, [](double x) { return std::isfinite(x); }, "finite");
  std::vector<Vector3> positions(flat.size() / 3);
  for (std::size_t p = 0; p < positions.size(); ++p) positions[p] = {flat[3 * p], flat[3 * p + 1], flat[3 * p + 2]};
  return positions;
}

std::vector<std::int32_t> read_materials(const Hdf5Reader& file, const char* name) {
  constexpr auto k_largest = std::numeric_limits<std::int32_t>::max();
  const auto type = file.stored_type(name);
  const bool whole = type != ElementType::float32 && type != ElementType::float64 && type != ElementType::other_real;
  if (!whole) throw InputError(fmt::format("{}: {}: must hold whole numbers", file.path().string(), name));
  const auto wide = file.array<std::int64_t>(name);
  check_each(
      file, name, wide, 1, [](std::int64_t m) { return m >= 0 && m <= k_largest; }, "the index of a material, from 0");
  return {wide.begin(), wide.end()};
}

}  // namespace

ParticlesFile read_particles(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  ParticlesFile particles;
  const Names names = names_in(file);
  particles.positions = read_positions(file, names.positions);
  if (particles.positions.empty()) throw InputError(fmt::format("{}: {}: there are none", path.string(), names.positions));
  particles.volumes = file.array<double>(names.volumes);
  check_count(file, names.volumes, particles.volumes.size(), particles.positions.size());
  check_each(
      file, names.volumes, particles.volumes, 1, [](double v) { return std::isfinite(v) && v > 0; }, "finite and above 0");
  if (file.has(names.material)) {
    particles.materials = read_materials(file, names.material);
    check_count(file, names.material, particles.materials.size(), particles.positions.size());
  }
  return particles;
}

}  // namespace bake

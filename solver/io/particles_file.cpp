// SPDX-License-Identifier: MIT
#include "solver/io/particles_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "solver/io/hdf5.h"
#include "solver/scene/input_error.h"

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

std::vector<Vector3> read_positions(const Hdf5Reader& file) {
  const auto flat = file.table<double>("positions", 3);
  check_each(
      file, "positions", flat, 3, [](double x) { return std::isfinite(x); }, "finite");
  std::vector<Vector3> positions(flat.size() / 3);
  for (std::size_t p = 0; p < positions.size(); ++p) positions[p] = {flat[3 * p], flat[3 * p + 1], flat[3 * p + 2]};
  return positions;
}

std::vector<std::int32_t> read_materials(const Hdf5Reader& file) {
  constexpr auto k_largest = std::numeric_limits<std::int32_t>::max();
  const auto type = file.stored_type("material");
  const bool whole = type != ElementType::float32 && type != ElementType::float64 && type != ElementType::other_real;
  if (!whole) throw InputError(fmt::format("{}: material: must hold whole numbers", file.path().string()));
  const auto wide = file.array<std::int64_t>("material");
  check_each(
      file, "material", wide, 1, [](std::int64_t m) { return m >= 0 && m <= k_largest; }, "the index of a material, from 0");
  return {wide.begin(), wide.end()};
}

}  // namespace

ParticlesFile read_particles(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  ParticlesFile particles;
  particles.positions = read_positions(file);
  if (particles.positions.empty()) throw InputError(fmt::format("{}: positions: there are none", path.string()));
  particles.volumes = file.array<double>("volumes");
  check_count(file, "volumes", particles.volumes.size(), particles.positions.size());
  check_each(
      file, "volumes", particles.volumes, 1, [](double v) { return std::isfinite(v) && v > 0; }, "finite and above 0");
  if (file.has("material")) {
    particles.materials = read_materials(file);
    check_count(file, "material", particles.materials.size(), particles.positions.size());
  }
  return particles;
}

}  // namespace bake

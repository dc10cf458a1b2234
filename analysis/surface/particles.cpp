// SPDX-License-Identifier: MIT
#include "analysis/surface/particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.h"
#include "solver/io/frames.h"
#include "solver/io/vtkhdf.h"

namespace bake {
namespace {

void check(const std::filesystem::path& path, const Particles& particles) {
  if (particles.count() == 0) throw InputError(fmt::format("{}: found no particle, allowed: at least one", path.string()));
  const auto bad = [](float x) { return !std::isfinite(x); };
  if (std::any_of(particles.positions.begin(), particles.positions.end(), bad))
    throw InputError(fmt::format("{}: found a position that is not finite", path.string()));
  if (std::any_of(particles.volumes.begin(), particles.volumes.end(), [](float v) { return !(v > 0) || std::isinf(v); }))
    throw InputError(fmt::format("{}: found a volume that is not finite and positive", path.string()));
}

}  // namespace

float Particles::spacing() const {
  std::vector<float> sorted = volumes;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return std::cbrt(*middle);
}

Particles read_particles_of_frame(const std::filesystem::path& path) {
  const FrameReader frame(path);
  const Hdf5Reader file(path);
  Particles particles;
  particles.time_s = frame.time_s();
  const std::vector<double> positions = frame.positions();
  particles.positions.assign(positions.begin(), positions.end());
  particles.volumes = frame.column("volume");
  if (frame.has("id")) particles.ids = frame.identities();
  for (const std::string& name : file.names(k_vtk_fields)) {
    if (name == "id" || name == "volume") continue;
    MeshField field = read_field(file, name);
    if (field.components == 1 || name == "velocity") particles.fields.push_back(std::move(field));
  }
  check(path, particles);
  return particles;
}

}  // namespace bake

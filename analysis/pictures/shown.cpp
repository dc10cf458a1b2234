// SPDX-License-Identifier: MIT
#include "analysis/pictures/shown.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/browning/browning.h"
#include "analysis/surface/mesh_tools.h"
#include "analysis/surface/splat.h"
#include "solver/boundary/rotation.h"
#include "solver/core/errors.h"
#include "solver/io/frames.h"
#include "solver/io/hdf5.h"
#include "solver/scene/nearest.h"

namespace bake {
namespace {

bool holds_particles(const std::filesystem::path& file) {
  const Hdf5Reader reader(file);
  if (!reader.has("VTKHDF/Types"))
    throw InputError(
        fmt::format("{}: neither a frame nor a mesh, allowed: a file of bake run, bake-mesh or bake-render surface", file.string()));
  const auto types = reader.array<std::uint8_t>("VTKHDF/Types");
  constexpr std::uint8_t k_vertex = 1, k_poly_vertex = 2;  // one for each particle; for all of them in older files
  return std::all_of(types.begin(), types.end(), [](std::uint8_t type) { return type == k_vertex || type == k_poly_vertex; });
}

std::filesystem::path run_around(const std::filesystem::path& frame) {
  const auto folder = std::filesystem::absolute(frame).parent_path().parent_path();
  return std::filesystem::exists(folder / "frames.hdf.series") ? folder : std::filesystem::path();
}

}  // namespace

double diameter(const std::vector<double>& points) { return points.empty() ? 0 : box_around<double>(points).diagonal().norm(); }

Shown::Shown(std::filesystem::path file, std::filesystem::path results, int threads)
    : file_(std::move(file)), results_(std::move(results)), threads_(threads) {
  if (holds_particles(file_)) {
    particles_ = read_particles_of_frame(file_);
    time_s_ = particles_->time_s;
    if (results_.empty()) results_ = run_around(file_);
    return;
  }
  mesh_ = read_mesh(file_);
  time_s_ = mesh_->time_s;
  if (mesh_->corners == 4) mesh_ = boundary_of_tetrahedra(*mesh_);
}

void Shown::keep_material(int number) {
  const MeshField* material = is_frame() ? particles_->find("material") : nullptr;
  if (!material) throw InputError(fmt::format("{}: material: has no particles of materials, allowed: a frame of bake run", file_.string()));
  Particles kept;
  kept.time_s = particles_->time_s;
  for (const MeshField& field : particles_->fields) kept.fields.push_back({field.name, field.unit, field.components, {}});
  for (std::size_t i = 0; i < particles_->count(); ++i) {
    if (material->values[i] != number) continue;
    kept.positions.insert(kept.positions.end(), &particles_->positions[3 * i], &particles_->positions[3 * i] + 3);
    kept.volumes.push_back(particles_->volumes[i]);
    if (!particles_->ids.empty()) kept.ids.push_back(particles_->ids[i]);
    for (std::size_t f = 0; f < kept.fields.size(); ++f) {
      const auto& values = particles_->fields[f].values;
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * kept.fields[f].components);
      kept.fields[f].values.insert(kept.fields[f].values.end(), first, first + static_cast<std::ptrdiff_t>(kept.fields[f].components));
    }
  }
  if (kept.volumes.empty()) throw InputError(fmt::format("{}: material: found no particle of number {}", file_.string(), number));
  particles_ = std::move(kept);
}

void Shown::mirror(int axis) {
  if (!is_frame()) throw InputError(fmt::format("{}: mirrored: has no particles, allowed: a frame of bake run", file_.string()));
  const auto repeat = [](auto& values) {
    const auto once = values;
    values.insert(values.end(), once.begin(), once.end());
  };
  const std::size_t count = particles_->count();
  repeat(particles_->positions);
  repeat(particles_->volumes);
  repeat(particles_->ids);
  for (MeshField& field : particles_->fields) repeat(field.values);
  for (std::size_t i = count; i < 2 * count; ++i) particles_->positions[3 * i + static_cast<std::size_t>(axis)] *= -1;
}

void Shown::turn(const Vector3& rotate_deg) {
  if (!is_frame()) throw InputError(fmt::format("{}: rotate_deg: has no particles, allowed: a frame of bake run", file_.string()));
  const Rotation rotation = matrix(quaternion(k_rad_per_deg * rotate_deg));
  for (std::size_t i = 0; i < particles_->count(); ++i) {
    float* p = &particles_->positions[3 * i];
    const Vector3 q = rotation * Vector3{p[0], p[1], p[2]};
    for (std::size_t d = 0; d < 3; ++d) p[d] = static_cast<float>(q[d]);
  }
}

Mesh Shown::surface(double spacing_m) const { return mesh_ ? *mesh_ : splat_surface(*particles_, {spacing_m, threads_}); }

const std::filesystem::path& Shown::results() const {
  if (results_.empty()) throw InputError(fmt::format("{}: its run is not known: give --results <folder of the run>", file_.string()));
  return results_;
}

const Particles& Shown::particles() const {
  if (!particles_) particles_ = read_particles_of_frame(results() / "frames" / frame_name(frame_at(results(), time_s_)));
  return *particles_;
}

void Shown::add_fields(Mesh& mesh, const std::vector<MeshField>& fields) const {
  for (MeshField& field : fields_at(mesh.points, particles(), fields, threads_, file_.string())) mesh.fields.push_back(std::move(field));
}

void Shown::provide(Mesh& mesh, const std::string& name) const {
  if (const MeshField* own = mesh.find(name); own && own->components == 1) return;
  if (!particles_ && results_.empty() && !mesh.fields.empty()) refuse_field(name, mesh.fields);
  const MeshField* field = particles().find(name);
  if (!field || field->components != 1) refuse_field(name, particles().fields);
  add_fields(mesh, {*field});
}

void Shown::refuse_field(const std::string& name, const std::vector<MeshField>& fields) const {
  std::vector<std::string> known;
  for (const MeshField& field : fields)
    if (field.components == 1) known.push_back(field.name);
  throw InputError(fmt::format("{}: has no field '{}'; {}", file_.string(), name, suggestion(name, known)));
}

}  // namespace bake

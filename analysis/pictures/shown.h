// SPDX-License-Identifier: MIT
// A file that is shown (the particles of a frame, or a mesh) and its run, from which it gets fields that the file does not hold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/surface/particles.h"
#include "solver/core/vector3.h"
#include "solver/io/mesh_file.h"

namespace bake {

class Shown {
 public:
  /// `results`: folder of the run that the file shows; empty: found from a frame's own place. Throws InputError: missing or damaged
  /// file, neither a frame nor a mesh.
  Shown(std::filesystem::path file, std::filesystem::path results, int threads);

  const std::filesystem::path& file() const { return file_; }
  /// Leaves only the particles of that material. Throws InputError if the file is no frame, or has none of it.
  void keep_material(int number);
  /// Adds all particles once more, mirrored at the plane through 0 across `axis` (0 to 2). Throws InputError if the file is no frame.
  void mirror(int axis);
  /// Turns the particles about the origin. Throws InputError if the file is no frame.
  void turn(const Vector3& rotate_deg);
  double time_s() const { return time_s_; }
  bool is_frame() const { return !mesh_; }
  /// A closed surface: of the particles (as splat_surface, `spacing_m` 0 is measured), of tetrahedra, or the triangles of the file.
  Mesh surface(double spacing_m = 0) const;
  /// Particles of the frame that is shown. Throws InputError if the run is not known, or has no such frame.
  const Particles& particles() const;
  /// Results folder. Throws InputError if it is not known.
  const std::filesystem::path& results() const;
  /// Adds fields of the particles to a mesh in the same space. Throws InputError if the particles are of another run or time.
  void add_fields(Mesh& mesh, const std::vector<MeshField>& fields) const;
  /// Ensures that the mesh has the scalar `name`, its own or that of the particles. Throws InputError with the nearest name.
  void provide(Mesh& mesh, const std::string& name) const;
  /// Throws InputError that there is no scalar `name`, with the nearest name among `fields`.
  [[noreturn]] void refuse_field(const std::string& name, const std::vector<MeshField>& fields) const;

 private:
  std::filesystem::path file_, results_;
  int threads_;
  double time_s_ = 0;
  std::optional<Mesh> mesh_;
  mutable std::optional<Particles> particles_;  ///< read when first asked for
};

/// Length of the diagonal of the box around points x, y, z; 0 if there is none.
double diameter(const std::vector<double>& points);

}  // namespace bake

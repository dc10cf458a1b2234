// SPDX-License-Identifier: MIT
// Meshes of triangles or tetrahedra with fields at their vertices, as VTKHDF 1.0 files that ParaView and VTK 9.1 open as they are.
//
// A mesh of tetrahedra whose vertices are to be particles carries the field `volume` [m^3]; such a file is a particles file, too
// (see particles_file.h): particle i is vertex i.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/io/hdf5.h"

namespace bake {

/// A quantity with `components` numbers at each vertex.
struct MeshField {
  std::string name;
  std::string unit;
  std::size_t components = 1;
  std::vector<double> values;
};

/// The field `name`, or nullptr if there is none.
const MeshField* find_field(const std::vector<MeshField>& fields, std::string_view name);

struct Mesh {
  std::size_t corners = 3;          ///< of a cell: 3 triangles, 4 tetrahedra
  std::vector<double> points;       ///< x, y, z of each vertex [m]
  std::vector<std::int64_t> cells;  ///< `corners` vertices each; triangles counter-clockwise from outside, tetrahedra of positive volume
  std::vector<MeshField> fields;    ///< at the vertices; stored in single precision but for `volume`
  double time_s = 0;                ///< time of the frame that the mesh shows

  std::size_t vertex_count() const { return points.size() / 3; }
  std::size_t cell_count() const { return cells.size() / corners; }
  const MeshField* find(std::string_view name) const { return find_field(fields, name); }
};

/// Writes the mesh completely or not at all. Points are stored in double precision. Throws OutputError, and std::invalid_argument if
/// lengths do not fit.
void write_mesh(const std::filesystem::path& path, const Mesh& mesh);
/// The same, to be committed.
std::shared_ptr<AtomicFile> written_mesh(const std::filesystem::path& path, const Mesh& mesh);

/// Reads a mesh. Throws InputError if the file is missing, damaged or not a mesh, if cells are of mixed or other kinds, if a corner is no
/// vertex, or if an array has the wrong length.
Mesh read_mesh(const std::filesystem::path& path);

/// A field at the points of a mesh or of a frame. Throws InputError.
MeshField read_field(const Hdf5Reader& file, const std::string& name);

}  // namespace bake

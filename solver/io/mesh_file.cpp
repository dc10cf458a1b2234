// SPDX-License-Identifier: MIT
#include "solver/io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "solver/core/errors.h"
#include "solver/io/vtkhdf.h"

namespace bake {
namespace {

constexpr std::uint8_t k_triangle = 5, k_tetrahedron = 10;  ///< VTK's numbers

void check_lengths(const Mesh& mesh) {
  if (mesh.corners != 3 && mesh.corners != 4) throw std::invalid_argument("a mesh's cells have 3 or 4 corners");
  if (mesh.points.size() % 3 != 0 || mesh.cells.size() % mesh.corners != 0) throw std::invalid_argument("a mesh has half a vertex or cell");
  for (const MeshField& field : mesh.fields)
    if (field.components == 0 || field.values.size() != field.components * mesh.vertex_count())
      throw std::invalid_argument(fmt::format("mesh field {} has {} numbers for {} vertices of {} components", field.name,
                                              field.values.size(), mesh.vertex_count(), field.components));
}

template <class T>
PackedArray packed(std::span<const T> values, std::size_t components) {
  return pack({components == 1 ? array_view(values) : table_view(values, components)}).front();
}

void write_field(Hdf5Writer& out, const MeshField& field) {
  if (field.name == "volume") return write_vtk_field(out, field.name, field.unit, packed<double>(field.values, field.components));
  const std::vector<float> values(field.values.begin(), field.values.end());
  write_vtk_field(out, field.name, field.unit, packed<float>(values, field.components));
}

void check_cells(const std::filesystem::path& path, const Mesh& mesh) {
  const auto vertices = static_cast<std::int64_t>(mesh.vertex_count());
  const auto bad = std::find_if(mesh.cells.begin(), mesh.cells.end(), [&](std::int64_t v) { return v < 0 || v >= vertices; });
  if (bad != mesh.cells.end())
    throw InputError(fmt::format("{}: cell {}: found vertex {}, allowed: 0 to {}", path.string(),
                                 static_cast<std::size_t>(bad - mesh.cells.begin()) / mesh.corners, *bad, vertices - 1));
}

}  // namespace

const MeshField* find_field(const std::vector<MeshField>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const MeshField& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

MeshField read_field(const Hdf5Reader& file, const std::string& name) {
  const std::string dataset = std::string(k_vtk_fields) + "/" + name;
  const auto shape = file.shape(dataset);
  const std::size_t components = shape.size() == 1 ? 1 : shape.at(1);
  return {name, file.has_attribute(dataset, "unit") ? file.attribute<std::string>(dataset, "unit") : std::string(), components,
          shape.size() == 1 ? file.array<double>(dataset) : file.table<double>(dataset, components)};
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh) { written_mesh(path, mesh)->commit(); }

std::shared_ptr<AtomicFile> written_mesh(const std::filesystem::path& path, const Mesh& mesh) {
  check_lengths(mesh);
  auto file = std::make_shared<AtomicFile>(path);
  Hdf5Writer out(*file);
  write_vtk_head(out, mesh.time_s);
  write_vtk_points(out, pack({table_view<double>(mesh.points, 3)}).front());

  std::vector<std::int64_t> offsets(mesh.cell_count() + 1);
  for (std::size_t c = 0; c < offsets.size(); ++c) offsets[c] = static_cast<std::int64_t>(c * mesh.corners);
  const std::vector<std::uint8_t> types(mesh.cell_count(), mesh.corners == 3 ? k_triangle : k_tetrahedron);
  const auto count = [](std::size_t n) { return std::array{static_cast<std::int64_t>(n)}; };
  out.array<std::int64_t>("VTKHDF/NumberOfPoints", count(mesh.vertex_count()));
  out.array<std::int64_t>("VTKHDF/NumberOfCells", count(mesh.cell_count()));
  out.array<std::int64_t>("VTKHDF/NumberOfConnectivityIds", count(mesh.cells.size()));
  out.array<std::int64_t>("VTKHDF/Connectivity", mesh.cells, Packing::shuffle_gzip);
  out.array<std::int64_t>("VTKHDF/Offsets", offsets, Packing::shuffle_gzip);
  out.array<std::uint8_t>("VTKHDF/Types", types, Packing::shuffle_gzip);
  for (const MeshField& field : mesh.fields) write_field(out, field);
  out.close();
  return file;
}

Mesh read_mesh(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  if (!file.has("VTKHDF/Types")) throw InputError(fmt::format("{}: not a mesh, allowed: a file that bake-mesh wrote", path.string()));
  const auto types = file.array<std::uint8_t>("VTKHDF/Types");
  const std::uint8_t kind = types.empty() ? k_triangle : types.front();
  if ((kind != k_triangle && kind != k_tetrahedron) || std::any_of(types.begin(), types.end(), [&](auto type) { return type != kind; }))
    throw InputError(fmt::format("{}: found cells of other kinds, allowed: all triangles or all tetrahedra", path.string()));
  Mesh mesh;
  mesh.corners = kind == k_triangle ? 3 : 4;
  mesh.points = file.table<double>("VTKHDF/Points", 3);
  mesh.cells = file.array<std::int64_t>("VTKHDF/Connectivity");
  if (mesh.cells.size() != types.size() * mesh.corners)
    throw InputError(fmt::format("{}: Connectivity: found {} corners for {} cells", path.string(), mesh.cells.size(), types.size()));
  check_cells(path, mesh);
  if (file.has_attribute("VTKHDF", "time_s")) mesh.time_s = file.attribute<double>("VTKHDF", "time_s");
  for (const std::string& name : file.names(k_vtk_fields)) {
    mesh.fields.push_back(read_field(file, name));
    const MeshField& field = mesh.fields.back();
    if (field.values.size() != field.components * mesh.vertex_count())
      throw InputError(fmt::format("{}: {}: found {} rows for {} vertices", path.string(), name, field.values.size() / field.components,
                                   mesh.vertex_count()));
  }
  return mesh;
}

}  // namespace bake

// SPDX-License-Identifier: MIT
// The common parts of frames and meshes as VTKHDF 1.0 files: the header of an unstructured grid, and fields at its points.
#pragma once

#include <array>

#include "solver/io/hdf5.h"

namespace bake {

inline constexpr const char* k_vtk_fields = "VTKHDF/PointData";

/// Writes the group and its attributes; call it first.
inline void write_vtk_head(Hdf5Writer& out, double time_s) {
  out.group(k_vtk_fields);
  out.attribute("VTKHDF", "Version", std::array<std::int64_t, 2>{1, 0});
  out.attribute("VTKHDF", "Type", "UnstructuredGrid");
  out.attribute("VTKHDF", "time_s", time_s);
}

/// x, y, z of each point [m].
template <Hdf5Number T>
void write_vtk_points(Hdf5Writer& out, std::span<const T> points) {
  out.table("VTKHDF/Points", points, 3, Packing::shuffle_gzip);
  out.attribute("VTKHDF/Points", "unit", "m");
}

/// A field, `components` numbers per point.
template <Hdf5Number T>
void write_vtk_field(Hdf5Writer& out, const std::string& field, std::string_view unit, std::span<const T> values, std::size_t components) {
  const std::string name = std::string(k_vtk_fields) + "/" + field;
  if (components == 1)
    out.array(name, values, Packing::shuffle_gzip);
  else
    out.table(name, values, components, Packing::shuffle_gzip);
  out.attribute(name, "unit", unit);
}

}  // namespace bake

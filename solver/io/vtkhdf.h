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
inline void write_vtk_points(Hdf5Writer& out, const PackedArray& points) {
  out.packed("VTKHDF/Points", points);
  out.attribute("VTKHDF/Points", "unit", "m");
}

/// A field: one number per point, or a row of several.
inline void write_vtk_field(Hdf5Writer& out, const std::string& field, std::string_view unit, const PackedArray& values) {
  const std::string name = std::string(k_vtk_fields) + "/" + field;
  out.packed(name, values);
  out.attribute(name, "unit", unit);
}

}  // namespace bake

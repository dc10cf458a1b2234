// SPDX-License-Identifier: MIT
// Packs surfaces, particles and fields into few bytes, from which viewer.js makes them again.
//
// Positions are whole steps of a cube that holds all bodies at all times, 12 bits along each axis: 0.3 mm of a loaf of 1.3 m. Fields have 8
// bits over a range; 0 stands for nothing there. What differs little from what is before it is stored as the difference. Numbers of two
// bytes stand as all low bytes, then all high ones. Each piece is deflated by itself [RFC 1951], so that it can be unpacked when it is
// first looked at.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/io/mesh_file.h"

namespace bake::report {

using Bytes = std::vector<std::uint8_t>;

/// The steps of positions: codes 0 to k_steps stand for low to low + span along each axis.
struct Cube {
  std::array<double, 3> low = {0, 0, 0};
  double span = 1;  ///< [m], above 0
  static constexpr int k_steps = 4094;
  static constexpr std::uint16_t k_absent = 4095;  ///< of a particle that is not there

  /// The nearest code; what is outside gets that of the nearest side.
  std::uint16_t code(double position, std::size_t axis) const;
};

/// The steps of a field: codes 1 to 255 stand for low to high.
struct FieldSteps {
  double low = 0, high = 1;
  static constexpr int k_steps = 254;

  /// The nearest code; that of the nearer end for what is outside the range, 1 for what is not a number.
  std::uint8_t code(double value) const;
};

/// What a mesh of triangles becomes: three corners of each triangle, positions by axis, the fields named in `steps`, in their order.
/// Vertices are renumbered in the order in which triangles need them; a corner is stored as how far it is below the next new vertex. Throws
/// std::invalid_argument if there are more than 65536 vertices, or if a vertex is no corner; InputError, which names `file`, if a field is
/// missing.
Bytes packed_mesh(const Mesh& mesh, const Cube& cube, const std::vector<std::pair<std::string, FieldSteps>>& steps,
                  const std::string& file);

/// The particles of a frame in codes, each at the place of its identity.
struct ParticleCodes {
  std::vector<std::array<std::uint16_t, 3>> positions;  ///< k_absent along all axes if it is not there
  std::vector<std::vector<std::uint8_t>> fields;        ///< for each field one code a particle; 0 if it is not there
};

/// Differences from the frame before, or from the particle before if `before` is null. Both have the same particles and fields.
Bytes packed_particles(const ParticleCodes& now, const ParticleCodes* before);

/// Codes of fields at the nodes of a grid, x running fastest: for each field the differences along that order.
Bytes packed_fields(const std::vector<std::vector<std::uint8_t>>& fields);

/// A raw deflate stream [RFC 1951].
Bytes deflated(const Bytes& bytes);

}  // namespace bake::report

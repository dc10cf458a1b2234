// SPDX-License-Identifier: MIT
#include "experiments/report/pack.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

#include "solver/core/errors.h"

namespace bake::report {
namespace {

/// A difference of either sign as a number without: 0, -1, 1, -2, 2 become 0, 1, 2, 3, 4.
std::uint16_t zigzag(int difference) { return static_cast<std::uint16_t>(difference < 0 ? -2 * difference - 1 : 2 * difference); }

/// All low bytes, then all high ones.
void put_planes(Bytes& bytes, const std::vector<std::uint16_t>& numbers) {
  for (const std::uint16_t n : numbers) bytes.push_back(static_cast<std::uint8_t>(n & 255));
  for (const std::uint16_t n : numbers) bytes.push_back(static_cast<std::uint8_t>(n >> 8));
}

void put_differences(Bytes& bytes, const std::vector<std::uint8_t>& codes) {
  std::uint8_t before = 0;
  for (const std::uint8_t code : codes) {
    bytes.push_back(static_cast<std::uint8_t>(code - before));
    before = code;
  }
}

}  // namespace

std::uint16_t Cube::code(double position, std::size_t axis) const {
  return static_cast<std::uint16_t>(std::lround(std::clamp((position - low[axis]) / span, 0.0, 1.0) * k_steps));
}

std::uint8_t FieldSteps::code(double value) const {
  const double share = high > low ? (value - low) / (high - low) : 0;
  return static_cast<std::uint8_t>(1 + (std::isnan(share) ? 0 : std::lround(std::clamp(share, 0.0, 1.0) * k_steps)));
}

Bytes packed_mesh(const Mesh& mesh, const Cube& cube, const std::vector<std::pair<std::string, FieldSteps>>& steps,
                  const std::string& file) {
  if (mesh.vertex_count() > 65536) throw std::invalid_argument("a mesh of more than 65536 vertices cannot be packed");
  std::vector<std::int64_t> place(mesh.vertex_count(), -1);  // of each vertex in the new order
  std::vector<std::size_t> order;
  std::vector<std::uint16_t> corners;
  for (const std::int64_t corner : mesh.cells) {
    const auto vertex = static_cast<std::size_t>(corner);
    const auto next = static_cast<std::int64_t>(order.size());
    if (place[vertex] < 0) {
      place[vertex] = next;
      order.push_back(vertex);
    }
    corners.push_back(static_cast<std::uint16_t>(next - place[vertex]));
  }
  if (order.size() != mesh.vertex_count()) throw std::invalid_argument("a vertex that is no corner cannot be packed");
  Bytes bytes;
  put_planes(bytes, corners);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::uint16_t> differences;
    int before = 0;
    for (const std::size_t vertex : order) {
      const int code = cube.code(mesh.points[3 * vertex + axis], axis);
      differences.push_back(zigzag(code - before));
      before = code;
    }
    put_planes(bytes, differences);
  }
  for (const auto& [name, range] : steps) {
    const MeshField* field = mesh.find(name);
    if (!field || field->components != 1) throw InputError(fmt::format("{}: has no field '{}': make the figure again", file, name));
    std::vector<std::uint8_t> codes;
    codes.reserve(order.size());
    for (const std::size_t vertex : order) codes.push_back(range.code(field->values[vertex]));
    put_differences(bytes, codes);
  }
  return bytes;
}

Bytes packed_particles(const ParticleCodes& now, const ParticleCodes* before) {
  Bytes bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::uint16_t> differences;
    int last = 0;
    for (std::size_t i = 0; i < now.positions.size(); ++i) {
      if (before) last = before->positions[i][axis];
      differences.push_back(zigzag(now.positions[i][axis] - last));
      last = now.positions[i][axis];
    }
    put_planes(bytes, differences);
  }
  for (std::size_t f = 0; f < now.fields.size(); ++f) {
    std::vector<std::uint8_t> codes = now.fields[f];
    if (!before) {
      put_differences(bytes, codes);
      continue;
    }
    for (std::size_t i = 0; i < codes.size(); ++i) bytes.push_back(static_cast<std::uint8_t>(codes[i] - before->fields[f][i]));
  }
  return bytes;
}

Bytes packed_fields(const std::vector<std::vector<std::uint8_t>>& fields) {
  Bytes bytes;
  for (const auto& codes : fields) put_differences(bytes, codes);
  return bytes;
}

Bytes deflated(const Bytes& bytes) {
  constexpr int k_level = 12;  // the smallest that there is: it is unpacked a thousand times
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(libdeflate_alloc_compressor(k_level),
                                                                                                 libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  Bytes out(libdeflate_deflate_compress_bound(compressor.get(), bytes.size()));
  out.resize(libdeflate_deflate_compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

}  // namespace bake::report

// SPDX-License-Identifier: MIT
#include "solver/io/frames.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "solver/core/errors.h"
#include "solver/io/vtkhdf.h"

namespace bake {
namespace {

constexpr std::uint8_t k_poly_vertex = 2;  ///< VTK_POLY_VERTEX

std::size_t length(const FrameColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

void check_lengths(const FrameData& frame) {
  if (frame.positions.size() % 3 != 0) throw std::invalid_argument("a frame's positions are not x, y, z triples");
  const auto particles = frame.positions.size() / 3;
  for (const auto& column : frame.columns) {
    if (column.components == 0 || length(column) != column.components * particles) {
      throw std::invalid_argument(fmt::format("frame column {} has {} numbers for {} particles of {} components", column.name,
                                              length(column), particles, column.components));
    }
  }
}

/// Writes the cells as VTK requires them: a single one, made of all particles.
void write_cell(Hdf5Writer& out, std::size_t particles) {
  const auto count = static_cast<std::int64_t>(particles);
  std::vector<std::int64_t> connectivity(particles);
  std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
  const auto write = [&](const char* name, std::span<const std::int64_t> values) {
    out.array<std::int64_t>(std::string("VTKHDF/") + name, values, Packing::shuffle_gzip);
  };
  write("NumberOfPoints", std::array{count});
  write("NumberOfCells", std::array{std::int64_t{1}});
  write("NumberOfConnectivityIds", std::array{count});
  write("Connectivity", connectivity);
  write("Offsets", std::array{std::int64_t{0}, count});
  out.array<std::uint8_t>("VTKHDF/Types", std::array{k_poly_vertex});
}

void write_column(Hdf5Writer& out, const FrameColumn& column) {
  std::visit([&](const auto& values) { write_vtk_field(out, column.name, column.unit, std::span(values), column.components); },
             column.values);
}

}  // namespace

std::string frame_name(int frame) { return fmt::format("{:04}.hdf", frame); }

void write_frame(const std::filesystem::path& path, double time_s, const FrameData& frame) {
  check_lengths(frame);
  AtomicFile file(path);
  Hdf5Writer out(file);
  write_vtk_head(out, time_s);
  write_vtk_points(out, std::span(frame.positions));
  write_cell(out, frame.positions.size() / 3);
  for (const auto& column : frame.columns) write_column(out, column);
  out.close();
  file.commit();
}

FrameReader::FrameReader(const std::filesystem::path& path) : file_(path) {
  if (!file_.has("VTKHDF/Points") || !file_.has_attribute("VTKHDF", "time_s"))
    throw InputError(fmt::format("{}: not a frame, allowed: a file that bake run wrote into frames/", path.string()));
  time_s_ = file_.attribute<double>("VTKHDF", "time_s");
  particles_ = file_.shape("VTKHDF/Points").at(0);
}

bool FrameReader::has(const std::string& column) const { return file_.has("VTKHDF/PointData/" + column); }

std::vector<float> FrameReader::positions() const { return file_.table<float>("VTKHDF/Points", 3); }

std::vector<float> FrameReader::column(const std::string& name, std::size_t components) const {
  if (!has(name)) throw InputError(fmt::format("{}: found no column {}: the effect that makes it is off", file_.path().string(), name));
  const std::string dataset = "VTKHDF/PointData/" + name;
  return components == 1 ? file_.array<float>(dataset) : file_.table<float>(dataset, components);
}

std::vector<std::int64_t> FrameReader::identities() const { return file_.array<std::int64_t>("VTKHDF/PointData/id"); }

std::vector<std::int64_t> FrameReader::rows_by_identity(std::int64_t first, std::size_t count) const {
  std::vector<std::int64_t> rows(count, -1);
  const auto ids = identities();
  for (std::size_t row = 0; row < ids.size(); ++row) {
    const std::int64_t i = ids[row] - first;
    if (i >= 0 && i < static_cast<std::int64_t>(count)) rows[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(row);
  }
  return rows;
}

void write_series(const std::filesystem::path& path, const std::vector<SeriesEntry>& entries) {
  auto files = nlohmann::ordered_json::array();
  for (const auto& entry : entries) files.push_back({{"name", entry.file}, {"time", entry.time_s}});
  write_text_atomically(path, nlohmann::ordered_json{{"file-series-version", "1.0"}, {"files", files}}.dump(1) + "\n");
}

}  // namespace bake

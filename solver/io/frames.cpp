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

constexpr std::uint8_t k_vertex = 1;  ///< VTK_VERTEX

std::size_t length(const FrameColumn& column) {
  return std::visit([](const auto& values) { return values.size(); }, column.values);
}

std::size_t count_of(const FrameData& frame) {
  return std::visit([](const auto& numbers) { return numbers.size(); }, frame.positions);
}

void check_lengths(const FrameData& frame) {
  if (count_of(frame) % 3 != 0) throw std::invalid_argument("a frame's positions are not x, y, z triples");
  const auto particles = count_of(frame) / 3;
  for (const auto& column : frame.columns) {
    if (column.components == 0 || length(column) != column.components * particles) {
      throw std::invalid_argument(fmt::format("frame column {} has {} numbers for {} particles of {} components", column.name,
                                              length(column), particles, column.components));
    }
  }
}

/// Writes the cells as VTK requires them: a vertex for each particle, so that ParaView's Threshold, which asks cells, finds particles.
void write_cells(Hdf5Writer& out, const PackedFrame& frame) {
  const auto count = static_cast<std::int64_t>(frame.particles);
  const auto write = [&](const char* name, std::span<const std::int64_t> values) {
    out.array<std::int64_t>(std::string("VTKHDF/") + name, values, Packing::shuffle_gzip);
  };
  write("NumberOfPoints", std::array{count});
  write("NumberOfCells", std::array{count});
  write("NumberOfConnectivityIds", std::array{count});
  out.packed("VTKHDF/Connectivity", *frame.connectivity);
  out.packed("VTKHDF/Offsets", *frame.offsets);
  out.packed("VTKHDF/Types", *frame.types);
}

ArrayView view(const FrameColumn& column) {
  const auto of = [&]<class T>(const std::vector<T>& values) {
    return column.components == 1 ? array_view<T>(values) : table_view<T>(values, column.components);
  };
  return std::visit(of, column.values);
}

ArrayView view_of_positions(const FrameData& frame) {
  return std::visit([]<class T>(const std::vector<T>& numbers) { return table_view<T>(numbers, 3); }, frame.positions);
}

}  // namespace

PackedFrame FramePacker::pack(double time_s, const FrameData& frame) {
  check_lengths(frame);
  const std::size_t particles = count_of(frame) / 3;
  const bool same_particles = frame.members && frame.members == members_;
  const auto is_whole = [](const FrameColumn& column) { return std::holds_alternative<std::vector<std::int64_t>>(column.values); };
  std::vector<ArrayView> arrays{view_of_positions(frame)};
  for (const FrameColumn& column : frame.columns)
    if (!is_whole(column)) arrays.push_back(view(column));
  const std::size_t changing = arrays.size();
  std::vector<std::int64_t> counting;
  std::vector<std::uint8_t> types;
  if (!same_particles) {
    counting.resize(particles + 1);
    std::iota(counting.begin(), counting.end(), std::int64_t{0});
    types.assign(particles, k_vertex);
    arrays.push_back(array_view<std::int64_t>(std::span(counting).first(particles)));
    arrays.push_back(array_view<std::int64_t>(counting));
    arrays.push_back(array_view<std::uint8_t>(types));
    for (const FrameColumn& column : frame.columns)
      if (is_whole(column)) arrays.push_back(view(column));
  }
  std::vector<PackedFrame::Array> packed;
  for (PackedArray& array : bake::pack(arrays)) packed.push_back(std::make_shared<const PackedArray>(std::move(array)));
  if (!same_particles) kept_.assign(packed.begin() + static_cast<std::ptrdiff_t>(changing), packed.end());
  members_ = frame.members;
  PackedFrame all{time_s, particles, packed[0], kept_[0], kept_[1], kept_[2], {}};
  std::size_t next = 1, next_kept = 3;
  for (const FrameColumn& column : frame.columns)
    all.columns.push_back({column.name, column.unit, is_whole(column) ? kept_.at(next_kept++) : packed[next++]});
  return all;
}

std::string frame_name(int frame) { return fmt::format("{:04}.hdf", frame); }

void write_frame(const std::filesystem::path& path, const PackedFrame& frame) {
  AtomicFile file(path);
  Hdf5Writer out(file);
  write_vtk_head(out, frame.time_s);
  write_vtk_points(out, *frame.positions);
  write_cells(out, frame);
  for (const PackedFrame::Column& column : frame.columns) write_vtk_field(out, column.name, column.unit, *column.values);
  out.close();
  file.commit();
}

void write_frame(const std::filesystem::path& path, double time_s, const FrameData& frame) {
  write_frame(path, FramePacker().pack(time_s, frame));
}

FrameReader::FrameReader(const std::filesystem::path& path) : file_(path) {
  if (!file_.has("VTKHDF/Points") || !file_.has_attribute("VTKHDF", "time_s"))
    throw InputError(fmt::format("{}: not a frame, allowed: a file that bake run wrote into frames/", path.string()));
  time_s_ = file_.attribute<double>("VTKHDF", "time_s");
  particles_ = file_.shape("VTKHDF/Points").at(0);
}

bool FrameReader::has(const std::string& column) const { return file_.has("VTKHDF/PointData/" + column); }

std::vector<double> FrameReader::positions() const { return file_.table<double>("VTKHDF/Points", 3); }

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

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

void check_lengths(const FrameData& frame, std::size_t particles) {
  if (count_of(frame) != 0 && count_of(frame) != 3 * particles) throw std::invalid_argument("a frame's positions are not x, y, z triples");
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
  PackedFrame packed = begin(time_s, count_of(frame) / 3, frame.members);
  add(frame, packed);
  return packed;
}

PackedFrame FramePacker::pack(double time_s, std::size_t particles, const std::optional<std::pair<std::size_t, std::size_t>>& members,
                              std::size_t parts, const std::function<FrameData(std::size_t part)>& part_of) {
  PackedFrame packed = begin(time_s, particles, members);
  for (std::size_t part = 0; part < parts; ++part) add(part_of(part), packed);
  return packed;
}

PackedFrame FramePacker::begin(double time_s, std::size_t particles, const std::optional<std::pair<std::size_t, std::size_t>>& members) {
  same_particles_ = members && members == members_;
  members_ = members;
  if (!same_particles_) {
    kept_.clear();
    std::vector<std::int64_t> counting(particles + 1);
    std::iota(counting.begin(), counting.end(), std::int64_t{0});
    const std::vector<std::uint8_t> types(particles, k_vertex);
    for (PackedArray& array : bake::pack({array_view<std::int64_t>(std::span(counting).first(particles)),
                                          array_view<std::int64_t>(counting), array_view<std::uint8_t>(types)}))
      kept_.push_back(std::make_shared<const PackedArray>(std::move(array)));
  }
  next_kept_ = 3;
  return {time_s, particles, nullptr, kept_[0], kept_[1], kept_[2], {}};
}

void FramePacker::add(const FrameData& part, PackedFrame& frame) {
  check_lengths(part, frame.particles);
  const auto is_kept = [&](const FrameColumn& column) {
    return same_particles_ && std::holds_alternative<std::vector<std::int64_t>>(column.values);
  };
  std::vector<ArrayView> arrays;
  const bool has_positions = !frame.positions && (count_of(part) > 0 || frame.particles == 0);
  if (has_positions) arrays.push_back(view_of_positions(part));
  for (const FrameColumn& column : part.columns)
    if (!is_kept(column)) arrays.push_back(view(column));
  std::vector<PackedFrame::Array> packed;
  for (PackedArray& array : bake::pack(arrays)) packed.push_back(std::make_shared<const PackedArray>(std::move(array)));
  auto next = packed.begin();
  if (has_positions) frame.positions = *next++;
  for (const FrameColumn& column : part.columns) {
    const bool is_whole = std::holds_alternative<std::vector<std::int64_t>>(column.values);
    if (is_whole && !same_particles_) kept_.push_back(*next);
    frame.columns.push_back({column.name, column.unit, is_kept(column) ? kept_.at(next_kept_) : *next++});
    next_kept_ += is_whole;
  }
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

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

bool is_whole(const FrameColumn& column) { return std::holds_alternative<std::vector<std::int64_t>>(column.values); }

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

struct FrameWriter::Unfinished {
  std::filesystem::path path;
  double time_s;
  std::size_t particles;
  Members members;
  std::shared_ptr<AtomicFile> file;
  std::optional<Hdf5Writer> out;
  bool has_positions = false;
};

std::shared_ptr<AtomicFile> FrameWriter::write(const std::filesystem::path& path, double time_s, const FrameData& frame) {
  Unfinished unfinished = begin(path, time_s, count_of(frame) / 3, frame.members);
  add(frame, unfinished);
  return end(unfinished);
}

std::shared_ptr<AtomicFile> FrameWriter::write(const std::filesystem::path& path, double time_s, std::size_t particles,
                                               const Members& members, std::size_t parts,
                                               const std::function<FrameData(std::size_t part)>& part_of) {
  Unfinished unfinished = begin(path, time_s, particles, members);
  for (std::size_t part = 0; part < parts; ++part) add(part_of(part), unfinished);
  return end(unfinished);
}

FrameWriter::Unfinished FrameWriter::begin(const std::filesystem::path& path, double time_s, std::size_t particles,
                                           const Members& members) {
  same_particles_ = members && members == members_;
  members_.reset();  // until this one is whole
  next_kept_ = 0;
  if (!same_particles_) {
    kept_.clear();
    std::vector<std::int64_t> counting(particles + 1);
    std::iota(counting.begin(), counting.end(), std::int64_t{0});
    const std::vector<std::uint8_t> types(particles, k_vertex);
    keep({array_view<std::int64_t>(std::span(counting).first(particles)), array_view<std::int64_t>(counting),
          array_view<std::uint8_t>(types)});
  }
  return {path, time_s, particles, members, nullptr, {}};
}

void FrameWriter::keep(const std::vector<ArrayView>& arrays) {
  for (PackedArray& array : bake::pack(arrays)) kept_.push_back(std::move(array));
}

void FrameWriter::add(const FrameData& part, Unfinished& frame) {
  check_lengths(part, frame.particles);
  std::vector<ArrayView> arrays, whole;
  std::vector<const FrameColumn*> columns;  // of the arrays; none is that of the positions
  if (!frame.has_positions && (count_of(part) > 0 || frame.particles == 0)) {
    frame.has_positions = true;
    arrays.push_back(view_of_positions(part));
    columns.push_back(nullptr);
  }
  for (const FrameColumn& column : part.columns) {
    (is_whole(column) ? whole : arrays).push_back(view(column));
    if (!is_whole(column)) columns.push_back(&column);
  }
  if (!same_particles_) keep(whole);
  const auto write_whole_numbers = [&] {
    for (const FrameColumn& column : part.columns)
      if (is_whole(column)) write_vtk_field(*frame.out, column.name, column.unit, kept_.at(next_kept_++));
  };
  bake::pack(arrays, [&](std::size_t a, const PackedArray& packed) {
    if (!frame.out) write_head(frame);
    if (columns[a])
      write_vtk_field(*frame.out, columns[a]->name, columns[a]->unit, packed);
    else
      write_vtk_points(*frame.out, packed);
    if (a == 0) write_whole_numbers();
  });
  if (!arrays.empty()) return;
  if (!frame.out) write_head(frame);
  write_whole_numbers();
}

/// Creates the file, with what VTK asks of every frame: a vertex for each particle, so that ParaView's Threshold, which asks cells, finds
/// particles.
void FrameWriter::write_head(Unfinished& frame) {
  frame.file = std::make_shared<AtomicFile>(frame.path);
  Hdf5Writer& out = frame.out.emplace(*frame.file);
  write_vtk_head(out, frame.time_s);
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
    out.array<std::int64_t>(std::string("VTKHDF/") + name, std::array{static_cast<std::int64_t>(frame.particles)}, Packing::shuffle_gzip);
  for (const char* name : {"Connectivity", "Offsets", "Types"}) out.packed(std::string("VTKHDF/") + name, kept_.at(next_kept_++));
}

std::shared_ptr<AtomicFile> FrameWriter::end(Unfinished& frame) {
  frame.out->close();
  members_ = frame.members;
  return frame.file;
}

std::string frame_name(int frame) { return fmt::format("{:04}.hdf", frame); }

void write_frame(const std::filesystem::path& path, double time_s, const FrameData& frame) {
  FrameWriter().write(path, time_s, frame)->commit();
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

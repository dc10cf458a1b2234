// SPDX-License-Identifier: MIT
// Frames of a run: particles as VTKHDF 1.0 files, which ParaView 5.11 and VTK 9.1 open as they are, and that any HDF5 reader can read.
//
// Inside: group VTKHDF with Points [n, 3] in m (32 bits, or 64 where those would not tell particles apart: `stores_double_positions`), a
// vertex cell for each particle, PointData/<name> with an attribute `unit` each, and the simulated time as attribute `time_s` of
// VTKHDF. (VTKHDF's own time steps are unknown to VTK 9.1: times are given to ParaView by the series file.)
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "solver/io/hdf5.h"

namespace bake {

/// One quantity of all particles: `components` numbers per particle (1 scalar, 3 vector, 9 tensor by rows), particle by particle.
struct FrameColumn {
  std::string name;
  std::string unit;
  std::variant<std::vector<float>, std::vector<std::int64_t>> values;
  std::size_t components = 1;
};

/// Particles that there ever were, and that there are now: equal in frames of one run that have the same ones. None if not known.
using Members = std::optional<std::pair<std::size_t, std::size_t>>;

struct FrameData {
  std::variant<std::vector<float>, std::vector<double>> positions;  ///< x, y, z of each particle [m]; may be empty
  std::vector<FrameColumn> columns;
  Members members = {};
};

/// Whether a frame's positions need 64 bits: those of a run in double precision, and where the domain's farthest coordinate is so many node
/// distances from the origin that 32 bits do not resolve a thousandth of one.
constexpr bool stores_double_positions(bool double_run, double farthest_m, double dx_m) {
  constexpr double k_most = 1 << 14;  // 2^24 steps of a float up to there, 2^10 of them in a node distance
  return double_run || farthest_m > k_most * dx_m;
}

/// Writes the frames of a run with lossless compression: all threads pack, one of them writes meanwhile what is packed. Cells and columns
/// of whole numbers (id, material) are packed anew only when particles have come or gone: a third of the work.
class FrameWriter {
 public:
  /// A frame that is there as soon as it is committed, which waits for the disk. Throws OutputError, and std::invalid_argument if a
  /// column's length is not components x particles.
  std::shared_ptr<AtomicFile> write(const std::filesystem::path& path, double time_s, const FrameData& frame);
  /// The same from parts: their columns one after the other, positions in one of them, whatever their `members`. A part is made when it is
  /// packed, and then let go: a frame of many particles is never there as a whole.
  std::shared_ptr<AtomicFile> write(const std::filesystem::path& path, double time_s, std::size_t particles, const Members& members,
                                    std::size_t parts, const std::function<FrameData(std::size_t part)>& part_of);

 private:
  struct Unfinished;  ///< a frame between its first part and its last

  Unfinished begin(const std::filesystem::path& path, double time_s, std::size_t particles, const Members& members);
  void add(const FrameData& part, Unfinished& frame);
  void write_head(Unfinished& frame);
  std::shared_ptr<AtomicFile> end(Unfinished& frame);
  void keep(const std::vector<ArrayView>& arrays);

  bool same_particles_ = false;    ///< as those of the frame before
  std::size_t next_kept_ = 0;      ///< of the frame that is being written
  Members members_;                ///< of the last frame that was written
  std::vector<PackedArray> kept_;  ///< cells and whole numbers, in the order in which a frame has them
};

/// File name of a frame: 42 -> "0042.hdf". (ParaView recognises the format by this ending.)
std::string frame_name(int frame);

/// Writes one frame, completely or not at all. Throws OutputError.
void write_frame(const std::filesystem::path& path, double time_s, const FrameData& frame);

/// A frame that is read. Its particles have the order of the file, which differs from frame to frame: `rows_by_identity` finds a particle.
class FrameReader {
 public:
  /// Throws InputError if the file is missing, damaged or not a frame.
  explicit FrameReader(const std::filesystem::path& path);

  double time_s() const { return time_s_; }
  std::size_t particles() const { return particles_; }
  bool has(const std::string& column) const;
  std::vector<double> positions() const;  ///< x, y, z of each particle [m]
  /// A column, `components` numbers per particle. Throws InputError if there is none of that name and width.
  std::vector<float> column(const std::string& name, std::size_t components = 1) const;
  std::vector<std::int64_t> identities() const;
  /// Row of each particle first, first + 1, ..., first + count - 1; -1 for those that are not in the frame.
  std::vector<std::int64_t> rows_by_identity(std::int64_t first, std::size_t count) const;

 private:
  Hdf5Reader file_;
  double time_s_;
  std::size_t particles_;
};

struct SeriesEntry {
  std::string file;  ///< relative to the series file
  double time_s;
};

/// Writes the list that ParaView opens as an animation. `path` must end in ".hdf.series" for ParaView to recognise it.
void write_series(const std::filesystem::path& path, const std::vector<SeriesEntry>& entries);

}  // namespace bake

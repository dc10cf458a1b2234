// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "meshing/tets/tet_mesh.h"
#include "solver/io/frames.h"

namespace bake {

/// The frames of a finished run whose particles first, first + 1, ... are the vertices of a mesh.
class RunFrames {
 public:
  /// Throws InputError if there is no finished run, or if the particles of its first frame are not at the vertices.
  RunFrames(const std::filesystem::path& results, const std::vector<Point>& vertices, std::int64_t first_particle);

  double dx_m() const { return dx_m_; }  ///< node distance of the run
  int count() const { return static_cast<int>(times_s_.size()); }
  double time_s(int frame) const { return times_s_[frame]; }
  int nearest(double time_s) const;  ///< number of the frame nearest to a time

  /// Reads a frame: positions and rows. Particles that have left the run stay at their last position.
  void read(int frame);
  const std::vector<Point>& positions() const { return positions_; }
  /// A column of the frame read last, `components` numbers per vertex; empty if the run has none. Particles that have left: zero.
  std::vector<float> column(const std::string& name, std::size_t components) const;

 private:
  std::filesystem::path file(int frame) const { return folder_ / "frames" / frame_name(frame); }
  void check_first_frame(const std::vector<Point>& vertices) const;

  std::filesystem::path folder_;
  std::int64_t first_particle_;
  double dx_m_ = 0;
  std::vector<double> times_s_;
  std::vector<Point> positions_;
  std::vector<std::int64_t> rows_;
  std::vector<FrameReader> current_;  ///< one, once a frame has been read
};

}  // namespace bake

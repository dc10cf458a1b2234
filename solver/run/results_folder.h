// SPDX-License-Identifier: MIT
// The folder that a run writes into: which files are there, whose they are, and whether they are whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "solver/io/file_lock.h"
#include "solver/run/run.h"

namespace bake {

class FrameTimes;
struct Scene;

class ResultsFolder {
 public:
  explicit ResultsFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path frames() const { return folder_ / "frames"; }
  std::filesystem::path frame(int number) const;
  std::filesystem::path series() const { return folder_ / "frames.hdf.series"; }
  std::filesystem::path skins() const { return folder_ / "skins"; }
  std::filesystem::path skin(int number) const;  ///< the mesh of a frame's skins
  std::filesystem::path skin_series() const { return folder_ / "skins.hdf.series"; }
  std::filesystem::path ledger() const { return folder_ / "ledger.csv"; }
  std::filesystem::path checkpoint() const { return folder_ / "checkpoint.h5"; }
  std::filesystem::path description() const { return folder_ / "run.json"; }

  bool has_checkpoint() const;
  /// Whether the last run here is done, as run.json says.
  bool is_done() const;
  /// Where the scene of the last run here differs from this one in what its numbers follow from: "grid.dx_m: found 0.01, there 0.02"; empty
  /// if it does not, or if run.json is lost.
  std::string difference(const Scene& scene) const;

  /// Makes the folder, marks it as one that runs write into, and keeps other runs out as long as this object lives. Throws InputError if
  /// another process writes here, if something stands in the way that no run has made, or if here are results which `replace` protects: of
  /// other values, or of a run that was done later than `end_s` [s].
  void take(const Scene& scene, double end_s, Replace replace);
  /// Removes what former runs have written, and nothing else; then frames can be written.
  void clear() const;
  /// Makes the folder of the skins' meshes, for scenes that have some.
  void make_skins() const;
  /// Keeps other runs out of a folder with a checkpoint. Throws InputError if another process writes here.
  void take_to_resume();
  /// Removes frames behind this one.
  void remove_frames_behind(int last) const;

  /// Whether the folder is still the one that was taken, and nobody has removed or moved it.
  bool is_own() const { return lock_ && lock_->stands(); }

  /// Throws InputError unless frames 0 to `last` are whole and the ledger has their rows, of numbers.
  void expect_whole(const FrameTimes& times, int last) const;

 private:
  std::filesystem::path mark() const { return folder_ / ".bake-run"; }
  bool is_marked() const;
  void refuse_what_no_run_made() const;
  void refuse_to_replace(const Scene& scene, double end_s, Replace replace) const;

  std::filesystem::path folder_;
  std::optional<FileLock> lock_;
};

}  // namespace bake

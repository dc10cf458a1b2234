// SPDX-License-Identifier: MIT
// Runs a scene: writes frames, the ledger and checkpoints.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "solver/core/errors.h"

namespace bake {

struct Scene;

/// Which results may be replaced if they are done or can be resumed; what no run has written never is.
enum class Replace {
  same_scene,  ///< those of the same values, but for the end of the run
  same_file,   ///< those of a scene file of the same name
  any_run,
};

struct RunOptions {
  std::filesystem::path out;  ///< folder of the results; created if missing
  int threads = 0;            ///< 0: all cores
  bool resume = false;        ///< continue from the folder's checkpoint; without one begin, and say so
  bool quiet = false;
  std::optional<int> frames;              ///< ends the run after this many frames instead of at the scene's end
  Replace replace = Replace::same_scene;  ///< which old results it may replace, unless it resumes them
};

struct RunSummary {
  std::string text;          ///< for people
  bool interrupted = false;  ///< by SIGINT or SIGTERM; a checkpoint was written
};

/// Simulates the scene. Throws InputError (nothing was written), OutputError if the first frame cannot be written, RunError for all that
/// goes wrong later, full disks and lack of memory too (the last checkpoint is kept, run.json says "failed").
RunSummary run_scene(const Scene& scene, const RunOptions& options);

/// What `bake info` prints: effects, bodies (describe_bodies.h), particles, memory, and steps and time at each quality, estimated from a
/// short trial at the coarsest one that can be run; of the others it says why they cannot. Throws InputError if the scene's own quality
/// cannot. `threads` as in RunOptions.
std::string describe_scene(const Scene& scene, int threads = 0);

}  // namespace bake

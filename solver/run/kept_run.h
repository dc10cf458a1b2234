// SPDX-License-Identifier: MIT
// Results that are there already: are they those of a scene and of this solver?
#pragma once

#include <filesystem>

#include "solver/run/run.h"

namespace bake {

enum class KeptRun {
  none,        ///< nothing, or the results of another scene or solver
  unfinished,  ///< begun by this solver, with a checkpoint to go on from
  finished,
};

/// Speaks of the same scene with every default filled in (wherever its file is), at the same quality, and of the same solver: its sources
/// (commits that change only other rooms do not matter), compiler and flags. Threads do not matter: they do not change the results.
KeptRun kept_run(const Scene& scene, const std::filesystem::path& folder);

/// run_scene, but only what is missing of a folder whose run is as `kept` says: nothing if it is finished; from its checkpoint on if it is
/// unfinished. Throws as run_scene, and RunError if it was interrupted.
void complete_run(const Scene& scene, RunOptions options, KeptRun kept);

}  // namespace bake

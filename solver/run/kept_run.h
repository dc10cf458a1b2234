// SPDX-License-Identifier: MIT
// Recognises whether a folder already holds the results of a scene, made by this solver.
#pragma once

#include <filesystem>

#include "solver/run/run.h"

namespace bake {

enum class KeptRun {
  none,        ///< there are no results, or they belong to another scene or solver
  unfinished,  ///< the run was begun by this solver and has a checkpoint to resume from
  finished,
};

/// Compares the run in `folder` with the scene and with this program. The run counts if its scene has the same values (defaults included,
/// the place of its file aside) and the same quality, and if the solver was built from the same sources with the same compiler and flags.
/// Commits that change only other rooms do not matter. The number of threads does not matter, since it does not change the results.
KeptRun kept_run(const Scene& scene, const std::filesystem::path& folder);

/// Runs what is missing in a folder whose run is as `kept` says: nothing if the run is finished, the rest from the checkpoint if it is
/// unfinished, else all of it. Throws as run_scene, and RunError if the run is interrupted.
void complete_run(const Scene& scene, RunOptions options, KeptRun kept);

}  // namespace bake

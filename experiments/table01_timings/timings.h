// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/make/computed.h"

namespace bake {

/// Table 1: published timings beside those of the runs that are in ./results, or stored in experiments/table01_timings/measured.
Computed table01_timings();

/// The same with the published numbers of the sources in `root` and the runs in the folder `results`. Throws InputError.
Computed compare_timings(const std::filesystem::path& root, const std::filesystem::path& results);

}  // namespace bake

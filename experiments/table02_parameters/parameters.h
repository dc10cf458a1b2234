// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/make/computed.h"

namespace bake {

/// Table 2: every published parameter beside what the scene of that column states.
Computed table02_parameters();

/// The same of the sources in `root`: reference/published/table2.toml and table2_scenes.toml, and experiments/. Throws InputError.
Computed compare_parameters(const std::filesystem::path& root);

}  // namespace bake

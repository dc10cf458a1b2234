// SPDX-License-Identifier: MIT
// Scenes that come with Bake, as variants ask for them.
#pragma once

#include "experiments/accuracy/case.h"

namespace bake::studies::accuracy {

/// experiments/<name>.toml.
std::filesystem::path scene_path(const std::string& name);

/// The same read with dx = length / v.cells, the overrides of the case, then those of the variant. Throws InputError.
Scene scene_of_file(const std::string& name, double length, const Variant& v, const std::vector<std::string>& of_case = {});

}  // namespace bake::studies::accuracy

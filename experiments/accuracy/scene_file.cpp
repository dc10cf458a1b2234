// SPDX-License-Identifier: MIT
#include "experiments/accuracy/scene_file.h"

#include <fmt/format.h>

#include "solver/scene/reader.h"

namespace bake::studies::accuracy {

std::filesystem::path scene_path(const std::string& name) {
  return std::filesystem::path(BAKE_SOURCE_DIR) / "experiments" / (name + ".toml");
}

Scene scene_of_file(const std::string& name, double length, const Variant& v, const std::vector<std::string>& of_case) {
  ReadOptions options{Quality::paper, of_case};
  options.overrides.push_back(fmt::format("grid.dx_m={:.17g}", length / v.cells));
  options.overrides.insert(options.overrides.end(), v.overrides.begin(), v.overrides.end());
  if (v.per_cell > 0) options.overrides.push_back(fmt::format("body.0.particles_per_cell={}", v.per_cell));
  return read_scene(scene_path(name), options);
}

}  // namespace bake::studies::accuracy

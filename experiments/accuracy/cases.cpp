// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/accuracy/case.h"
#include "solver/core/errors.h"
#include "solver/scene/reader.h"

namespace bake::studies::accuracy {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases{
      heated_slab(), cooling_sphere(), barenblatt(), elastic_bar(), vortex(), drying_cube(), dough_pull(), rising_ball(), cookie(), bread(),
  };
  return cases;
}

const Case& find_case(const std::string& name) {
  const auto& all = all_cases();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Case& c) { return c.name == name; });
  if (at != all.end()) return *at;
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const Case& c : all) known.push_back(c.name);
  throw InputError(fmt::format("--case: found \"{}\", allowed: {}", name, fmt::join(known, ", ")));
}

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

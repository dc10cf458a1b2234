// SPDX-License-Identifier: MIT
#include "solver/scene/scene_builder.h"

#include <fmt/format.h>

#include <regex>

#include "solver/scene/reader.h"

namespace bake {

std::string SceneBuilder::text() const {
  std::string text = fmt::format("effects = [{}]\n", std::regex_replace(effects, std::regex("\\w+"), "\"$&\""));
  const auto add = [&](const char* table, const std::string& keys) {
    if (!keys.empty()) text += fmt::format("{}\n{}\n", table, keys);
  };
  const auto in_brackets = [](const Vector3& v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v[0], v[1], v[2]); };
  add("[run]", fmt::format("end_s = 1e9\nframe_rate_per_s = {:.17g}\nprecision = \"{}\"\n{}", 1 / frame_s, precision, run));
  add("[grid]", fmt::format("dx_m = {:.17g}\nkernel = \"{}\"", dx, kernel));
  add("[domain]", fmt::format("min_m = {}\nmax_m = {}\n{}", in_brackets(low), in_brackets(high), faces));
  add("[motion]", (gravity.empty() ? "" : fmt::format("gravity_m_per_s2 = {}\n", gravity)) + motion);
  add("[heat]", heat);
  add("[leavening]", leavening);
  add("[surface]", surface);
  add("[time]", time);
  add("[[material]]", "name = \"dough\"\n" + material);
  text += tables + "\n";
  if (!shape.empty())
    add("[[body]]",
        fmt::format("material = \"dough\"\nparticles_per_cell = {:.17g}\nshape = {{ {} }}\n{}", particles_per_cell, shape, body));
  return text;
}

Scene SceneBuilder::scene() const { return parse_scene(text(), "built.toml", {Quality::paper, overrides}); }

}  // namespace bake

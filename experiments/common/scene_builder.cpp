// SPDX-License-Identifier: MIT
#include "experiments/common/scene_builder.h"

#include <fmt/format.h>
#include <omp.h>

#include "solver/scene/reader.h"

namespace bake::studies {

Scene SceneBuilder::scene() const {
  const std::string text = fmt::format(R"(
effects = [{}]
[run]
end_s = 1e9
frame_rate_per_s = {:.17g}
precision = "double"
[grid]
dx_m = {:.17g}
kernel = "{}"
[domain]
min_m = [{:.17g}, {:.17g}, {:.17g}]
max_m = [{:.17g}, {:.17g}, {:.17g}]
{}
[surface]
{}
[time]
{}
[motion]
{}
[[material]]
name = "dough"
density_kg_per_m3 = 1
{}
{}
)",
                                       effects, 1 / end_s, dx, kernel, low[0], low[1], low[2], high[0], high[1], high[2], faces, surface,
                                       time, motion, material, tables);
  return parse_scene(text, "study.toml", {Quality::paper, overrides});
}

std::unique_ptr<Simulation> SceneBuilder::begin() const {
  omp_set_num_threads(threads);
  return Simulation::begin(scene());
}

void run_to(Simulation& simulation, double time) { simulation.advance(time, time); }

}  // namespace bake::studies

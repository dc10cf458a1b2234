// SPDX-License-Identifier: MIT
#include "solver/run/check_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "solver/run/fill_scene.h"
#include "solver/scene/reader.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// A ball near the corner of a domain whose faces are not round numbers.
Scene ball(double x, double y, double z, double radius, int seed) {
  const std::string text = R"(effects = ["heat"]
[run]
end_s = 1
[grid]
dx_m = 0.01
[domain]
min_m = [0.1, -0.3, 0.07]
max_m = [0.331, -0.1, 0.27]
[[material]]
name = "dough"
density_kg_per_m3 = 1000
specific_heat_J_per_kgK = 1000
conductivity_W_per_mK = 1
[[body]]
material = "dough"
)";
  const std::string shape = fmt::format("{{ sphere = {{ centre_m = [{}, {}, {}], radius_m = {} }} }}", x, y, z, radius);
  return parse_scene(text + "shape = " + shape, "ball.toml", {Quality::paper, {fmt::format("run.seed={}", seed)}});
}

TEST(CheckFilling, SaysOfEveryBallWhatFillingItSays) {
  std::mt19937 bits(7);
  const auto between = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  int refused = 0, empty = 0, taken = 0;
  for (int i = 0; i < 400; ++i) {
    const double radius = i % 4 == 0 ? between(0.0005, 0.004) : between(0.004, 0.04);
    const Scene scene = ball(between(0.1, 0.16), -0.2, 0.07 + radius + between(-0.01, 0.01), radius, i);
    const std::string said = message_of<InputError>([&] { fill_bodies(scene); });
    EXPECT_EQ(message_of<InputError>([&] { check_filling(scene); }), said);
    EXPECT_EQ(message_of<InputError>([&] { check_scene(scene); }), said);
    (said == "nothing was thrown" ? taken : said.find("found no particle") != std::string::npos ? empty : refused) += 1;
  }
  EXPECT_GT(std::min({refused, empty, taken}), 20);
}

}  // namespace
}  // namespace bake

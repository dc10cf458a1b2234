// SPDX-License-Identifier: MIT
// A run's peak memory is its own, whatever ran before in the process.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solver/run/run.h"
#include "solver/scene/scene_builder.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which hold back what was freed
double peak_of_a_run(double dx, const std::filesystem::path& folder) {
  SceneBuilder builder;
  builder.dx = dx;
  builder.frame_s = 1e-6;
  builder.material = "density_kg_per_m3 = 1000\nspecific_heat_J_per_kgK = 1000\nconductivity_W_per_mK = 1";
  builder.shape = "box = { half_extents_m = [0.8, 0.8, 0.8] }";
  RunOptions options;
  options.out = folder;
  options.quiet = true;
  options.frames = 1;
  run_scene(builder.scene(), options);
  return nlohmann::json::parse(contents(folder / "run.json")).at("summary").at("peak_memory_bytes");
}

TEST(PeakMemory, IsThatOfTheRun) {
  const TemporaryFolder folder;
  const double small = peak_of_a_run(0.1, folder / "small"), large = peak_of_a_run(0.04, folder / "large"),
               again = peak_of_a_run(0.1, folder / "again");
  EXPECT_GT(large, small + 50e6) << "half a million particles";
  EXPECT_LT(again, small + 0.2 * (large - small));
}
#endif

}  // namespace
}  // namespace bake

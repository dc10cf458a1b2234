// SPDX-License-Identifier: MIT
// Particles are sorted when one leaves its block, and again when that was long ago.
#include <gtest/gtest.h>

#include "solver/io/checkpoint.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// A cube so small and slow that all of its particles stay in their blocks, while many pass from cell to cell.
Scene drifting_cube(const char* effects) {
  SceneBuilder builder;
  builder.effects = effects;
  builder.precision = "single";
  builder.material =
      "density_kg_per_m3 = 1000\nyoung_modulus_Pa = 1e4\npoisson_ratio = 0.3\nspecific_heat_J_per_kgK = 1000\n"
      "conductivity_W_per_mK = 1";
  builder.time = "largest_step_s = 1e-3";
  builder.shape = "box = { half_extents_m = [0.12, 0.12, 0.12] }";
  builder.body = "velocity_m_per_s = [0.12, 0.1, 0.08]";
  if (std::string(effects) == "heat") builder.body.clear();
  return builder.scene();
}

void take_steps(Simulation& simulation, int steps) {
  simulation.advance(1e6, 1e6, [&] { return --steps > 0; });
}

std::string saved(const Simulation& simulation, const std::filesystem::path& path) {
  CheckpointWriter out(path, "drifting", Precision::single_precision);
  simulation.write(out);
  out.commit();
  return contents(path);
}

TEST(Sorting, ComesEveryHundredStepsThoughNoParticleLeavesItsBlock) {
  const auto s = Simulation::begin(drifting_cube("motion, elasticity"));
  const std::int64_t before = s->counters().orderings;
  take_steps(*s, 99);
  EXPECT_EQ(s->counters().orderings, before);
  take_steps(*s, 151);
  EXPECT_EQ(s->counters().orderings, before + 2);
}

TEST(Sorting, IsNotRepeatedWhereNothingMoves) {
  const auto s = Simulation::begin(drifting_cube("heat"));
  const std::int64_t before = s->counters().orderings;
  take_steps(*s, 250);
  EXPECT_EQ(s->counters().orderings, before);
}

TEST(Sorting, ComesInTheSameStepInARunThatIsResumed) {
  const TemporaryFolder folder;
  const Scene scene = drifting_cube("motion, elasticity");
  const auto whole = Simulation::begin(scene);
  take_steps(*whole, 130);
  saved(*whole, folder / "middle.h5");
  const auto resumed = Simulation::resume(scene, CheckpointReader(folder / "middle.h5"));
  take_steps(*whole, 130);
  take_steps(*resumed, 130);
  EXPECT_TRUE(saved(*whole, folder / "whole.h5") == saved(*resumed, folder / "resumed.h5"));
}

}  // namespace
}  // namespace bake

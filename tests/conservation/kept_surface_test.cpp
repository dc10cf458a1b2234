// SPDX-License-Identifier: MIT
// A surface that is kept while dough hardly moves: the same bits for any number of threads and after a stop, nearly the same heat, and
// whatever covers it is seen at once.
#include <gtest/gtest.h>

#include "tests/conservation/bits_of_run.h"

namespace bake {
namespace {

/// A ball that drifts, dries and bakes over a hot floor; nothing is poured, so that the surface can be kept.
Scene drifting_ball(double keep_dx) {
  Dough dough("motion, elasticity, heat, water");
  dough.precision = "single";
  dough.frame_s = 0.02;
  dough.shape = "sphere = { centre_m = [0, 0, -0.62], radius_m = 0.25 }";
  dough.body = "velocity_m_per_s = [0.6, 0.4, 0.2]\njitter = 1";
  dough.material = Dough::properties(Dough::moving_water());
  dough.surface = fmt::format("keep_dx = {}", keep_dx);
  dough.tables = R"([oven]
temperature_C = [[0, 60], [1, 120]]
heat_transfer_coefficient_W_per_m2K = 200
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.9], normal = [0, 0, 1] } }
temperature_C = 90
heat_transfer_coefficient_W_per_m2K = 300
)";
  return dough.scene();
}

class KeptSurface : public BitsOfRun {
 protected:
  KeptSurface() : BitsOfRun(drifting_ball(0.05), 20) {}
};

TEST_F(KeptSurface, GivesTheSameBitsForAnyNumberOfThreadsAndAfterAStop) {
  const auto look = [](const Simulation& s) { EXPECT_GT(s.counters().orderings, 1) << "and also when particles are sorted"; };
  const std::string one = whole_run(1, look);
  EXPECT_TRUE(whole_run(3, look) == one);
  for (const int steps : {1, 2, 3, 5, 8, 13}) EXPECT_TRUE(stopped_after(steps) == one) << "stopped after " << steps << " steps";
}

TEST_F(KeptSurface, PassesNearlyTheSameHeatAndWater) {
  const auto kept = Simulation::begin(scene), measured = Simulation::begin(drifting_ball(0));
  advance(*kept, frames);
  advance(*measured, frames);
  const Sums a(*kept), b(*measured);
  EXPECT_NE(a.exchanged, b.exchanged) << "it was not kept";
  EXPECT_NEAR(a.exchanged, b.exchanged, 2e-3 * b.exchanged);
  EXPECT_NEAR(a.evaporated, b.evaporated, 2e-3 * b.evaporated);
  EXPECT_NEAR(a.heat, b.heat, 2e-3 * b.heat);
}

/// Without motion a surface is measured once. A plate that comes, grows hot or goes counts from that step on.
TEST(SurfaceThatStandsStill, SeesAtOnceWhatCoversIt) {
  const auto exchanged = [](const std::string& collider) {
    Dough dough("heat");
    dough.tables =
        "[[collider]]\nshape = { half_space = { point_m = [0, 0, -0.2], normal = [0, 0, 1] } }\n"
        "heat_transfer_coefficient_W_per_m2K = 300\n" +
        collider;
    const auto s = dough.begin();
    std::vector<double> heat;
    for (int step = 1; step <= 4; ++step) {
      EXPECT_TRUE(s->advance(step * 1e-3, (step + 1) * 1e-3));
      heat.push_back(Sums(*s).exchanged);
    }
    return heat;
  };
  const auto steady = exchanged("temperature_C = 90\n"), comes = exchanged("temperature_C = 90\nfrom_s = 2e-3\n"),
             goes = exchanged("temperature_C = 90\nuntil_s = 2e-3\n"),
             heats = exchanged("temperature_C = [[0, 20], [2e-3, 20], [2.000001e-3, 90], [1, 90]]\n");
  EXPECT_GT(steady[0], 0);
  EXPECT_NEAR(steady[3] - steady[2], steady[0], 0.05 * steady[0]);
  EXPECT_NEAR(comes[1], 0, 1e-9 * steady[0]);
  EXPECT_NEAR(comes[2], steady[0], 1e-6 * steady[0]);
  EXPECT_EQ(goes[1], steady[1]);
  EXPECT_NEAR(goes[3], goes[1], 1e-9 * steady[0]);
  EXPECT_NEAR(heats[1], 0, 1e-9 * steady[0]);
  EXPECT_GT(heats[3], 0.9 * steady[0]);
}

}  // namespace
}  // namespace bake

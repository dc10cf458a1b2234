// SPDX-License-Identifier: MIT
// The same scene gives the same bits: for any number of threads, and for a run that was stopped and went on.
#include <gtest/gtest.h>

#include "solver/engine/engine.h"
#include "tests/conservation/dough.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// A small ball rises on a hot floor while dough is poured on it and a warm plate comes near.
Scene busy_scene(const std::string& precision, const std::string& kernel, const std::string& heat) {
  Dough dough;
  dough.kernel = kernel;
  if (!heat.empty()) dough.heat = heat;
  dough.effects = k_everything;
  dough.precision = precision;
  dough.dx = 0.125;
  dough.frame_s = 0.02;
  dough.gravity = "[0, 0, -9.81]";
  dough.shape = "sphere = { centre_m = [0.02, 0.01, -0.7], radius_m = 0.27 }";
  dough.body = "temperature_C = 30\njitter = 1";
  dough.material = Dough::properties(Dough::moving_water());
  dough.faces = "x_max = \"open\"";
  dough.tables = R"([water]
latent_heat_J_per_kg = 1e3
[oven]
temperature_C = [[0, 60], [1, 120]]
heat_transfer_coefficient_W_per_m2K = 200
[[collider]]
shape = { box = { centre_m = [-0.7, 0, -0.6], half_extents_m = [0.3, 0.4, 0.3] } }
motion = [{ time_s = 0 }, { time_s = 0.5, position_m = [0.6, 0, 0] }]
temperature_C = 90
heat_transfer_coefficient_W_per_m2K = 300
friction = 0.4
name = "plate"
ledger = true
[[face]]
at = "z_min"
temperature_C = [[0, 80], [1, 200]]
ledger = true
[[grip]]
name = "hand"
ledger = true
shape = { sphere = { centre_m = [0, 0, -0.9], radius_m = 0.12 } }
until_s = 0.05
temperature_C = 70
[[emitter]]
material = "dough"
shape = { box = { centre_m = [0.3, 0, 0.2], half_extents_m = [0.2, 0.2, 0.06] } }
velocity_m_per_s = [3, 0, -2]
particles_per_cell = 6
from_s = 0.013
)";
  return dough.scene();
}

constexpr double k_frame = 0.02;
constexpr int k_frames = 12;

/// Precision, kernel, keys of the heat.
class SameBits : public testing::TestWithParam<std::array<const char*, 3>> {
 protected:
  const Scene scene = busy_scene(GetParam()[0], GetParam()[1], GetParam()[2]);
  const TemporaryFolder folder;
  const int threads = omp_get_max_threads();
  void TearDown() override { omp_set_num_threads(threads); }

  void save(const Simulation& s, const char* name) const {
    CheckpointWriter out(folder / name, "busy", scene.run.precision);
    s.write(out);
    out.commit();
  }
  /// Goes on from frame `first` to the last one; stops after `steps` steps if that comes earlier.
  static void advance(Simulation& s, int first, int frames = k_frames, int steps = 1 << 30) {
    for (int f = first; f < frames && steps > 0; ++f) s.advance((f + 1) * k_frame, (f + 2) * k_frame, [&] { return --steps > 0; });
  }
  std::string whole_run(int n, const char* name) const {
    omp_set_num_threads(n);
    const auto s = Simulation::begin(scene);
    advance(*s, 0);
    save(*s, name);
    return contents(folder / name);
  }
};

TEST_P(SameBits, ForAnyNumberOfThreads) {
  const std::string one = whole_run(1, "one.h5");
  ASSERT_FALSE(one.empty());
  for (const int n : {2, 3, 7}) EXPECT_TRUE(whole_run(n, "other.h5") == one) << n << " threads";
}

TEST_P(SameBits, ForARunThatWasStoppedAtAFrame) {
  const std::string uninterrupted = whole_run(2, "whole.h5");
  const auto first = Simulation::begin(scene);
  advance(*first, 0, 5);
  save(*first, "frame.h5");
  const auto second = Simulation::resume(scene, CheckpointReader(folder / "frame.h5"));
  advance(*second, 5);
  save(*second, "resumed.h5");
  EXPECT_TRUE(contents(folder / "resumed.h5") == uninterrupted);
}

TEST_P(SameBits, ForARunThatWasStoppedInTheMiddleOfAFrame) {
  const std::string uninterrupted = whole_run(2, "whole.h5");
  for (const int steps : {1, 2, 13}) {
    const auto first = Simulation::begin(scene);
    advance(*first, 0, k_frames, steps);
    EXPECT_EQ(first->counters().steps, steps);
    save(*first, "step.h5");
    omp_set_num_threads(3);
    const auto second = Simulation::resume(scene, CheckpointReader(folder / "step.h5"));
    advance(*second, static_cast<int>(second->time() / k_frame + 1e-9));
    save(*second, "resumed.h5");
    EXPECT_TRUE(contents(folder / "resumed.h5") == uninterrupted) << "stopped after " << steps << " steps";
  }
}

TEST_P(SameBits, InASceneInWhichEverythingHappens) {
  const auto s = Simulation::begin(scene);
  const std::size_t before = s->particles();
  advance(*s, 0);
  const Sums now(*s);
  EXPECT_GT(s->particles(), before) << "nothing was poured";
  EXPECT_GT(s->counters().orderings, 3);
  EXPECT_GT(now.evaporated, 0);
  EXPECT_GT(now.dissipated, 0);
  EXPECT_GT(now.gas, 0);
  EXPECT_GT(s->booked(booked::contact_area), 0);
  ASSERT_EQ(s->given().size(), 3u);
  for (const Given& given : s->given()) EXPECT_GT(length(given.impulse), 0);
  EXPECT_GT(s->given().front().heat, 0);
  for (const double x : ledger_row(*s)) EXPECT_TRUE(std::isfinite(x));
}

INSTANTIATE_TEST_SUITE_P(In, SameBits,
                         testing::Values(std::array{"single", "quadratic", ""}, std::array{"double", "quadratic", ""},
                                         std::array{"double", "cubic", ""}, std::array{"single", "cubic", ""},
                                         std::array{"single", "quadratic", "integrator = \"backward_euler\""}),
                         [](const auto& info) {
                           return std::string(info.param[0]) + "_" + info.param[1] + (*info.param[2] ? "_backward_euler" : "");
                         });

}  // namespace
}  // namespace bake

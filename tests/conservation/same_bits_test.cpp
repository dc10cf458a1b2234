// SPDX-License-Identifier: MIT
// The same scene gives the same bits: for any number of threads, and for a run that was stopped and went on.
#include <gtest/gtest.h>

#include "solver/engine/sheets.h"
#include "tests/conservation/bits_of_run.h"

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

/// A ball in a skin dries, turns and falls.
Scene drying_fruit(const std::string& precision) {
  Dough dough("motion, water, elasticity");
  dough.precision = precision;
  dough.frame_s = 0.01;
  dough.gravity = "[0, 0, -9.81]";
  dough.shape = "sphere = { centre_m = [0.03, 0.01, -0.02], radius_m = 0.25 }";
  dough.body = "velocity_m_per_s = [0.5, 0, 0.2]\nangular_velocity_rad_per_s = [0, 3, 4]\njitter = 1";
  dough.material = Dough::properties(Dough::moving_water());
  dough.tables = "[[skin]]\nyoung_modulus_Pa = 1e6\nthickness_m = 0.02\npermeance = 0.5\n";
  return dough.scene();
}

struct Case {
  const char *precision, *kernel = "quadratic", *heat = "";
  bool has_skin = false;
};

class SameBits : public BitsOfRun, public testing::WithParamInterface<Case> {
 protected:
  SameBits()
      : BitsOfRun(
            GetParam().has_skin ? drying_fruit(GetParam().precision) : busy_scene(GetParam().precision, GetParam().kernel, GetParam().heat),
            GetParam().has_skin ? 6 : 12) {}
  std::string whole_run(int n) const {
    return BitsOfRun::whole_run(n, [](const Simulation&) {});
  }
  /// Bits at the end of a run that was saved, read again and gone on with by another number of threads.
  std::string gone_on_with(const Simulation& s) const {
    saved(s);
    omp_set_num_threads(3);
    const auto second = read_again();
    EXPECT_EQ(second->skin_sums().area, s.skin_sums().area);
    advance(*second, frames);
    return saved(*second);
  }
};

TEST_P(SameBits, ForAnyNumberOfThreads) {
  const std::string one = whole_run(1);
  ASSERT_FALSE(one.empty());
  for (const int n : {2, 3, 7, 9}) EXPECT_TRUE(whole_run(n) == one) << n << " threads";
}

TEST_P(SameBits, ForARunThatWasStopped) {
  const std::string uninterrupted = whole_run(2);
  const auto at_frame = Simulation::begin(scene);
  advance(*at_frame, 5);
  EXPECT_TRUE(gone_on_with(*at_frame) == uninterrupted);
  for (const int steps : {1, 2, 13}) {
    const auto within_frame = Simulation::begin(scene);
    advance(*within_frame, frames, steps);
    EXPECT_EQ(within_frame->counters().steps, steps);
    EXPECT_TRUE(gone_on_with(*within_frame) == uninterrupted) << "stopped after " << steps << " steps";
  }
}

TEST_P(SameBits, InASceneInWhichEverythingHappens) {
  const auto s = Simulation::begin(scene);
  const std::size_t before = s->particles();
  advance(*s, frames);
  const Sums now(*s);
  EXPECT_GT(now.evaporated, 0);
  for (const double x : ledger_row(*s)) EXPECT_TRUE(std::isfinite(x));
  if (GetParam().has_skin) {
    EXPECT_GT(s->skin_sums().bending, 0);
    EXPECT_GT(s->counters().orderings, 1);
    return;
  }
  EXPECT_GT(s->particles(), before) << "nothing was poured";
  EXPECT_GT(s->counters().orderings, 3);
  EXPECT_GT(now.dissipated, 0);
  EXPECT_GT(now.gas, 0);
  EXPECT_GT(s->booked(booked::contact_area), 0);
  ASSERT_EQ(s->given().size(), 3u);
  for (const Given& given : s->given()) EXPECT_GT(length(given.impulse), 0);
  EXPECT_GT(s->given().front().heat, 0);
}

INSTANTIATE_TEST_SUITE_P(In, SameBits,
                         testing::Values(Case{"single"}, Case{"double"}, Case{"double", "cubic"}, Case{"single", "cubic"},
                                         Case{"single", "quadratic", "integrator = \"backward_euler\""},
                                         Case{"single", "quadratic", "", true}, Case{"double", "quadratic", "", true}),
                         [](const auto& info) {
                           const Case& c = info.param;
                           return std::string(c.precision) + "_" + c.kernel + (*c.heat ? "_backward_euler" : "") +
                                  (c.has_skin ? "_in_a_skin" : "");
                         });

}  // namespace
}  // namespace bake

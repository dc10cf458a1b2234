// SPDX-License-Identifier: MIT
// A skin on a body: momenta are kept, and energy goes from one kind into another.
#include <gtest/gtest.h>

#include "solver/io/checkpoint.h"
#include "tests/conservation/dough.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// An elastic ball, four cells in radius, in a skin that is 50 times as stiff.
Dough covered(const std::string& skin = "density_kg_per_m3 = 1000", const std::string& precision = "double") {
  Dough dough;
  dough.precision = precision;
  dough.shape = "sphere = { centre_m = [0.03, 0.01, -0.02], radius_m = 0.25 }";
  dough.tables = "[[skin]]\nyoung_modulus_Pa = 1e6\nthickness_m = 0.02\n" + skin + "\n";
  return dough;
}

/// The same, drying and moving.
Dough fruit_that_moves(const std::string& skin) {
  Dough dough = covered(skin);
  dough.effects = "motion, water, elasticity";
  dough.material = Dough::properties(Dough::moving_water());
  dough.body = "velocity_m_per_s = [0.5, 0, 0.2]\nangular_velocity_rad_per_s = [0, 3, 4]\njitter = 1";
  return dough;
}

class SkinOnABody : public testing::TestWithParam<const char*> {};

TEST_P(SkinOnABody, KeepsMomentumAndAngularMomentum) {
  Dough dough = covered("density_kg_per_m3 = 1000", GetParam());
  dough.body = "velocity_m_per_s = [1, -0.5, 0.25]\nangular_velocity_rad_per_s = [0, 20, 30]";  // which stretches it
  const auto s = dough.begin();
  const Sums start(*s);
  const double speed = length(start.momentum), spin = length(start.angular);
  take_steps(*s, 100, dough.frame_s, [&](int step, const Sums& now) {
    ASSERT_LE(length(now.momentum - start.momentum), step * round_off(dough.precision) * speed);
    ASSERT_LE(length(now.angular - start.angular), step * round_off(dough.precision) * spin);
  });
  EXPECT_GT(s->skin_sums().membrane, 1e-3 * start.kinetic) << "else nothing was tested";
  EXPECT_GT(s->skin_sums().bending, 0);
}
INSTANTIATE_TEST_SUITE_P(In, SkinOnABody, testing::Values("double", "single"), [](const auto& info) { return std::string(info.param); });

/// Its inertia is then that of the flesh beside it, sixteen times its mass; its weight is not.
TEST(ALightSkin, FallsLikeAllElseAndIsBookedWithItsMass) {
  Dough dough = covered("density_kg_per_m3 = 50");
  dough.gravity = "[1, 0, -9.81]";
  dough.body = "angular_velocity_rad_per_s = [0, 0, 5]";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 50, dough.frame_s);
  const Sums now(*s);
  EXPECT_GT(now.solid, start.solid * (1 - 1e-12));
  const double weight = now.solid * s->time();  // per g: of the true mass
  EXPECT_NEAR(now.impulse[2], -9.81 * weight, 1e-9 * 9.81 * weight);
  EXPECT_NEAR(now.impulse[0], weight, 1e-9 * weight);
  EXPECT_LE(length(now.momentum - start.momentum - now.impulse), 50 * 1e-12 * length(now.impulse));
  EXPECT_LE(length(now.angular - start.angular - now.angular_impulse), 50 * 1e-12 * length(start.angular));
}

TEST(ASkin, AddsItsMassToTheSolid) {
  const auto bare = Dough().begin();
  Dough dough;
  dough.tables = "[[skin]]\nyoung_modulus_Pa = 1e6\nthickness_m = 0.02\ndensity_kg_per_m3 = 800\n";
  const auto s = dough.begin();
  EXPECT_NEAR(s->total(total::solid_mass) - bare->total(total::solid_mass), s->skin_sums().area * 0.02 * 800, 1e-9);
  EXPECT_EQ(s->total(total::volume), bare->total(total::volume));
  EXPECT_EQ(s->particles(), bare->particles());
}

/// A ball that swings: half of a grid's step lies between the energies of motion and of strain, and APIC takes some of what swings fast.
TEST(ASkin, ExchangesItsEnergyWithMotionAndStrain) {
  Dough dough = covered();
  dough.body = "angular_velocity_rad_per_s = [0, 0, 25]";
  dough.frame_s = 2e-4;
  const auto s = dough.begin();
  const double before = Sums(*s).kinetic;
  double most = 0;
  take_steps(*s, 200, dough.frame_s, [&](int, const Sums& now) {
    const double all = now.kinetic + now.elastic;
    most = std::max(most, s->skin_sums().membrane);
    ASSERT_LE(all, before * 1.001);
    ASSERT_GE(all, before * 0.97);
  });
  EXPECT_GT(most, 0.05 * before) << "else nothing was tested";
}

/// The surface lies at nodes somewhat deeper than the skin: an eighth of it is at nodes that the skin covers in part only (measured: 0.13).
TEST(Water, GoesThroughASkinAsItsPermeanceSays) {
  const auto evaporated = [](const std::string& skin) {
    const auto s = fruit_that_moves(skin).begin();
    take_steps(*s, 20, 1e-3);
    const Sums now(*s);
    return now.evaporated;
  };
  const double open = evaporated("permeance = 1"), half = evaporated("permeance = 0.5"), none = evaporated("permeance = 0");
  EXPECT_GT(open, 0);
  EXPECT_NEAR(half / open, 0.5 + 0.5 * 0.13, 0.02);
  EXPECT_NEAR(none / open, 0.13, 0.02);
}

TEST(Water, IsKeptUnderASkin) {
  const Dough dough = fruit_that_moves("permeance = 0.3");
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 50, dough.frame_s);
  const Sums now(*s);
  EXPECT_NEAR(now.water + now.evaporated, start.water, 50 * 1e-12 * start.water);
  EXPECT_LE(length(now.momentum - now.impulse - now.remapped - start.momentum), 50 * 1e-12 * length(start.momentum));
}

/// Half of the ball has left the domain after 0.12 s.
Dough leaving() {
  Dough dough = covered();
  dough.faces = "x_max = \"open\"";
  dough.high = {0.5, 1, 1};
  dough.body = "velocity_m_per_s = [4, 0, 0]";
  return dough;
}

TEST(ASkinThatLeaves, IsTornAndGoesOn) {
  const auto s = leaving().begin();
  const std::size_t before = s->particles(), triangles = s->skin_mesh(s->frame())->cell_count();
  s->advance(0.12, 0.2);
  const auto mesh = s->skin_mesh(s->frame());
  EXPECT_LT(s->particles(), before);
  EXPECT_GT(s->particles(), 0U);
  EXPECT_LT(mesh->cell_count(), triangles);
  EXPECT_GT(mesh->cell_count(), 0U);
  for (const double x : ledger_row(*s)) EXPECT_TRUE(std::isfinite(x));
  s->advance(0.4, 0.5);
  EXPECT_EQ(s->particles(), 0U);
  EXPECT_EQ(s->skin_sums().area, 0);
}

/// Vertices that have left are shown where they were last, after a resume as well.
TEST(ASkinThatLeaves, IsShownByAResumedRunAsByOneThatWentOn) {
  const Dough dough = leaving();
  const auto whole = dough.begin();
  whole->advance(0.12, 0.13);
  const TemporaryFolder folder;
  const auto file = folder / "run.h5";
  CheckpointWriter out(file, "run", Precision::double_precision);
  whole->write(out);
  out.commit();
  const auto resumed = Simulation::resume(dough.scene(), CheckpointReader(file));
  for (const auto* s : {&whole, &resumed}) (*s)->advance(0.13, 0.14);
  EXPECT_LT(whole->particles(), dough.begin()->particles()) << "else nothing was tested";
  EXPECT_EQ(whole->skin_mesh(whole->frame())->points, resumed->skin_mesh(resumed->frame())->points);
}

}  // namespace
}  // namespace bake

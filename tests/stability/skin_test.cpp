// SPDX-License-Identifier: MIT
// Hard cases of skins.
#include <gtest/gtest.h>

#include "tests/stability/cruel.h"

namespace bake {
namespace {

/// A ball of 4.8 cells in diameter, weightless, since work of gravity on a skin is not summed.
Dough covered(const std::string& skin) {
  Dough dough = small();
  dough.gravity = "[0, 0, 0]";
  dough.tables = "[[skin]]\n" + skin + "\n";
  return dough;
}

/// Five thousand times as stiff as the dough: it decides the step.
TEST(AStiffSkin, HoldsItsDough) {
  Dough dough = covered("young_modulus_Pa = 1e8\nthickness_m = 0.05\ndensity_kg_per_m3 = 500");
  dough.body = "angular_velocity_rad_per_s = [0, 3, 6]\nvelocity_m_per_s = [0.5, 0, 0]";
  Watched ball(dough);
  const double area = ball->skin_sums().area;
  ASSERT_NO_FATAL_FAILURE(ball.run(0.1));
  EXPECT_LT(ball->dt(), 5e-4) << "else nothing was tested";
  EXPECT_NEAR(ball->skin_sums().area, area, 0.01 * area);
}

/// A skin in which the step of the bending is the shortest.
TEST(AThickSkin, HoldsItsDough) {
  Dough dough = covered("young_modulus_Pa = 1e6\nthickness_m = 0.3\ndensity_kg_per_m3 = 100");
  dough.body = "angular_velocity_rad_per_s = [0, 3, 6]";
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.05));
}

TEST(ASkinUnderAKnife, IsCutOrHoldsButStaysFinite) {
  Dough dough = covered("young_modulus_Pa = 1e6\nthickness_m = 0.03");
  dough.effects = "motion, elasticity, plasticity";
  dough.tables += R"(
[[collider]]
shape = { box = { centre_m = [0.023, 0.011, 0.75], half_extents_m = [0.04, 0.6, 0.35] } }
expels = true
motion = [{ time_s = 0 }, { time_s = 0.2, position_m = [0, 0, -0.8] }]
)";
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.25, 4));
  EXPECT_GT(ball->skin_sums().membrane, 0);
}

TEST(ASkinThatIsCrushed, StaysFinite) {
  Dough dough = covered("young_modulus_Pa = 2e5\nthickness_m = 0.01");
  dough.effects = "motion, elasticity, plasticity";
  dough.tables += R"(
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.3] } }
contact = "sticky"
[[collider]]
shape = { half_space = { point_m = [0, 0, 0.4], normal = [0, 0, -1] } }
motion = [{ time_s = 0 }, { time_s = 0.2, position_m = [0, 0, -0.55] }]
)";
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.2, 2.75));
  EXPECT_GT(ball->skin_sums().area, 0);
}

/// What shrinking flesh gives its skin comes from the water's pressure, and nothing else does: within 1.5 % after the first steps, in which
/// drying begins at once. (Measured: 1.2 %, and the same sign and size without a skin: what APIC takes of what swings.)
TEST(ADryingFruit, ClosesItsEnergy) {
  Dough dough("motion, water, elasticity");
  dough.shape = "sphere = { centre_m = [0.01, 0.02, 0.03], radius_m = 0.3 }";
  dough.frame_s = 0.02;
  dough.material = R"(
density_kg_per_m3 = 1000
young_modulus_Pa = 2e4
initial_saturation = 0.8
pressure_Pa = 8e4
diffusivity_m2_per_sK = 4e-3
evaporation_kg_per_m2sK = 15
)";
  dough.tables = "[[skin]]\nyoung_modulus_Pa = 1e6\nthickness_m = 0.025\n";
  const Scene scene = dough.scene();
  const auto s = Simulation::begin(scene);
  const Sums start(*s);
  Work work(scene, *s);
  for (int frame = 1; frame <= 20; ++frame) {
    s->advance(0.02 * frame, 0.02 * (frame + 1), [&] {
      work.add(*s);
      return true;
    });
    if (frame < 5) continue;
    const Sums now(*s);
    const double gained = now.kinetic + now.elastic - start.kinetic - start.elastic;
    EXPECT_NEAR(gained, work.given(), 0.015 * work.given()) << frame;
  }
  const Sums now(*s);
  EXPECT_LT(now.water, 0.5 * start.water);
  EXPECT_GT(s->skin_sums().membrane + s->skin_sums().bending, 0.05 * now.elastic) << "else nothing was tested";
}

}  // namespace
}  // namespace bake

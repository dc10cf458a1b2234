// SPDX-License-Identifier: MIT
// Steps where dough holds together are longer than where some of it is in crumbs, and as stable.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "tests/conservation/bits_of_run.h"

namespace bake {
namespace {

constexpr double k_E = 2e4, k_nu = 0.47, k_rho = 500;

/// A soft, nearly incompressible ball without weight; `crumbs`: further bodies.
Dough ball(const std::string& crumbs = "") {
  Dough dough;
  dough.frame_s = 0.05;
  dough.motion = "";
  dough.material = fmt::format("density_kg_per_m3 = {}\nyoung_modulus_Pa = {}\npoisson_ratio = {}\n", k_rho, k_E, k_nu);
  dough.time = "safety = 0.9";
  dough.tables = crumbs;
  return dough;
}

constexpr double k_half_side = 0.0156;
/// One particle.
std::string crumb_at(double x) {
  return fmt::format(
      "[[body]]\nmaterial = \"dough\"\nshape = {{ box = {{ centre_m = [{0}, 0, 0], half_extents_m = [{1}, {1}, {1}] }} }}\n"
      "particles_per_cell = 8\n",
      x, k_half_side);
}

/// 0.9 of 2 / omega, omega^2 = 12 K / (rho dx^2).
double limit_of_a_particle_alone(double dx) { return 0.9 * 2 / std::sqrt(12 * k_E / (3 * (1 - 2 * k_nu)) / k_rho) * dx; }

double mean_step(const Dough& dough) {
  const auto s = dough.begin();
  EXPECT_TRUE(s->advance(dough.frame_s, 2 * dough.frame_s));
  return dough.frame_s / static_cast<double>(s->counters().steps);
}

TEST(StepsOfDough, AreLongerThanThoseOfAParticleAlone) {
  const Dough dough = ball();
  EXPECT_GT(mean_step(dough), 1.2 * limit_of_a_particle_alone(dough.dx));
}

TEST(StepsOfDough, AreThoseOfAParticleAloneOnceThereIsOne) {
  const Dough dough = ball(crumb_at(0.5));
  const double more = Sums(*dough.begin()).volume - Sums(*ball().begin()).volume;
  EXPECT_NEAR(more, std::pow(2 * k_half_side, 3), 0.01 * more);
  EXPECT_LE(mean_step(dough), limit_of_a_particle_alone(dough.dx) * (1 + 1e-9));
}

/// A ball that hits the floor rings for ever: energy that appeared would grow with every step.
TEST(StepsOfDough, AreStable) {
  Dough dough = ball();
  dough.shape = "sphere = { centre_m = [0, 0, -0.7], radius_m = 0.25 }";
  dough.body = "velocity_m_per_s = [0.3, 0.2, -0.8]\njitter = 1";
  dough.tables = "[[collider]]\nshape = { half_space = { point_m = [0, 0, -0.96], normal = [0, 0, 1] } }\ncontact = \"separating\"\n";
  const auto s = dough.begin();
  const double start = Sums(*s).kinetic;
  double most = 0;
  for (int frame = 0; frame < 20; ++frame) {
    ASSERT_TRUE(s->advance((frame + 1) * dough.frame_s, (frame + 2) * dough.frame_s));
    most = larger(most, Sums(*s).kinetic + Sums(*s).elastic);
  }
  EXPECT_GT(Sums(*s).momentum[2], 0) << "it came back";
  EXPECT_LT(most, 1.01 * start);
}

class StepsOfDoughThatMoves : public BitsOfRun {
 protected:
  static Scene drifting() {
    Dough dough = ball();
    dough.precision = "single";
    dough.body = "velocity_m_per_s = [0.6, 0.4, 0.2]\njitter = 1";
    return dough.scene();
  }
  StepsOfDoughThatMoves() : BitsOfRun(drifting(), 4) {}
};

TEST_F(StepsOfDoughThatMoves, AreTheSameForAnyNumberOfThreadsAndAfterAStop) {
  const auto look = [](const Simulation& s) {
    EXPECT_GT(s.counters().orderings, 1) << "and also when particles are sorted";
    EXPECT_GT(s.counters().steps, 60) << "and when crumbs are looked for again";
  };
  const std::string one = whole_run(1, look);
  EXPECT_TRUE(whole_run(3, look) == one);
  for (const int steps : {1, 7, 20, 21, 45}) EXPECT_TRUE(stopped_after(steps) == one) << "stopped after " << steps << " steps";
}

}  // namespace
}  // namespace bake

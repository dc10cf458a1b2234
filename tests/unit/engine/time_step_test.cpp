// SPDX-License-Identifier: MIT
#include "solver/engine/time_step.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/unit/engine/scene_of_everything.h"

namespace bake {
namespace {

constexpr double k_dx = 0.1;

/// Maxima over the particles, [m^2/s^2], [m^2/s] and [1/s^2].
struct Most {
  double speed2 = 0, sound_speed2 = 0, own_frequency2 = 0, inner_frequency2 = 0, heat = 0, water = 0, deformation2 = 0;
};

StepLimit limit(const Most& most, double contact_speed = 0, const std::string& tables = "[motion]\ngravity_m_per_s2 = [0, 0, 0]\n",
                double alone = 1) {
  const Scene scene = scene_of_everything("yield_stress_Pa = 1\n", tables);
  const auto physics = make_physics<double>(scene);
  const std::map<std::string, double> numbers{{"speed_squared", most.speed2},
                                              {"sound_speed_squared", most.sound_speed2},
                                              {"own_frequency_squared", most.own_frequency2},
                                              {"inner_frequency_squared", most.inner_frequency2},
                                              {"deformation_rate_squared", most.deformation2},
                                              {"heat_diffusivity", most.heat},
                                              {"water_diffusivity", most.water}};
  EXPECT_EQ(physics->bounds.size(), numbers.size());
  Bounds bounds{};
  for (const auto& q : physics->bounds) bounds[static_cast<std::size_t>(q.first)] = numbers.at(q.name);
  return largest_step(scene, *physics, bounds, contact_speed, alone);
}

TEST(TheTimeStep, HasNoLimitWhereNothingMovesOrFlows) { EXPECT_EQ(limit({}).dt, k_infinity); }

TEST(TheTimeStep, LetsNoWaveCrossMoreThanHalfACell) {
  const StepLimit found = limit({.sound_speed2 = 400});
  EXPECT_DOUBLE_EQ(found.dt, 0.5 * k_dx / 20);
  EXPECT_STREQ(found.reason, "stiffness (elastic, pore gas and water)");
}
TEST(TheTimeStep, IsBelowTwoOverTheFrequencyOfAParticleAlone) { EXPECT_DOUBLE_EQ(limit({.own_frequency2 = 100}).dt, 0.9 * 2 / 10); }
TEST(TheTimeStep, GoesBeyondTheLimitOfAParticleAloneWhereSafetySaysSo) {
  EXPECT_DOUBLE_EQ(limit({.own_frequency2 = 100}, 0, "[motion]\ngravity_m_per_s2 = [0, 0, 0]\n[time]\nsafety = 4\n").dt, 4 * 2 / 10.);
}
TEST(TheTimeStep, IsLongerWhereNoParticleIsAloneButBelowTwoOverTheFrequencyInside) {
  const Most most{.own_frequency2 = 100, .inner_frequency2 = 49};
  const std::string weightless = "[motion]\ngravity_m_per_s2 = [0, 0, 0]\n";
  EXPECT_DOUBLE_EQ(limit(most, 0, weightless, 0.64).dt, 0.9 * 2 / 8);
  EXPECT_DOUBLE_EQ(limit(most, 0, weightless, 0.25).dt, 0.9 * 2 / 7);
}
TEST(TheTimeStep, IsNoneOnceAVolumeIsNone) {
  const StepLimit found = limit({.own_frequency2 = k_infinity});
  EXPECT_EQ(found.dt, 0);
  EXPECT_STREQ(found.reason, "a particle's volume fell to zero");
}
TEST(TheTimeStep, KeepsExplicitConductionStable) { EXPECT_DOUBLE_EQ(limit({.heat = 0.01}).dt, 0.5 * k_dx * k_dx / 0.03); }
TEST(TheTimeStep, KeepsDiffusionOfAParticleAloneStableWhateverTheSafety) {
  const std::string tables = "[motion]\ngravity_m_per_s2 = [0, 0, 0]\n[time]\nsafety = 0.8\n";
  EXPECT_DOUBLE_EQ(limit({.heat = 0.01}, 0, tables).dt, 0.9 * k_dx * k_dx / 0.04);
  EXPECT_DOUBLE_EQ(limit({.water = 0.02}, 0, tables).dt, 0.9 * k_dx * k_dx / 0.08);
}
TEST(TheTimeStep, KeepsWaterDiffusionStable) { EXPECT_DOUBLE_EQ(limit({.water = 0.02}).dt, 0.5 * k_dx * k_dx / 0.06); }
TEST(TheTimeStep, KeepsTheDeformationOfAStepBelowAHalf) { EXPECT_DOUBLE_EQ(limit({.deformation2 = 100}).dt, 0.05); }
TEST(TheTimeStep, LetsNoParticleTravelBeyondItsShareOfACell) { EXPECT_DOUBLE_EQ(limit({.speed2 = 9}).dt, 0.3 * k_dx / 3); }
TEST(TheTimeStep, LetsNoColliderTravelBeyondIt) { EXPECT_DOUBLE_EQ(limit({.speed2 = 9}, 6).dt, 0.3 * k_dx / 6); }
TEST(TheTimeStep, LetsNothingFallBeyondIt) {
  EXPECT_DOUBLE_EQ(limit({}, 0, "[motion]\ngravity_m_per_s2 = [0, 0, -10]\n").dt, std::sqrt(0.3 * k_dx / 10));
  EXPECT_DOUBLE_EQ(limit({}, 0, "[motion]\ngravity_m_per_s2 = [0, 0, -10]\ninertia_scale = 100\n").dt, std::sqrt(0.3 * k_dx / 0.1));
}
TEST(TheTimeStep, IsTheSmallestOfAllLimits) {
  const Most all{.speed2 = 1, .sound_speed2 = 1e4, .heat = 1e-3, .water = 1e-3, .deformation2 = 1};
  EXPECT_DOUBLE_EQ(limit(all).dt, 0.5 * k_dx / 100);
  EXPECT_DOUBLE_EQ(limit(all, 0, "[time]\nlargest_step_s = 1e-5\n").dt, 1e-5);
  EXPECT_STREQ(limit(all, 0, "[time]\nlargest_step_s = 1e-5\n").reason, "time.largest_step_s");
}
TEST(TheTimeStep, ScalesWithSafety) {
  const std::string tables = "[motion]\ngravity_m_per_s2 = [0, 0, 0]\n[time]\nsafety = 0.25\n";
  EXPECT_DOUBLE_EQ(limit({.sound_speed2 = 400}, 0, tables).dt, 0.25 * k_dx / 20);
}

}  // namespace
}  // namespace bake

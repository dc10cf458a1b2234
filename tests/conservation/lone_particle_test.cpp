// SPDX-License-Identifier: MIT
// A crumb of one particle: what its nodes say is its own memory.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "tests/conservation/dough.h"

namespace bake {
namespace {

/// Hot gas blows it up, open pores let air in, and it yields at once: nothing ever stops its nodes.
Dough crumb(const std::string& body) {
  Dough dough("motion, heat, elasticity, plasticity, leavening");
  dough.leavening += "\npores = \"open\"";
  dough.motion = "inertia_scale = 4";
  dough.material =
      "density_kg_per_m3 = 500\nyoung_modulus_Pa = 4e4\ninitial_porosity = 0.5\ninitial_temperature_C = 20\nspecific_heat_J_per_kgK = 20\n"
      "conductivity_W_per_mK = 100\nyield_stress_Pa = 1\n";
  dough.shape = "box = { centre_m = [0.1, 0.1, 0.1], half_extents_m = [0.0125, 0.0125, 0.0125] }";
  dough.body = body;
  return dough;
}

/// Volume with which a particle alone fills its nodes.
double room(const Dough& dough) { return std::pow(dough.dx * 20 / 11, 3); }

TEST(ACrumbOfOneParticle, OpensNoFurtherThanTheRoomOfItsNodesAndCutsNoSteps) {
  const Dough dough = crumb("temperature_C = 95");
  const auto s = dough.begin();
  ASSERT_EQ(s->particles(), 1U);
  const double V_0 = Sums(*s).volume;
  double largest = V_0;
  for (int frame = 1; frame <= 40; ++frame) {
    ASSERT_TRUE(s->advance(0.05 * frame, 0.05 * (frame + 1)));
    largest = larger(largest, Sums(*s).volume);
  }
  EXPECT_GT(largest, 0.9 * room(dough)) << "it opened: else nothing was tested";
  EXPECT_LE(largest, room(dough) * (1 + 1e-12));
  EXPECT_LT(s->counters().steps, 4000) << "conduction, which grows with its volume, asks for steps of a millisecond";
  for (const double p : Sums(*s).momentum) EXPECT_NEAR(p, 0, 1e-12 * Sums(*s).mass());
}

/// Its nodes give it back the gradient that its own flux has made: with too long a step one that is larger each time.
TEST(ACrumbOfOneParticle, IsEvenlyWarmWithTheLongestStepsOfHeatAndWater) {
  for (const std::string kernel : {"quadratic", "cubic"})
    for (const std::string effects : {"heat", "water", "heat, water"}) {
      Dough dough = crumb("");
      dough.effects = effects;
      dough.kernel = kernel;
      dough.motion = dough.leavening = "";
      dough.heat = effects == "water" ? "" : "water_specific_heat_J_per_kgK = 40";
      dough.time = "safety = 0.95";
      dough.material =
          "density_kg_per_m3 = 500\nspecific_heat_J_per_kgK = 20\nconductivity_W_per_mK = 100\ninitial_porosity = 0.5\n"
          "initial_saturation = 0.2\ninitial_temperature_C = 50\ndiffusivity_m2_per_sK = 2e-3\nevaporation_kg_per_m2sK = 1e-4\n";
      dough.tables = "[oven]\ntemperature_C = 90\nheat_transfer_coefficient_W_per_m2K = 10\nequilibrium_saturation = 0\n";
      dough.frame_s = 200;
      const auto s = dough.begin();
      ASSERT_EQ(s->particles(), 1U);
      ASSERT_TRUE(s->advance(200, 400));
      EXPECT_GT(s->counters().steps, 300);
      if (effects != "water") {
        EXPECT_GE(-s->highest(highest::coldness), 50 - 1e-6) << kernel << " " << effects;
        EXPECT_LE(s->highest(highest::temperature), 90) << kernel << " " << effects;
      }
      EXPECT_LE(Sums(*s).evaporated + Sums(*s).water, 1.0000001 * Sums(*dough.begin()).water) << kernel << " " << effects;
      EXPECT_GE(Sums(*s).water, 0) << kernel << " " << effects;
    }
}

TEST(ACrumbOfOneParticle, KeepsItsSpinAndItsVolume) {
  const Dough dough = crumb("angular_velocity_rad_per_s = [3, -4, 5]\nvelocity_m_per_s = [0.1, 0.2, -0.1]");
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 1000, 1e-4);
  const Sums now(*s);
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_NEAR(now.angular[d], start.angular[d], 1e-12 * length(start.angular));
    EXPECT_NEAR(now.momentum[d], start.momentum[d], 1e-12 * length(start.momentum));
  }
  EXPECT_NEAR(now.volume, start.volume, 0.02 * start.volume);
}

}  // namespace
}  // namespace bake

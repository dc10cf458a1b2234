// SPDX-License-Identifier: MIT
// Vapour in the pores: water and the heat that it carries are kept while they go from where it is hot to where it is cold.
#include <gtest/gtest.h>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

const char* const k_pore_vapour = "vapour_diffusivity_m2_per_s = 5\nvapour_transfer_m_per_s = 50";

/// A ball in an oven.
Dough in_an_oven(const std::string& effects, const std::string& precision = "double") {
  Dough dough(effects);
  dough.precision = precision;
  dough.material = Dough::properties("diffusivity_m2_per_sK = 2e-4", std::string(k_pore_vapour) + "\nhygroscopic_water_kg_per_kg = 0.1");
  dough.tables = "[water]\nlatent_heat_J_per_kg = 2e3\n[oven]\ntemperature_C = 200\nheat_transfer_coefficient_W_per_m2K = 3e3\n";
  dough.body = "temperature_C = 60\nvelocity_m_per_s = [1, 0, 0]\nangular_velocity_rad_per_s = [0, 0, 4]";
  return dough;
}

class VapourInPores : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(VapourInPores, KeepsWaterAndTheHeatThatItCarries) {
  const Dough dough = in_an_oven(GetParam().first, GetParam().second);
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 100, dough.frame_s / 2, [&](int step, const Sums& now) {
    const double bound = step * round_off(dough.precision);
    ASSERT_NEAR(now.water + now.evaporated, start.water, bound * start.water);
    ASSERT_NEAR(now.heat - now.heat_gained(), start.heat, bound * (now.heat + now.latent + now.exchanged));
    ASSERT_EQ(now.limited, 0);
  });
  const Sums end(*s);
  EXPECT_GT(end.evaporated, 0.002 * start.water) << "else nothing was tested";
  EXPECT_NEAR(end.latent, 2e3 * end.evaporated, 1e-5 * end.latent) << "only what leaves takes latent heat out of the dough";
}
INSTANTIATE_TEST_SUITE_P(With, VapourInPores,
                         testing::Values(std::pair{"heat, water", "double"}, std::pair{"heat, water", "single"},
                                         std::pair{k_everything, "double"}, std::pair{k_everything, "single"}),
                         [](const auto& info) {
                           return std::string(info.param.first == std::string(k_everything) ? "everything_" : "heat_water_") +
                                  info.param.second;
                         });

// Nothing leaves. The middle is colder than the rest, and water comes to it, which Fick's law would never do.
TEST(VapourInPores, BringsWaterToTheColdMiddle) {
  for (const bool vapour : {true, false}) {
    Dough dough = in_an_oven("heat, water");
    dough.material = Dough::changed({{"initial_saturation", "0.02"}}, std::string("diffusivity_m2_per_sK = 2e-4\n") + k_pore_vapour) +
                     "\nhygroscopic_water_kg_per_kg = 0.005";
    if (!vapour) dough.overrides = {"material.0.vapour_diffusivity_m2_per_s=0", "material.0.vapour_transfer_m_per_s=0"};
    if (vapour) dough.overrides = {"material.0.vapour_transfer_m_per_s=0"};
    const auto s = dough.begin();
    const Sums start(*s);
    take_steps(*s, 60, dough.frame_s / 2);
    const Snapshot now = s->snapshot();
    double middle = 0, rim = 0, in_middle = 0, in_rim = 0;
    for (std::size_t i = 0; i < now.id.size(); ++i) {
      const double r = length(now.position[i]);
      (r < 0.12 ? middle : rim) += r < 0.12 || r > 0.2 ? now["water_mass"][i] : 0;
      (r < 0.12 ? in_middle : in_rim) += r < 0.12 || r > 0.2 ? 1 : 0;
    }
    const double lead = (middle / in_middle) / (rim / in_rim) - 1;
    if (vapour) {
      EXPECT_GT(lead, 0.002);
    } else {
      EXPECT_NEAR(lead, 0, 1e-9);
    }
  }
}

// A hot and a cold half touch, and vapour diffuses ten times as readily as heat: the longest steps, which only the limit of vapour keeps
// stable, do not drive them apart.
TEST(VapourInPores, IsStableInTheLongestSteps) {
  Dough dough("heat, water");
  dough.material = Dough::changed({{"conductivity_W_per_mK", "1"}}, std::string("diffusivity_m2_per_sK = 1e-7\n") + k_pore_vapour);
  dough.time = "safety = 1";
  dough.tables =
      "[water]\nlatent_heat_J_per_kg = 2e3\n[[body]]\nmaterial = \"dough\"\ntemperature_C = 90\n"
      "shape = { box = { centre_m = [0.25, 0, 0], half_extents_m = [0.25, 0.25, 0.25] } }\n";
  dough.shape = "box = { centre_m = [-0.25, 0, 0], half_extents_m = [0.25, 0.25, 0.25] }";
  dough.overrides = {"material.0.vapour_transfer_m_per_s=0"};
  const auto s = dough.begin();
  const Sums start(*s);
  const double longest_of_heat = 1. / 3 * dough.dx * dough.dx / s->bound(bound::heat_diffusivity);
  ASSERT_TRUE(s->advance(1, 2));
  EXPECT_LT(1. / static_cast<double>(s->counters().steps), 0.2 * longest_of_heat) << "else conduction was the limit";
  EXPECT_LE(s->highest(highest::temperature), 100);
  EXPECT_LE(s->highest(highest::coldness), -10);
  EXPECT_EQ(s->booked(booked::water_limited), 0);
  EXPECT_NEAR(Sums(*s).water, start.water, 1e-9 * start.water);
}

}  // namespace
}  // namespace bake

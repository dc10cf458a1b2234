// SPDX-License-Identifier: MIT
// Particles and their nodes agree: what differs within a cell evens out, and dry dough takes up water.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "tests/conservation/dough.h"

namespace bake {
namespace {

/// A sealed bar along x of two bodies, `left` below x = 0 and `right` above.
Dough halves(const char* effects, const char* left, const char* right) {
  Dough dough(effects);
  dough.low = {-0.5, 0, 0}, dough.high = {0.5, 0.125, 0.125};
  dough.material =
      "density_kg_per_m3 = 1000\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 10\n"
      "initial_temperature_C = 40\ninitial_saturation = 0.4\ndiffusivity_m2_per_sK = 1e-3\n";
  dough.tables = fmt::format(
      "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\n{}\nshape = {{ box = {{ centre_m = [-0.25, 0.0625, 0.0625], half_extents_m "
      "= "
      "[0.25, 0.0625, 0.0625] }} }}\n",
      left);
  dough.shape = "box = { centre_m = [0.25, 0.0625, 0.0625], half_extents_m = [0.25, 0.0625, 0.0625] }";
  dough.body = right;
  dough.heat = "water_specific_heat_J_per_kgK = 1";
  return dough;
}

std::pair<double, double> range_of(const std::vector<double>& values) { return {smallest_of(values), largest_of(values)}; }

std::vector<double> saturations(const Simulation& s) {
  const Snapshot now = s.snapshot();
  std::vector<double> all = now["water_mass"];
  for (std::size_t i = 0; i < all.size(); ++i) all[i] /= 1000 * now["initial_volume"][i];
  return all;
}

// Without subgrid diffusion they keep 5 to 94 C for ever.
TEST(InsulatedHalves, EndAtOneTemperature) {
  for (const char* precision : {"double", "single"}) {
    Dough dough = halves("heat", "temperature_C = 100", "temperature_C = 0");
    dough.precision = precision;
    const auto s = dough.begin();
    const double start = Sums(*s).heat;
    s->advance(300, 301);
    const auto [low, high] = range_of(s->snapshot()["temperature"]);
    EXPECT_NEAR(low, 50, 0.1) << precision;
    EXPECT_NEAR(high, 50, 0.1) << precision;
    EXPECT_NEAR(Sums(*s).heat, start, s->counters().steps * round_off(precision) * start);
  }
}

TEST(InsulatedHalves, KeepWhatTheirParticlesHadIfSubgridDiffusionIsOff) {
  Dough dough = halves("heat", "temperature_C = 100", "temperature_C = 0");
  dough.heat += "\nsubgrid_diffusion = 0";
  const auto s = dough.begin();
  s->advance(300, 301);
  const auto [low, high] = range_of(s->snapshot()["temperature"]);
  EXPECT_LT(low, 20);
  EXPECT_GT(high, 80);
}

TEST(SealedHalves, EndAtOneSaturation) {
  Dough dough = halves("water", "saturation = 0.4", "saturation = 0.1");
  const auto s = dough.begin();
  const double start = Sums(*s).water;
  s->advance(1000, 1001);
  const auto [low, high] = range_of(saturations(*s));
  EXPECT_NEAR(low, 0.25, 1e-3);
  EXPECT_NEAR(high, 0.25, 1e-3);
  EXPECT_NEAR(Sums(*s).water, start, s->counters().steps * 1e-12 * start);
}

// Gains shared by the water that is there give nothing to a dry particle: 2.5 times the saturation of the start on the wet side.
TEST(DryDough, TakesUpWaterAndNoneIsWetterThanAtTheStart) {
  for (const char* effects : {"water", "heat, water"}) {
    Dough dough = halves(effects, "saturation = 0.4", "saturation = 0");
    const auto s = dough.begin();
    const double start = Sums(*s).water;
    for (int i = 1; i <= 10; ++i) {
      s->advance(20 * i, 20 * i + 20);
      const auto [low, high] = range_of(saturations(*s));
      EXPECT_GE(low, 0) << effects;
      EXPECT_LE(high, 0.4 * (1 + 1e-9)) << effects;
      EXPECT_NEAR(Sums(*s).water, start, s->counters().steps * 1e-12 * start);
      if (dough.effects != "water") {  // at one temperature water moves no heat, however it moves
        const auto [cold, warm] = range_of(s->snapshot()["temperature"]);
        EXPECT_NEAR(cold, 40, 1e-9);
        EXPECT_NEAR(warm, 40, 1e-9);
      }
    }
    const auto s_end = saturations(*s);
    const Snapshot end = s->snapshot();
    double beyond = 0;
    for (std::size_t i = 0; i < s_end.size(); ++i) beyond += end.position[i][0] > 0.1 ? s_end[i] : 0;
    EXPECT_GT(beyond, 1) << "else nothing was taken up";
    EXPECT_EQ(s->total(total::water_overfull), 0);
  }
}

// [Ding19 Eq. 19] as printed.
TEST(DryDough, StaysDryAsPublished) {
  Dough dough = halves("water", "saturation = 0.4", "saturation = 0");
  dough.tables += "[water]\nform = \"published\"\nsubgrid_diffusion = 0\n";
  const auto s = dough.begin();
  s->advance(100, 101);
  const auto all = saturations(*s);
  const Snapshot end = s->snapshot();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (end.position[i][0] > 0) {
      ASSERT_EQ(all[i], 0);
    }
  EXPECT_GT(range_of(all).second, 0.5) << "it piles up";
}

// A wet ball in a dry shell, all moving, hot and wet: the books close, and nothing falls below zero.
TEST(AWetFilling, WetsItsDryShellWithinRoundOff) {
  for (const char* precision : {"double", "single"}) {
    Dough dough(k_everything);
    dough.precision = precision;
    dough.frame_s = 2e-4;
    dough.material = Dough::properties(Dough::moving_water());
    const char* shell = "difference = [ { sphere = { radius_m = 0.25 } }, { sphere = { radius_m = 0.125 } } ]";
    dough.tables = fmt::format(
        "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\ntemperature_C = 60\nsaturation = 0\nshape = {{ {} }}\n", shell);
    dough.shape = "sphere = { radius_m = 0.125 }";
    dough.body = "temperature_C = 60\nsaturation = 0.3";
    const auto s = dough.begin();
    const Sums start(*s);
    take_steps(*s, 100, dough.frame_s, [&](int step, const Sums& now) {
      const double bound = step * round_off(precision);
      ASSERT_NEAR(now.water + now.evaporated, start.water, bound * start.water);
      ASSERT_NEAR(now.heat, start.heat + now.heat_gained() - start.heat_gained(), bound * start.heat);
      for (const double m : s->snapshot()["water_mass"]) ASSERT_GE(m, 0);
    });
  }
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// Thermal expansion of elastic and of plastic dough.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

constexpr double k_alpha = 1e-3, k_young = 2e4, k_bulk = k_young / (3 * 0.4), k_warmth = 50;  // Poisson's ratio is 0.3

/// A cube that is free, or one between walls that it fills, `k_warmth` too warm to be free of stress.
Dough warm_cube(const char* effects, double yield_stress_Pa, bool walled) {
  Dough dough(effects);
  dough.low = walled ? Vector3{0, 0, 0} : Vector3{-0.25, -0.25, -0.25};
  dough.high = walled ? Vector3{0.5, 0.5, 0.5} : Vector3{0.75, 0.75, 0.75};
  dough.faces = "x_min = \"slip\"\nx_max = \"slip\"\ny_min = \"slip\"\ny_max = \"slip\"\nz_min = \"slip\"\nz_max = \"slip\"";
  dough.shape = "box = { centre_m = [0.25, 0.25, 0.25], half_extents_m = [0.25, 0.25, 0.25] }";
  dough.body = fmt::format("jitter = 0\ntemperature_C = {}", 20 + k_warmth);
  dough.material = fmt::format(
      "density_kg_per_m3 = 500\nyoung_modulus_Pa = {}\ninitial_porosity = 0.3\ninitial_temperature_C = 20\nspecific_heat_J_per_kgK = 2000\n"
      "conductivity_W_per_mK = 1\nexpansion_per_K = {}\nyield_stress_Pa = {}\nviscosity_Pa_s = 5\n",
      k_young, k_alpha, yield_stress_Pa);
  dough.heat = "", dough.leavening = "";
  return dough;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// At the start it is hot and unexpanded: V K/2 (3 alpha dT)^2. Free, it loses that; the elastic strain alone would have said 0, then 9 K
// ...
TEST(WarmElasticDough, HoldsTheEnergyOfItsStressUntilItHasExpanded) {
  const double strain = 3 * k_alpha * k_warmth;
  Dough dough = warm_cube("motion, heat, elasticity", 1e9, true);
  const auto walled = dough.begin();
  EXPECT_NEAR(Sums(*walled).elastic, 0.125 * k_bulk / 2 * strain * strain, 1e-6);
  walled->advance(0.5, 1);
  EXPECT_NEAR(Sums(*walled).elastic, 0.125 * k_bulk / 2 * strain * strain, 0.005 * 0.125 * k_bulk / 2 * strain * strain) << "walls hold it";
}

// Before, nothing but the gas held the thermal stress of dough that yields: it swelled without end.
TEST(WarmPlasticDough, SwellsByItsThermalStrainAndNoFurther) {
  const auto s = warm_cube("motion, heat, elasticity, plasticity", 50, false).begin();
  const double start = Sums(*s).volume;
  for (int i = 1; i <= 4; ++i) {
    s->advance(i, i + 1);
    EXPECT_NEAR(Sums(*s).volume / start, std::exp(3 * k_alpha * k_warmth), 0.05);
  }
}

// Between walls, the pressure K 3 alpha dT = 2500 Pa is above the cap: dough flows into its pores until sqrt(a) p = tau_y, a at the
// porosity that is left, ln J_P = -(3 alpha dT - p / K).
TEST(WarmPlasticDough, FlowsBetweenWallsInsteadOfPushing) {
  constexpr double tau_y = 300;
  const auto s = warm_cube("motion, heat, elasticity, plasticity", tau_y, true).begin();
  s->advance(4, 5);
  double p = 0;
  for (int i = 0; i < 100; ++i) {  // a fixed point: a hardly depends on p
    const double J_P = std::exp(-(3 * k_alpha * k_warmth - p / k_bulk)), n = 1 - 0.7 / J_P, ln = std::log(n);
    p = tau_y / std::sqrt(9 / (4 * ln * ln * (3.5 * n + 1)));
  }
  const Snapshot end = s->snapshot();
  const double J_P = mean(end["plastic_volume_ratio"]);
  EXPECT_NEAR(std::log(J_P), -(3 * k_alpha * k_warmth - p / k_bulk), 0.01 * 3 * k_alpha * k_warmth);
  const double found = std::sqrt(2 * k_bulk * Sums(*s).elastic / 0.125);  // [Pa], if all of the energy is that of pressure
  EXPECT_NEAR(found, p, 0.1 * p) << "waves of the sudden start flow a little too far";
}

// The body fills the space between its walls: what it holds as energy of stress is lost to plastic flow and to nothing else.
TEST(DissipatedWork, IsTheEnergyOfTheStressThatHasFlownAway) {
  double gap[2];
  for (int i = 0; i < 2; ++i) {
    Dough dough = warm_cube("motion, heat, elasticity, plasticity", 300, true);
    dough.time = fmt::format("largest_step_s = {}", i == 0 ? 2e-4 : 1e-4);
    const auto s = dough.begin();
    const double start = Sums(*s).elastic;
    s->advance(0.1, 0.2);
    const Sums now(*s);
    const double lost = start - now.elastic - now.kinetic;
    EXPECT_GT(lost, 0.5 * start) << "else nothing was tested";
    gap[i] = now.dissipated / lost - 1;
  }
  // of first order in the step: the stress after it times what flowed in it
  EXPECT_LT(std::abs(gap[1]), 0.7 * std::abs(gap[0]));
  EXPECT_NEAR(2 * gap[1] - gap[0], 0, 0.03) << gap[0] << " and " << gap[1];
}

// kinetic + elastic + thermoelastic + dissipated - heat that expansion took: nothing else gives or takes. Terms of dt swing to and fro.
TEST(WarmPlasticDough, ClosesTheBooksOfEnergyWhileItFlowsAndExpands) {
  for (const double largest_step : {2e-4, 1e-4}) {
    Dough dough = warm_cube("motion, heat, elasticity, plasticity", 50, false);
    dough.time = fmt::format("largest_step_s = {}", largest_step);
    const auto s = dough.begin();
    const auto energy = [&] {
      const Sums now(*s);
      return now.kinetic + now.elastic + s->total(total::thermoelastic) + now.dissipated - now.expansion;
    };
    const double start = energy();
    s->advance(1, 2);
    EXPECT_GT(Sums(*s).dissipated, 0);
    EXPECT_NEAR(energy(), start, 0.02 * std::abs(Sums(*s).expansion)) << largest_step;
  }
}

}  // namespace
}  // namespace bake

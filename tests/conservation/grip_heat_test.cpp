// SPDX-License-Identifier: MIT
// Dough in grips that hold their temperature.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "tests/conservation/dough.h"

namespace bake {
namespace {

constexpr double k_cold = 20, k_hot = 100;

/// A bar along x whose last six cells on either side are held, hot on the left.
Dough bar(const std::string& effects = "heat") {
  Dough dough(effects);
  dough.low = {-1, 0, 0}, dough.high = {1, 0.25, 0.25};
  dough.heat = "";
  dough.shape = "box = { centre_m = [0, 0.125, 0.125], half_extents_m = [1, 0.125, 0.125] }";
  dough.tables =
      "[[grip]]\ntemperature_C = 100\nshape = { half_space = { point_m = [-0.625, 0, 0], normal = [1, 0, 0] } }\n"
      "[[grip]]\ntemperature_C = 20\nshape = { half_space = { point_m = [0.625, 0, 0], normal = [-1, 0, 0] } }\n";
  return dough;
}

// Before, dough within two cells of the face warmed as conduction over dx would have it, and what lies deeper overshot to 119 C.
TEST(AGrip, HoldsTheTemperatureOfAllDoughInItFromTheFirstStepOn) {
  for (const char* subgrid : {"", "subgrid_diffusion = 0\n"})
    for (const char* integrator : {"", "integrator = \"backward_euler\"\n"}) {
      Dough dough = bar();
      dough.heat = std::string(subgrid) + integrator;
      const auto s = dough.begin();
      take_steps(*s, 40, 1e-3, [&] {
        const Snapshot now = s->snapshot();
        const auto& theta = now["temperature"];
        EXPECT_GT(smallest_of(theta), k_cold - 1e-3) << dough.heat;
        EXPECT_LT(largest_of(theta), k_hot + 1e-3) << dough.heat;
        for (std::size_t p = 0; p < theta.size(); ++p) {
          if (now.position[p][0] > -0.625 - dough.dx) continue;
          EXPECT_NEAR(theta[p], k_hot, 1e-3) << dough.heat;
        }
      });
    }
}

TEST(AGrip, IsBookedWhatItGives) {
  for (const char* effects : {"heat", k_everything})
    for (const char* precision : {"double", "single"})
      for (const char* integrator : {"", "integrator = \"backward_euler\"\n"}) {
        Dough dough = bar(effects);
        dough.heat = std::string("water_specific_heat_J_per_kgK = 40\n") + integrator;
        dough.precision = precision;
        dough.material =
            Dough::properties(Dough::moving_water(), "transition_heat_J_per_kg = 500\ntransition_from_C = 30\ntransition_to_C = 60");
        dough.frame_s = 2e-4;
        const auto s = dough.begin();
        const Sums start(*s);
        take_steps(*s, 50, dough.frame_s);
        const Sums now(*s);
        EXPECT_NEAR(now.heat - start.heat, now.heat_gained() - start.heat_gained(),
                    50 * (10 * round_off(precision) + (*integrator ? 1e-8 : 0)) * now.heat)
            << effects << precision << integrator;
        EXPECT_GT(now.exchanged - start.exchanged, 1e-3 * start.heat) << "else nothing was tested";
      }
}

}  // namespace
}  // namespace bake

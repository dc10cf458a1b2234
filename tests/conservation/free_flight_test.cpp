// SPDX-License-Identifier: MIT
// A spinning, stretched, warm lump of dough flies freely: what each effect must leave alone.
#include <gtest/gtest.h>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

struct Flight {
  const char* name;
  const char* effects;
  const char* motion;
  const char* precision;
};

std::string words(const testing::TestParamInfo<Flight>& info) { return std::string(info.param.name) + "_" + info.param.precision; }

constexpr double k_speed = 1.5, k_spin = 8, k_radius = 0.25;
constexpr int k_steps = 60;

class AFreeFlight : public testing::TestWithParam<Flight> {
 protected:
  Dough dough;
  void SetUp() override {
    const Flight& flight = GetParam();
    dough.effects = flight.effects;
    dough.motion = flight.motion;
    dough.precision = flight.precision;
    dough.shape = "ellipsoid = { half_axes_m = [0.3, 0.25, 0.2] }";
    dough.body = "velocity_m_per_s = [1.2, -0.5, 0.7]\nangular_velocity_rad_per_s = [5, 4, -5]\ntemperature_C = 40";
    dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 1000\n";
  }
  double tolerance(int steps) const { return steps * round_off(dough.precision); }
};

TEST_P(AFreeFlight, KeepsSolidAndWater) {
  const auto s = dough.begin();
  const Sums start(*s);
  EXPECT_GT(start.solid, 0);
  take_steps(*s, k_steps, dough.frame_s, [&](int step, const Sums& now) {
    ASSERT_NEAR(now.solid, start.solid, 1e-13 * start.solid);  // no particle's solid is ever touched: only the order of the sum
    ASSERT_NEAR(now.water + now.evaporated, start.water, tolerance(step) * start.water);
    ASSERT_EQ(now.limited, 0);
  });
}

TEST_P(AFreeFlight, KeepsMomentum) {
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, k_steps, dough.frame_s, [&](int step, const Sums& now) {
    for (std::size_t d = 0; d < 3; ++d)
      ASSERT_NEAR(now.momentum[d], start.momentum[d], tolerance(step) * start.mass() * (k_speed + k_spin * k_radius));
    ASSERT_EQ(now.impulse, (Vector3{0, 0, 0}));
  });
}

TEST_P(AFreeFlight, KeepsAngularMomentum) {
  if (std::string_view(GetParam().motion) != "") GTEST_SKIP() << "only APIC promises it";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, k_steps, dough.frame_s, [&](int step, const Sums& now) {
    const double scale = start.mass() * (k_speed + k_spin * k_radius) * 2 * k_radius;
    for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(now.angular[d], start.angular[d], tolerance(step) * scale);
  });
}

TEST_P(AFreeFlight, KeepsHeatButForWhatIsExchangedAndForTheWorkOfExpansion) {
  const auto s = dough.begin();
  const Sums start(*s);
  const bool warm = dough.effects.find("heat") != std::string::npos;
  take_steps(*s, k_steps, dough.frame_s, [&](int step, const Sums& now) {
    ASSERT_NEAR(now.heat, start.heat + now.heat_gained() - start.heat_gained(), tolerance(step) * (start.heat + std::abs(now.exchanged)));
  });
  if (warm) {
    EXPECT_GT(Sums(*s).heat, 1.05 * start.heat) << "the oven heats: else nothing was tested";
    EXPECT_NE(Sums(*s).expansion, 0);
  }
}

TEST_P(AFreeFlight, NeverGainsEnergyFromPlasticFlow) {
  const auto s = dough.begin();
  double dissipated = 0;
  take_steps(*s, k_steps, dough.frame_s, [&](int, const Sums& now) {
    ASSERT_GE(now.dissipated, dissipated);
    dissipated = now.dissipated;
  });
  const bool plastic = dough.effects.find("plasticity") != std::string::npos;
  EXPECT_EQ(dissipated > 0, plastic) << "the spin makes it yield: else nothing was tested";
}

TEST_P(AFreeFlight, MakesAsMuchGasAsTheReactionSays) {
  if (dough.effects.find("leavening") == std::string::npos) GTEST_SKIP() << "no leavening";
  dough.tables = "";  // no oven, no conduction, no expansion: the temperature stays
  dough.material = Dough::changed({{"conductivity_W_per_mK", "0"}, {"expansion_per_K", "0"}});
  const auto s = dough.begin();
  const double V_0 = Sums(*s).volume;
  take_steps(*s, k_steps, dough.frame_s, [&](int step, const Sums& now) {
    const double made = V_0 * 500 * 0.3 * step * dough.frame_s;  // at 40 C, the peak of the bell curve
    ASSERT_NEAR(now.gas, made, tolerance(step) * made + 1e-15);
  });
}

class AFreeFlightInSingle : public testing::TestWithParam<const char*> {};

TEST_P(AFreeFlightInSingle, MakesNoMomentumStepAfterStep) {
  Dough dough;
  dough.precision = "single";
  dough.kernel = GetParam();
  dough.frame_s = 1e-3;
  dough.shape = "box = { half_extents_m = [0.25, 0.25, 0.25] }";
  dough.body = "velocity_m_per_s = [0.3, 0, 0]";
  const auto s = dough.begin();
  const double start = Sums(*s).momentum[0];
  constexpr int k_flight = 300;
  take_steps(*s, k_flight, dough.frame_s);
  // a velocity is rounded to 6e-8 of itself, up as often as down
  EXPECT_NEAR(Sums(*s).momentum[0], start, 1e-8 * k_flight * start);
}

INSTANTIATE_TEST_SUITE_P(With, AFreeFlightInSingle, testing::Values("quadratic", "cubic"),
                         [](const auto& info) { return std::string(info.param); });

INSTANTIATE_TEST_SUITE_P(Of, AFreeFlight,
                         testing::Values(Flight{"Elastic", "motion, elasticity", "", "double"},          //
                                         Flight{"Elastic", "motion, elasticity", "", "single"},          //
                                         Flight{"ElasticFlip", "motion, elasticity", k_flip, "double"},  //
                                         Flight{"ElasticPic", "motion, elasticity", k_pic, "double"},    //
                                         Flight{"Plastic", "motion, elasticity, plasticity", "", "double"},
                                         Flight{"Plastic", "motion, elasticity, plasticity", "", "single"},
                                         Flight{"Heat", "motion, heat, elasticity", "", "double"},
                                         Flight{"Heat", "motion, heat, elasticity", "", "single"},
                                         Flight{"Water", "motion, water, elasticity", "", "double"},
                                         Flight{"Water", "motion, water, elasticity", "", "single"},
                                         Flight{"Everything", k_everything, "", "double"}, Flight{"Everything", k_everything, "", "single"},
                                         Flight{"EverythingFlip", k_everything, k_flip, "double"}),
                         words);

}  // namespace
}  // namespace bake

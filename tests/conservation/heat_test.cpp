// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

Dough baked(const char* integrator, const char* precision = "double") {
  Dough dough("heat");
  dough.precision = precision;
  dough.body = "temperature_C = 20";
  dough.heat = fmt::format("integrator = \"{}\"", integrator);
  dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 500\n";
  return dough;
}

/// Steps of a millisecond, in each of which at most `share` of the heat is not booked, whatever residual is left. It warms by a twentieth
/// or more.
std::unique_ptr<Simulation> expect_heat_booked(Dough dough, int count, double share) {
  dough.heat += "\ntolerance = 0.1";
  auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, count, 1e-3, [&](int step, const Sums& now) {
    ASSERT_NEAR(now.heat, start.heat + now.exchanged - start.exchanged, step * share * now.heat);
  });
  EXPECT_GT(Sums(*s).heat, 1.05 * start.heat);
  return s;
}

TEST(BackwardEuler, BooksTheHeatThatTheOvenGives) {
  for (const char* precision : {"double", "single"}) expect_heat_booked(baked("backward_euler", precision), 40, round_off(precision));
}

TEST(BothEulers, BookTheHeatOfAGripThatHoldsATemperature) {
  for (const char* integrator : {"forward_euler", "backward_euler"}) {
    Dough dough = baked(integrator);
    dough.tables = "[[grip]]\nshape = { box = { centre_m = [0, 0, 0.25], half_extents_m = [0.3, 0.3, 0.1] } }\ntemperature_C = 80\n";
    expect_heat_booked(dough, 40, 1e-12);
  }
}

/// It melts between 30 and 31 C, which takes as much heat as 25 degrees do.
std::string melting() { return Dough::properties("", "transition_heat_J_per_kg = 500\ntransition_from_C = 30\ntransition_to_C = 31\n"); }

TEST(MeltingDough, BooksTheHeatThatTheOvenGives) {
  for (const char* integrator : {"forward_euler", "backward_euler"}) {
    Dough dough = baked(integrator);
    dough.heat += "\nwater_specific_heat_J_per_kgK = 40";
    dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 2000\n";
    dough.body = "temperature_C = 29.9";
    dough.material = melting();
    const auto s = expect_heat_booked(dough, 400, 1e-12);
    EXPECT_GT(s->highest(highest::temperature), 32) << "else none has molten";
    EXPECT_LT(-s->highest(highest::coldness), 31) << "else all has";
  }
}

TEST(MeltingDough, BooksItsHeatWhileItMovesAndDries) {
  Dough dough = baked("forward_euler");
  dough.heat = Dough().heat;
  dough.effects = "motion, heat, water, elasticity, plasticity, leavening";
  dough.body = "temperature_C = 30.9\nangular_velocity_rad_per_s = [0, 3, 1]";
  dough.tables += "[water]\nlatent_heat_J_per_kg = 1e3\n";
  dough.material =
      Dough::properties(Dough::moving_water(), "transition_heat_J_per_kg = 500\ntransition_from_C = 30\ntransition_to_C = 31\n");
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 40, 1e-3);
  const Sums now(*s);
  EXPECT_NEAR(now.heat, start.heat + now.heat_gained(), 40e-12 * now.heat);
  EXPECT_GT(s->highest(highest::temperature), 31) << "else none has molten";
}

/// Past the transition in one step as well as in many: what was spent on it is the latent heat.
TEST(MeltingDough, HoldsItsLatentHeatOnceItHasMolten) {
  for (const double temperature : {29.0, 30.25, 31.0, 80.0}) {
    Dough dough = baked("forward_euler");
    dough.heat = Dough().heat;
    dough.tables = "";
    dough.body = fmt::format("temperature_C = {}", temperature);
    const double plain = Sums(*dough.begin()).heat, solid = Sums(*dough.begin()).solid;
    dough.material = melting();
    EXPECT_NEAR(Sums(*dough.begin()).heat - plain, 500 * solid * std::clamp(temperature - 30, 0.0, 1.0), 1e-9 * plain) << temperature;
  }
}

TEST(BothEulers, EndAtTheTemperatureOfTheOven) {
  for (const char* integrator : {"forward_euler", "backward_euler"}) {
    Dough dough = baked(integrator);
    dough.frame_s = 0.05;
    dough.dx = 0.125;
    const auto s = dough.begin();
    // Biot number beta R / kappa = 1.25, slowest rate 1.69^2 kappa / (rho c R^2) = 0.46 /s: e^-14 is left after 30 s
    take_steps(*s, 600, dough.frame_s);
    const Sums now(*s);
    // What is left beyond it: differences between particles that the grid hardly sees return slowly (FLIP). The first, steep
    // seconds leave about a hundredth of the rise in single particles, which is a thousandth in their mean.
    EXPECT_NEAR(s->total(total::temperature) / now.volume, 100, 1e-3 * 80) << integrator;
    const double low = -s->highest(highest::coldness), high = s->highest(highest::temperature);
    EXPECT_NEAR(low, 100, 0.03 * 80) << integrator;
    EXPECT_NEAR(high, 100, 0.03 * 80) << integrator;
  }
}

double mean_temperature(const char* integrator, double dt, const char* kernel = "quadratic") {
  Dough dough = baked(integrator);
  dough.kernel = kernel;
  dough.frame_s = dt;
  const auto s = dough.begin();
  take_steps(*s, static_cast<int>(std::lround(0.064 / dt)), dt);
  return Sums(*s).heat;
}
TEST(BothEulers, AgreeAsTheStepGoesToZero) {
  double gap[3];
  for (int i = 0; i < 3; ++i)
    gap[i] = std::abs(mean_temperature("forward_euler", 4e-3 / (1 << i)) - mean_temperature("backward_euler", 4e-3 / (1 << i)));
  EXPECT_GT(gap[0], 0);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(std::log2(gap[i] / gap[i + 1]), 1, 0.25) << "both are of first order";
}

// Right after an ordering no block knows yet which nodes its particles touch: a cubic stencil may reach all of its tile.
TEST(BothEulers, AgreeWithCubicKernels) {
  const double forward = mean_temperature("forward_euler", 1e-3, "cubic");
  EXPECT_NEAR(mean_temperature("backward_euler", 1e-3, "cubic") / forward, 1, 1e-3);
  EXPECT_NEAR(mean_temperature("forward_euler", 1e-3) / forward, 1, 1e-2) << "and it is about that of quadratic ones";
}

TEST(AHeatedCollider, GivesTheHeatThatItBooks) {
  Dough dough = baked("forward_euler");
  dough.heat = Dough().heat;
  dough.tables = R"([[collider]]
shape = { half_space = { point_m = [0, 0, -0.25], normal = [0, 0, 1] } }
temperature_C = 150
heat_transfer_coefficient_W_per_m2K = 500
)";
  dough.shape = "box = { half_extents_m = [0.25, 0.25, 0.25] }";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 40, 1e-3);
  const Sums now(*s);
  EXPECT_NEAR(now.heat, start.heat + now.exchanged - start.exchanged, 40e-12 * now.heat);
  const double contact = s->booked(booked::contact_area);
  EXPECT_NEAR(contact, 0.25, 0.03 * 0.25);  // one face
  EXPECT_GT(now.exchanged, 0.8 * 0.04 * 500 * contact * 100);
}

TEST(HeatAtUniformTemperature, StaysUniformInUniformMotion) {
  Dough dough("motion, heat, water, elasticity");
  dough.body = "velocity_m_per_s = [1, 2, -1.5]";
  const auto s = dough.begin();
  take_steps(*s, 100, dough.frame_s);
  const double low = -s->highest(highest::coldness), high = s->highest(highest::temperature);
  EXPECT_NEAR(low, 20, 20e-10);
  EXPECT_NEAR(high, 20, 20e-10);
}

}  // namespace
}  // namespace bake

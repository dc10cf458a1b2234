// SPDX-License-Identifier: MIT
// Moving and evaporating water: what is kept exactly, and how large the one defect is that is not.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

/// A ball that dries and in which water moves.
Dough drying(const std::string& effects, const std::string& precision = "double") {
  Dough dough(effects);
  dough.precision = precision;
  dough.material = Dough::properties(Dough::moving_water());
  dough.body = "temperature_C = 60\nvelocity_m_per_s = [1, 0, 0]\nangular_velocity_rad_per_s = [0, 0, 4]";
  return dough;
}

class WaterThatMoves : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(WaterThatMoves, IsInTheDoughOrEvaporated) {
  const Dough dough = drying(GetParam().first, GetParam().second);
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 100, dough.frame_s, [&](int step, const Sums& now) {
    ASSERT_NEAR(now.water + now.evaporated, start.water, step * round_off(dough.precision) * start.water);
    ASSERT_EQ(now.limited, 0);
  });
  EXPECT_GT(Sums(*s).evaporated, 0.005 * start.water) << "else nothing was tested";
}
INSTANTIATE_TEST_SUITE_P(With, WaterThatMoves,
                         testing::Values(std::pair{"water", "double"}, std::pair{"water", "single"}, std::pair{"heat, water", "double"},
                                         std::pair{"motion, water, elasticity", "double"}, std::pair{k_everything, "double"},
                                         std::pair{k_everything, "single"}),
                         [](const auto& info) {
                           std::string name = std::string(info.param.first) + "_" + info.param.second;
                           name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == ',' || c == ' '; }), name.end());
                           return name;
                         });

// Vapour leaves with the velocity of the dough: a drying body in uniform motion is not pushed.
TEST(Vapour, TakesItsMomentumWithIt) {
  Dough dough("motion, water, elasticity");
  dough.material = Dough::changed({{"pressure_Pa", "0"}}, "evaporation_kg_per_m2sK = 1");
  dough.surface = "form = \"published\"";  // takes water that does not diffuse: what diffuses pushes its solid
  dough.body = "velocity_m_per_s = [1, -0.5, 0.25]";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 100, dough.frame_s);
  EXPECT_GT(Sums(*s).evaporated, 0.005 * start.water) << "else nothing was tested";
  for (const Vector3& v : s->snapshot().velocity) {
    ASSERT_NEAR(v[0], 1, 1e-10);  // 100 steps of 1e-12
    ASSERT_NEAR(v[1], -0.5, 1e-10);
    ASSERT_NEAR(v[2], 0.25, 1e-10);
  }
}

TEST(Vapour, TakesTheHeatAndTheMomentumThatAreBooked) {
  Dough dough = drying(k_everything);
  dough.tables = "[water]\nlatent_heat_J_per_kg = 1e3\n";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 20, dough.frame_s);
  EXPECT_GT(Sums(*s).latent, 0);
  EXPECT_NEAR(Sums(*s).latent, 1e3 * Sums(*s).evaporated, 1e-9 * Sums(*s).latent);
  EXPECT_NEAR(Sums(*s).vapour_heat, 40 * 60 * Sums(*s).evaporated, 0.1 * Sums(*s).vapour_heat) << "it left at about 60 C";
  const double lost = Sums(*s).evaporated * 1;  // at 1 m/s along x, spin adds nothing in the mean
  EXPECT_NEAR(-Sums(*s).impulse[0], lost, 0.05 * lost);
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// The bookings against the particles themselves, one by one: neither the ledger's sums nor another booking are asked.
TEST(EvaporatedWater, IsWhatTheParticlesHaveLost) {
  for (const char* effects : {"water", "heat, water", k_everything}) {
    const Dough dough = drying(effects);
    const auto s = dough.begin();
    const double before = sum(s->snapshot()["water_mass"]);
    take_steps(*s, 20, dough.frame_s);
    const double lost = before - sum(s->snapshot()["water_mass"]);
    EXPECT_GT(lost, 1e-3 * before) << effects << ": else nothing was tested";
    EXPECT_NEAR(s->booked(booked::evaporated), lost, 1e-5 * lost) << effects << ": particles hold what subgrid diffusion lends them";
  }
}

/// As a limit: next to none comes to the surface if there is next to no diffusivity.
TEST(DoughWithoutDiffusivity, LosesNoWater) {
  for (const char* effects : {"water", "heat, water", k_everything})
    for (const char* diffusivity : {"0", "1e-14"}) {
      Dough dough = drying(effects);
      dough.material = Dough::properties(fmt::format("evaporation_kg_per_m2sK = 0.5\ndiffusivity_m2_per_sK = {}", diffusivity));
      const auto s = dough.begin();
      const Sums start(*s);
      take_steps(*s, 20, dough.frame_s);
      EXPECT_LE(Sums(*s).evaporated, 1e-6 * start.water) << effects << diffusivity;
    }
}

TEST(LatentHeat, IsWhatTheParticlesHaveCooledBy) {
  Dough dough = drying("heat, water");
  dough.tables = "[water]\nlatent_heat_J_per_kg = 1e4\n";  // no oven
  const auto s = dough.begin();
  const double c_s = 20, c_w = 40;  // [J/(kg K)]
  const auto content = [&] {
    const Snapshot now = s->snapshot();
    double all = 0;
    for (std::size_t i = 0; i < now.id.size(); ++i)
      all += (c_s * now["solid_mass"][i] + c_w * now["water_mass"][i]) * now["temperature"][i];
    return all;
  };
  const double before = content(), water = sum(s->snapshot()["water_mass"]);
  take_steps(*s, 20, dough.frame_s);
  const double lost = water - sum(s->snapshot()["water_mass"]), taken = before - content();
  const double with_vapour = c_w * 60 * lost;  // it leaves at the surface's temperature, of 60 C and below
  EXPECT_GT(s->booked(booked::latent_heat), 0.01 * before) << "else nothing was tested";
  EXPECT_NEAR(s->booked(booked::latent_heat), taken - with_vapour, 0.3 * with_vapour);
  EXPECT_LT(with_vapour, 0.3 * s->booked(booked::latent_heat)) << "the bound is sharp";
}

// Water's mass is remapped by one operator (19), what it carries by another (the transfers). Where velocity or temperature vary
// within a stencil the two differ; the difference has columns of its own, with which the books close to round-off.

/// A ball in which water moves and nothing evaporates, hit by a drier one. Checks the books; returns the remapped heat over the heat.
double hit_by_a_drier_ball(bool uniform) {
  Dough dough(k_everything);
  dough.frame_s = 2e-4;
  // uniform: nothing that would change a temperature
  dough.material = Dough::changed({{"expansion_per_K", uniform ? "0" : "1e-4"}}, "diffusivity_m2_per_sK = 2e-4");
  dough.shape = "sphere = { centre_m = [0, 0, -0.15], radius_m = 0.5 }";
  dough.body = std::string("temperature_C = 60\nsaturation = 0.4\n") +
               (uniform ? "" : "angular_velocity_rad_per_s = [0, 0, 4]\nvelocity_m_per_s = [1, 0, 0]");
  dough.tables = std::string(uniform ? "" : "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 1000\n") + R"([[body]]
material = "dough"
particles_per_cell = 8
temperature_C = 60
saturation = 0.1
velocity_m_per_s = )" +
                 (uniform ? "[0, 0, 0]" : "[-1, 0, 0.5]") + R"(
shape = { sphere = { centre_m = [0, 0, 0.55], radius_m = 0.25 } }
)";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 52, dough.frame_s);
  const Sums now(*s);
  EXPECT_EQ(now.limited, 0);
  EXPECT_GT(length(now.remapped), 0) << "else nothing was tested";
  const double steps = 52e-12;
  for (std::size_t d = 0; d < 3; ++d)
    EXPECT_NEAR(now.momentum[d], start.momentum[d] + now.remapped[d] + now.impulse[d], steps * start.mass() * 4);
  EXPECT_NEAR(now.heat, start.heat + now.heat_gained(), steps * start.heat);
  return std::abs(now.remapped_heat) / start.heat;
}

TEST(WaterThatMoves, CarriesItsMomentumAndHeatUpToARemapThatIsBooked) { EXPECT_GT(hit_by_a_drier_ball(false), 0); }
TEST(WaterThatMoves, CarriesItsHeatExactlyAtUniformTemperature) { EXPECT_LE(hit_by_a_drier_ball(true), 52e-12); }

/// Remapped momentum and heat (over those of the body) where all fields are smooth: a wet warm half and a dry cool one that slide
/// past each other, from when diffusion and waves have smoothed the jump.
std::pair<double, double> remap_of_smooth_fields(double dx) {
  Dough dough("motion, heat, water, elasticity");
  dough.dx = dx;
  dough.frame_s = 5e-4;
  dough.material = Dough::properties("diffusivity_m2_per_sK = 2e-3");
  dough.shape = "box = { centre_m = [-0.25, 0, 0], half_extents_m = [0.25, 0.5, 0.25] }";
  dough.body = "temperature_C = 60\nsaturation = 0.3\nvelocity_m_per_s = [0, 0.3, 0]";
  dough.tables = R"([[body]]
material = "dough"
particles_per_cell = 8
temperature_C = 40
saturation = 0.1
velocity_m_per_s = [0, -0.3, 0]
shape = { box = { centre_m = [0.25, 0, 0], half_extents_m = [0.25, 0.5, 0.25] } }
)";
  const auto s = dough.begin();
  take_steps(*s, 300, dough.frame_s);
  const Sums start(*s);
  take_steps(*s, 100, dough.frame_s);
  const Sums now(*s);
  return {length(now.remapped - start.remapped) / (start.mass() * 0.3), std::abs(now.remapped_heat - start.remapped_heat) / start.heat};
}

// The difference is the covariance of the two remaps, of second order in dx. It is a sum of both signs, which may pass through zero
// on the way: so no slope is fitted; four times finer it must be less than first order would leave.
TEST(WaterThatMoves, RemapsMomentumAndHeatLessOnAFinerGrid) {
  const auto coarse = remap_of_smooth_fields(0.125), fine = remap_of_smooth_fields(0.03125);
  std::printf("remapped in 0.05 s: momentum %.3g -> %.3g, heat %.3g -> %.3g\n", coarse.first, fine.first, coarse.second, fine.second);
  EXPECT_LT(fine.first, coarse.first / 4);
  EXPECT_LT(fine.second, coarse.second / 4);
}

// Pure expansion, no flux: standard form to round-off, the printed one loses water at the rate of div v.
double water_left_at(double& volume_ratio, const char* form) {
  Dough dough(k_everything);
  dough.tables = fmt::format("[water]\nform = \"{}\"\n", form);
  dough.body = "temperature_C = 40";
  dough.frame_s = 2e-3;
  dough.material = Dough::changed({{"production_mol_per_kgs", "1"}});
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 150, dough.frame_s);
  volume_ratio = Sums(*s).volume / start.volume;
  return Sums(*s).water / start.water;
}
TEST(DoughThatRises, KeepsItsWaterInTheStandardFormAndLosesItInThePublishedOne) {
  double grown = 0;
  EXPECT_NEAR(water_left_at(grown, "standard"), 1, 150e-12);
  EXPECT_GT(grown, 1.1) << "else nothing was tested";
  // d m_w = -m_w div v dt: m_w falls as 1 / J (half of it is gone at doubled volume)
  const double left = water_left_at(grown, "published");
  EXPECT_NEAR(left, 1 / grown, 0.02);
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// Heat through faces of the domain.
#include <gtest/gtest.h>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

const std::string k_held = "[[face]]\nat = \"z_min\"\ntemperature_C = 150\nledger = true\n";
const std::string k_behind_a_film = k_held + "heat_transfer_coefficient_W_per_m2K = 400\n";
const std::string k_flux = "[[face]]\nat = \"z_min\"\nheat_flux_W_per_m2 = [[0, 4e4], [1, 6e4]]\nledger = true\n";

/// A slab of dough that reaches from the lower face to the middle of the domain, and from mirror to mirror.
Dough slab(const std::string& face) {
  Dough dough;
  dough.effects = "heat";
  dough.heat = "";
  dough.frame_s = 1e-2;
  dough.low = {0, 0, 0};
  dough.high = {0.25, 0.25, 1};
  dough.shape = "box = { centre_m = [0.125, 0.125, 0.25], half_extents_m = [0.125, 0.125, 0.25] }";
  dough.tables = face;
  return dough;
}

TEST(AFaceThatPassesHeat, GivesWhatTheDoughGains) {
  for (const std::string& face : {k_held, k_behind_a_film, k_flux})
    for (const char* heat : {"", "integrator = \"backward_euler\""})
      for (const char* precision : {"double", "single"}) {
        Dough dough = slab(face);
        dough.precision = precision;
        dough.heat = heat;
        const auto s = dough.begin();
        const Sums start(*s);
        take_steps(*s, 200, 1e-2);
        const Sums now(*s);
        const double error = 200 * (round_off(precision) + (*heat ? 1e-8 : 0)) * now.heat;
        EXPECT_NEAR(now.heat, start.heat + now.exchanged, error) << face << heat << precision;
        EXPECT_NEAR(s->given().front().heat, now.exchanged, error) << face << heat << precision;
        EXPECT_GT(now.heat, 1.1 * start.heat) << "else nothing was tested";
        EXPECT_NEAR(s->booked(booked::contact_area), 0.25 * 0.25, 1e-3) << face;
      }
}

TEST(AFaceThatPassesHeat, KeepsTheBooksOfDoughThatFallsOnItAndDries) {
  for (const std::string& face : {k_held, k_behind_a_film, k_flux}) {
    Dough dough;
    dough.effects = k_everything;
    dough.gravity = "[0, 0, -9.81]";
    dough.low = {-0.5, -0.5, -0.3};
    dough.high = {0.5, 0.5, 0.5};
    dough.material = Dough::properties(Dough::moving_water());
    dough.tables = face;
    dough.body = "velocity_m_per_s = [0, 0, -2]";
    dough.frame_s = 5e-4;
    const auto s = dough.begin();
    const Sums start(*s);
    take_steps(*s, 50, dough.frame_s);
    const Sums now(*s);
    EXPECT_NEAR(now.heat, start.heat + now.heat_gained(), 50e-12 * now.heat) << face;
    EXPECT_NEAR(s->given().front().heat, now.exchanged, 50e-12 * now.heat) << face;
    EXPECT_GT(now.exchanged, 1e-3 * start.heat) << "else nothing was tested";
  }
}

TEST(AFaceWithAFlux, LetsInThatMuchHeat) {
  const auto s = slab("[[face]]\nat = \"z_min\"\nheat_flux_W_per_m2 = 5e4\n").begin();
  take_steps(*s, 50, 1e-2);
  EXPECT_NEAR(Sums(*s).exchanged / (5e4 * 0.25 * 0.25 * 0.5), 1, 2e-3);
}

/// A step takes the mean of what changes with time, however short that lasts.
TEST(AFaceWithAFlux, LetsInWhatComesAndGoesWithinAStep) {
  for (const char* heat : {"", "integrator = \"backward_euler\""}) {
    Dough dough = slab("[[face]]\nat = \"z_min\"\nheat_flux_W_per_m2 = [[0.004, 0], [0.0041, 5e4], [0.006, 5e4], [0.0061, 0]]\n");
    dough.heat = heat;
    const auto s = dough.begin();
    take_steps(*s, 1, 1e-2);
    EXPECT_NEAR(Sums(*s).exchanged / (5e4 * 0.25 * 0.25 * 0.002), 1, 2e-3) << heat;
  }
}

TEST(DoughInAnOvenThatChanges, GainsAsMuchInLongStepsAsInShortOnes) {
  const auto gained = [](int steps) {
    Dough dough = slab("[oven]\ntemperature_C = [[0, 20], [0.003, 220], [0.006, 20]]\nheat_transfer_coefficient_W_per_m2K = 400\n");
    dough.frame_s = 1e-2 / steps;
    const auto s = dough.begin();
    take_steps(*s, steps, dough.frame_s);
    return Sums(*s).exchanged;
  };
  EXPECT_NEAR(gained(1) / gained(100), 1, 0.02);
}

/// Dough in the edge of two faces.
TEST(FacesThatMeet, EachLetInWhatTheirAreaPassesWhicheverComesFirst) {
  const auto face = [](const char* at) { return fmt::format("[[face]]\nat = \"{}\"\nheat_flux_W_per_m2 = 5e4\nledger = true\n", at); };
  const auto heats = [](const std::string& faces) {
    Dough dough = slab(faces);
    dough.high = {1, 0.25, 1};
    dough.shape = "box = { centre_m = [0.125, 0.125, 0.125], half_extents_m = [0.125, 0.125, 0.125] }";
    const auto s = dough.begin();
    take_steps(*s, 50, 1e-2);
    return std::pair(s->given()[0].heat, s->given()[1].heat);
  };
  const auto [x, z] = heats(face("x_min") + face("z_min"));
  const auto [z_first, x_second] = heats(face("z_min") + face("x_min"));
  EXPECT_NEAR(x / x_second, 1, 1e-9);
  EXPECT_NEAR(z / z_first, 1, 1e-9);
  for (const double heat : {x, z}) EXPECT_NEAR(heat / (5e4 * 0.25 * 0.25 * 0.5), 1, 0.04);
}

/// Between a face and the air dough becomes as warm as the resistances 1 / beta, L / kappa and 1 / beta_air have it.
TEST(ASlabBetweenAFaceAndTheAir, ComesToTheTemperaturesOfItsResistances) {
  constexpr double kappa = 100, length = 0.25, beta_air = 300, hot = 150, cold = 20;
  for (const char* kernel : {"quadratic", "cubic"})
    for (const double beta : {400.0, k_infinity}) {
      Dough dough = slab(beta < k_infinity ? k_behind_a_film : k_held);
      dough.kernel = kernel;
      dough.shape = "box = { centre_m = [0.125, 0.125, 0.125], half_extents_m = [0.125, 0.125, 0.125] }";
      dough.body = "temperature_C = 90";
      dough.tables += fmt::format("[oven]\ntemperature_C = {}\nheat_transfer_coefficient_W_per_m2K = {}\n", cold, beta_air);
      const auto s = dough.begin();
      s->advance(20, 21);
      const double before = s->given().front().heat;
      s->advance(21, 22);
      const double flux = (s->given().front().heat - before) / (0.25 * 0.25);
      const double expected = (hot - cold) / (1 / beta + length / kappa + 1 / beta_air);
      EXPECT_NEAR(flux / expected, 1, 0.02) << kernel << beta;
      const Snapshot now = s->snapshot();
      double worst = 0;
      for (std::size_t p = 0; p < now.id.size(); ++p)
        if (const double z = now.position[p][2]; std::abs(z - length / 2) < length / 4)  // nodes do not resolve the layers at the surfaces
          worst = std::max(worst, std::abs(now["temperature"][p] - (hot - expected * (1 / beta + z / kappa))));
      EXPECT_LT(worst, 0.02 * (hot - cold)) << kernel << beta;
    }
}

/// A face and a collider beyond it are the same wall.
TEST(AFaceThatPassesHeat, GivesWhatAPlateThereWouldGive) {
  const auto face = slab(k_behind_a_film).begin();
  Dough dough = slab(
      "[[collider]]\nshape = { half_space = { point_m = [0, 0, 0], normal = [0, 0, 1] } }\ntemperature_C = 150\n"
      "heat_transfer_coefficient_W_per_m2K = 400\n");
  dough.low = {0, 0, -0.5};
  const auto plate = dough.begin();
  for (const auto* s : {&face, &plate}) take_steps(**s, 100, 1e-2);
  EXPECT_NEAR(Sums(*face).exchanged / Sums(*plate).exchanged, 1, 1e-9);
}

}  // namespace
}  // namespace bake

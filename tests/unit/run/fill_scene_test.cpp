// SPDX-License-Identifier: MIT
#include "solver/run/fill_scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "solver/scene/scene_builder.h"

namespace bake {
namespace {

double weight(const std::vector<NewParticle>& particles) {
  double volume = 0;
  for (const NewParticle& p : particles) volume += p.volume;
  return volume;
}

/// A body of dough on a grid of 1 mm (paper), 2 and 4 mm.
struct Fills : SceneBuilder {
  Fills() {
    dx = 1e-3;
    low = {-0.06, -0.06, -0.06}, high = {0.06, 0.06, 0.06};
    material = "density_kg_per_m3 = 1000\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1";
  }
  void expect_volume(const std::string& of, double volume, double tolerance) {
    shape = of;
    for (const char* filling : {"lattice", "poisson"})
      for (const Quality quality : {Quality::draft, Quality::standard, Quality::paper}) {
        body = std::string("filling = \"") + filling + "\"";
        Scene filled = scene();
        filled.quality = quality;
        EXPECT_NEAR(weight(fill_bodies(filled)) / volume, 1, tolerance) << of << " " << filling << " dx " << filled.dx();
      }
  }
};

TEST(FillBodies, WeighWhatTheirShapesWeighAtEveryQualityFillingAndOffset) {
  constexpr double pi = std::numbers::pi;
  Fills fills;
  fills.expect_volume("box = { centre_m = [0, 0, 0.01], half_extents_m = [0.015, 0.015, 0.0004] }", 9e-4 * 8e-4, 1e-12);  // a wafer
  fills.expect_volume("sphere = { centre_m = [0.00123, -0.0031, 0.0007], radius_m = 0.0095 }", 4 * pi / 3 * std::pow(0.0095, 3), 1e-12);
  fills.expect_volume("cylinder = { from_m = [0, 0.001, 0], to_m = [0.02, 0.01, 0], radius_m = 0.007 }",
                      pi * 4.9e-5 * std::hypot(0.02, 0.009), 1e-12);
  fills.expect_volume("difference = [{ sphere = { radius_m = 0.02 } }, { half_space = { point_m = [0, 0, 0.003] } }]",
                      pi * 0.017 * 0.017 * (0.06 - 0.017) / 3, 1e-3);
  fills.dx = 0.004 / 1.3;
  fills.expect_volume("box = { half_extents_m = [0.025, 0.025, 0.025] }", 1.25e-4, 1e-12);
}

TEST(FillBodies, GivesAllParticlesOfAShapeTheSameVolume) {
  Fills fills;
  fills.shape = "sphere = { radius_m = 0.01 }";
  const auto particles = fill_bodies(fills.scene());
  for (const NewParticle& p : particles) EXPECT_EQ(p.volume, particles[0].volume);
}

TEST(FillBodies, LeavesVolumesFromAFileAsTheyAre) {
  Fills fills;
  fills.low = {-0.3, -0.3, -0.3}, fills.high = {0.3, 0.3, 0.3};
  fills.material += "\n[[material]]\nname = \"other\"\ndensity_kg_per_m3 = 1000\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1";
  fills.tables = "[[body]]\nmaterial = \"dough\"\nparticles_file = \"" BAKE_SOURCE_DIR "/experiments/features/ring.h5\"";
  const auto draft = fill_bodies(fills.scene());
  fills.dx *= 1.7;
  EXPECT_EQ(weight(fill_bodies(fills.scene())), weight(draft));
}

/// A scene with an emitter alone, which pours from 0.5 s on, and all that it has poured by `until`.
struct Pours : Fills {
  std::string spout, velocity;
  Scene pouring(double until, Quality quality) {
    effects = "motion, elasticity";
    material = "density_kg_per_m3 = 1000\nyoung_modulus_Pa = 1e4";
    shape = "";
    tables = "[[emitter]]\nmaterial = \"dough\"\nshape = { " + spout + " }\nvelocity_m_per_s = " + velocity +
             "\nfrom_s = 0.5\nuntil_s = " + std::to_string(until);
    Scene poured = scene();
    poured.quality = quality;
    return poured;
  }
  void expect_volume_flow(const std::string& of, const std::string& at, double flow) {
    spout = of, velocity = at;
    for (const Quality quality : {Quality::draft, Quality::standard})
      for (const double until : {1.0, 1.773, 2.9}) {
        const Scene poured = pouring(until, quality);
        EmitterState emitter(poured, poured.emitters[0], 0);
        double volume = 0;
        while (emitter.next_time() < k_infinity) volume += weight(emitter.pour());
        EXPECT_NEAR(volume / (flow * (until - 0.5)), 1, 0.01) << of << " until " << until << " s, dx " << poured.dx();
      }
  }
};

TEST(AnEmitter, PoursTheCrossSectionTimesSpeedTimesTimeAtEveryQuality) {
  constexpr double pi = std::numbers::pi;
  Pours pours;
  pours.expect_volume_flow("box = { half_extents_m = [0.01, 0.02, 0.0041] }", "[0, 0, -0.05]", 0.02 * 0.04 * 0.05);
  pours.expect_volume_flow("cylinder = { from_m = [0, 0, 0], to_m = [0.02, 0.015, 0], radius_m = 0.011 }", "[0.04, 0.03, 0]",
                           pi * 0.011 * 0.011 * 0.05);
  pours.expect_volume_flow(
      "intersection = [{ cylinder = { from_m = [0, 0, 0], to_m = [0, 0.02, 0], radius_m = 0.017 } }, "
      "{ half_space = { normal = [0, 0, 1] } }]",
      "[0, 0.1, 0]", pi / 2 * 0.017 * 0.017 * 0.1);
}

TEST(AnEmitter, KnowsAboutHowManyParticlesItPours) {
  Pours pours;
  pours.spout = "box = { half_extents_m = [0.01, 0.02, 0.0041] }", pours.velocity = "[0, 0, -0.05]";
  for (const double end : {0.3, 1.2, 4.0}) {  // before it pours, while it does, and after
    const Scene poured = pours.pouring(2, Quality::draft);
    EmitterState emitter(poured, poured.emitters[0], 0);
    double all = 0, mean = 0;
    while (emitter.next_time() <= end) {
      const double time = emitter.next_time(), slice = static_cast<double>(emitter.pour().size());
      all += slice;
      mean += slice * (end - time) / end;
    }
    EXPECT_NEAR(emitter.particles_by(end, false), all, 0.05 * all) << end;
    EXPECT_NEAR(emitter.particles_by(end, true), mean, 0.1 * mean) << end;  // what comes in slices comes a little later
    EXPECT_EQ(all > 0, end > 0.5);
  }
}

TEST(AnEmitter, PushesDoughOutAtItsRearEndAndLeavesNoGapsInIt) {
  Pours pours;
  pours.spout = "box = { centre_m = [0, 0, 0.01], half_extents_m = [0.02, 0.02, 0.011] }", pours.velocity = "[0, 0, -0.02]";
  const Scene poured = pours.pouring(3, Quality::draft);
  EmitterState emitter(poured, poured.emitters[0], 0);
  EXPECT_GT(emitter.next_time(), 0.5) << "at the start nothing is there yet";
  std::vector<double> below(5, 0);  // per centimetre, when pouring ends after 5 cm, had nothing stopped the dough
  while (emitter.next_time() < k_infinity) {
    const double time = emitter.next_time(), poured_length = 0.02 * (time - 0.5);
    for (const NewParticle& p : emitter.pour()) {
      EXPECT_LE(p.x[2], 0.021);
      EXPECT_GT(p.x[2], 0.021 - std::min(poured_length, 2 * poured.dx()));
      const double depth = 0.021 - (p.x[2] - 0.02 * (3 - time));
      below.at(static_cast<std::size_t>(depth / 0.01)) += p.volume;
    }
  }
  for (const double volume : below) EXPECT_NEAR(volume / (0.04 * 0.04 * 0.01), 1, 0.05);
}

TEST(AnEmitter, PoursOtherParticlesEachTimeAndTheSameAfterAResume) {
  Pours pours;
  pours.spout = "box = { half_extents_m = [0.02, 0.02, 0.01] }", pours.velocity = "[0, 0, -0.02]";
  const Scene poured = pours.pouring(5, Quality::draft);
  EmitterState emitter(poured, poured.emitters[0], 0), resumed(poured, poured.emitters[0], 0);
  std::vector<std::vector<NewParticle>> slices;
  while (emitter.next_time() < k_infinity) slices.push_back(emitter.pour());
  constexpr std::size_t k_later = 20;
  ASSERT_GT(slices.size(), k_later);
  resumed.skip_to(k_later);
  const auto again = resumed.pour();
  ASSERT_EQ(again.size(), slices[k_later].size());
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].x, slices[k_later][i].x);
  for (std::size_t k = 1; k < slices.size(); ++k)
    for (std::size_t i = 0; i < std::min(slices[k].size(), slices[0].size()); ++i)
      EXPECT_NE(slices[k][i].x[0], slices[0][i].x[0]) << "would follow on the same path";
}

}  // namespace
}  // namespace bake

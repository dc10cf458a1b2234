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

}  // namespace
}  // namespace bake

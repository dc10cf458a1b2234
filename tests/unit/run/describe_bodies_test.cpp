// SPDX-License-Identifier: MIT
#include "solver/run/describe_bodies.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solver/scene/scene_builder.h"

namespace bake {
namespace {

struct Kitchen : SceneBuilder {
  Kitchen() {
    effects = "heat, water";
    dx = 0.05;
    material =
        "density_kg_per_m3 = 500\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\ninitial_saturation = 0.2\n"
        "diffusivity_m2_per_sK = 1e-9";
  }
  void add_box(const char* kind, const std::string& head, double low_z, double high_z, const std::string& more = "") {
    tables += fmt::format("[[{}]]\n{}\nshape = {{ box = {{ centre_m = [0, 0, {}], half_extents_m = [0.2, 0.1, {}] }} }}\n{}\n", kind, head,
                          (low_z + high_z) / 2, (high_z - low_z) / 2, more);
  }
  void add_body(double low_z, double high_z, const std::string& more = "") { add_box("body", "material = \"dough\"", low_z, high_z, more); }
  std::string described() const { return describe_bodies(scene()); }
};

TEST(DescribeBodies, SaysMassVolumeAndWater) {
  Kitchen kitchen;
  kitchen.add_body(0, 0.2);
  kitchen.add_body(0.3, 0.5, "saturation = 0.3");  // more water on the same solid
  EXPECT_EQ(kitchen.described(),
            "  body.0       dough: 8 kg, 0.016 m^3, 3.2 kg of it water, 735 particles\n"
            "  body.1       dough: 9.6 kg, 0.016 m^3, 4.8 kg of it water, 735 particles\n");
  kitchen.effects = "heat";
  kitchen.overrides = {"body.0.filling=poisson"};
  EXPECT_NE(kitchen.described().find("  body.0       dough: 8 kg, 0.016 m^3, 0 kg of it water, "), std::string::npos)
      << kitchen.described();
}

TEST(DescribeBodies, SaysWhichOverlapAndWhichLieInColliders) {
  Kitchen kitchen;
  kitchen.add_body(0, 0.2);
  kitchen.add_body(0.15, 0.65);
  kitchen.add_body(0.65, 0.85);                                // touches the one before
  kitchen.add_box("collider", "name = \"tray\"", -0.3, 0.02);  // in a tenth of body.0
  kitchen.add_box("collider", "name = \"plate\"", -0.3, 0);    // touches it
  kitchen.add_box("collider", "name = \"later\"", -0.3, 0.1, "from_s = 1");
  kitchen.add_box("collider", "", 2.15, 2.25, "motion = [{ time_s = 0, position_m = [0, 0, -1.5] }]");  // now from 0.65 to 0.75
  const std::string text = kitchen.described();
  EXPECT_NE(text.find("\n  overlap      body.0 and body.1 share 0.004 m^3: 25 % of body.0 and 10 % of body.1\n"
                      "  overlap      10 % of body.0 lies in collider.tray\n"
                      "  overlap      50 % of body.2 lies in collider.3\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("warning"), std::string::npos) << text;
}

TEST(DescribeBodies, ComparesParticlesFromAFileWithShapes) {
  Kitchen kitchen;
  kitchen.material += "\n[[material]]\nname = \"other\"\ndensity_kg_per_m3 = 900\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1";
  kitchen.tables = "[[body]]\nmaterial = \"dough\"\nparticles_file = \"" BAKE_SOURCE_DIR "/experiments/features/ring.h5\"\n";
  kitchen.add_box("collider", "name = \"bowl\"", -1, 1);
  EXPECT_NE(kitchen.described().find("% of body.0 lies in collider.bowl\n"), std::string::npos) << kitchen.described();
}

TEST(DescribeBodies, WarnsOfAShapeThatIsThinnerThanItsParticlesResolve) {
  Kitchen kitchen;
  kitchen.add_body(0, 0.01);  // particles are 0.0275 m apart
  const std::string text = kitchen.described();
  EXPECT_NE(text.find("  body.0       dough: 0.4 kg, "), std::string::npos) << text;
  EXPECT_NE(
      text.find(
          "\n  warning      body.0: its particles have 0.53 of their usual volume: at dx = 0.05 m its shape is only a few of them thick"),
      std::string::npos)
      << text;
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// [[skin]]: what it says, and what is refused in one line.
#include <gtest/gtest.h>

#include "solver/scene/reader.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

const std::string k_flesh = "effects = [\"motion\", \"elasticity\"]\n" + k_least + R"([[material]]
name = "flesh"
density_kg_per_m3 = 1000
young_modulus_Pa = 2000
[[body]]
material = "flesh"
shape = { sphere = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2 } }
[[body]]
material = "flesh"
particles_file = "fruit.h5"
)";
const std::string k_skin = "[[skin]]\nyoung_modulus_Pa = 1e5\nthickness_m = 1e-3\n";

Scene read(const std::string& text) { return parse_scene(text, "fruit.toml", {}); }

TEST(ASkinOfAScene, IsReadWithItsDefaults) {
  const Scene scene = read(k_flesh + k_skin);
  ASSERT_EQ(scene.skins.size(), 1U);
  const Skin& skin = scene.skins[0];
  EXPECT_EQ(skin.body, std::vector<double>{0});
  EXPECT_EQ(skin.permeance, 1);
  EXPECT_EQ(skin.depth_dx, 0.4);
  EXPECT_EQ(skin.mass_per_area(), 1);
  EXPECT_NEAR(skin.bending_stiffness(), 1e5 * 1e-9 / (12 * 0.91), 1e-12);
  EXPECT_EQ(skin.only, nullptr);
  EXPECT_TRUE(read(k_flesh).skins.empty());
}

TEST(ASkinOfAScene, IsRefusedInOneLineThatSaysWhatIsAllowed) {
  const auto expect = [](const std::string& text, const std::string& part) {
    const std::string found = message_of<InputError>([&] { read(text); });
    EXPECT_NE(found.find(part), std::string::npos) << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  };
  expect(k_flesh + k_skin + "thicknes_m = 2", "thickness_m");
  const std::string ring = "y_min = \"periodic\"\ny_max = \"periodic\"\nmin_m";
  expect(replaced(k_flesh, "min_m", ring) + k_skin, "skin.0: found a skin in a domain with periodic faces, allowed: no skin");
  expect(k_flesh + "[[skin]]\nthickness_m = 1e-3", "skin.0.young_modulus_Pa");
  expect(k_flesh + k_skin + "permeance = 1.5", "a number from 0 to 1");
  expect(k_flesh + k_skin + "poisson_ratio = 0.6", "from -0.99 to 0.5");
  expect(k_flesh + k_skin + "stress_free = \"end\"", "unknown name 'end', allowed: start");
  expect(k_flesh + k_skin + "body = 2", "found 2, allowed: whole numbers from 0 to 1");
  expect(k_flesh + k_skin + "body = 0.5", "found 0.5, allowed: whole numbers from 0 to 1");
  expect(k_flesh + k_skin + "body = []", "found none, allowed: numbers of bodies");
  expect(k_flesh + k_skin + "body = [0, 0]", "found 0 again, allowed: each body once");
  expect(k_flesh + k_skin + "body = 1", "found body.1, whose particles come from a file, allowed: with it a mesh_file");
  expect(k_flesh + k_skin + "body = [0, 1]\nmesh_file = \"skin.hdf\"", "found one mesh for 2 bodies");
  expect("effects = []\n" + k_flesh.substr(k_flesh.find("[run]")) + k_skin, "found a skin without the effect 'motion'");
  expect(k_flesh + k_skin + "[motion]\ntransfer = \"flip\"", "allowed: \"apic\" or \"pic\"");
  expect(k_flesh + k_skin + "[surface]\nform = \"published\"", "allowed: \"standard\"");
}

}  // namespace
}  // namespace bake::test

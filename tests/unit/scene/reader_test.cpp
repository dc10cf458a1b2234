// SPDX-License-Identifier: MIT
#include "solver/scene/reader.h"

#include <filesystem>
#include <fstream>

#include "solver/effects/all_effects.h"
#include "solver/scene/describe.h"
#include "solver/scene/layout.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

using Names = std::vector<std::string>;

TEST(SceneReader, WhatIsNotGivenKeepsItsDefault) {
  const Scene scene = parse(k_least);
  EXPECT_EQ(scene.run.end_s, 2);
  EXPECT_EQ(scene.run.frame_rate_per_s, RunSettings{}.frame_rate_per_s);
  EXPECT_EQ(scene.run.precision, Precision::single_precision);
  EXPECT_EQ(scene.time.largest_step_s, k_infinity);
  EXPECT_EQ(scene.oven.temperature_C(17), 20);
  EXPECT_EQ(scene.of<Motion>().gravity_m_per_s2(17), (Vector3{0, 0, -9.81}));
  EXPECT_TRUE(scene.effects.empty());
}

TEST(SceneReader, GravityMayChangeWithTime) {
  const Scene scene = parse(k_least + "[motion]\ngravity_m_per_s2 = [[0, [0, 0, 0]], [0.5, [2, 0, -8]]]\n");
  EXPECT_EQ(scene.of<Motion>().gravity_m_per_s2(0.25), (Vector3{1, 0, -4}));
  EXPECT_EQ(scene.of<Motion>().gravity_m_per_s2(2), (Vector3{2, 0, -8}));
}

TEST(SceneReader, ASceneWithoutBodiesIsLegal) { EXPECT_TRUE(parse(k_least).bodies.empty()); }

TEST(SceneReader, EveryKindOfValueArrives) {
  const Scene scene = parse(k_full);
  EXPECT_EQ(scene.title, "a full kitchen");
  EXPECT_EQ(scene.file, "bread.toml");
  EXPECT_EQ(scene.run.precision, Precision::double_precision);
  EXPECT_EQ(scene.grid.kernel, KernelOrder::cubic);
  EXPECT_EQ(scene.domain.min_m, (Vector3{-1, -1, 0}));
  EXPECT_EQ(scene.domain.z_max, Face::open);
  EXPECT_EQ(scene.domain.z_min, Face::separating);
  EXPECT_DOUBLE_EQ(scene.oven.temperature_C(30), 110);
  EXPECT_EQ(scene.of<Heat>().integrator, Heat::Integrator::backward_euler);
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(of<Plasticity>(scene.materials[0]).yield_stress_Pa, (std::array<double, 4>{200, 100, 50, 1000}));
  EXPECT_EQ(of<Plasticity>(scene.materials[0]).viscosity_Pa_s, (std::array<double, 4>{40, 40, 40, 40}));
  EXPECT_EQ(of<Elasticity>(scene.materials[1]).young_modulus_Pa, 1e6);
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[0].temperature_C, 5);
  EXPECT_EQ(scene.bodies[0].saturation, std::nullopt);
  EXPECT_EQ(scene.bodies[1].particles_file, "chips/all.h5");
  ASSERT_TRUE(scene.colliders[0].temperature_C.has_value());
  EXPECT_DOUBLE_EQ((*scene.colliders[0].temperature_C)(15), 100);
  EXPECT_EQ(scene.colliders[0].until_s, k_infinity);
  ASSERT_EQ(scene.grips[0].motion.size(), 2u);
  EXPECT_EQ(scene.grips[0].motion[1].position_m, (Vector3{0, 0, 0.3}));
  EXPECT_EQ(scene.emitters[0].velocity_m_per_s, (Vector3{0, 0, -0.5}));
}

TEST(SceneReader, EffectsStandInTheOrderInWhichTheyAct) {
  const Scene scene = parse(k_full);
  EXPECT_EQ(scene.effects, (Names{"motion", "heat", "water", "elasticity", "plasticity", "leavening"}));
  EXPECT_TRUE(scene.lists("heat"));
  EXPECT_FALSE(parse(k_least).lists("heat"));
}

TEST(SceneReader, ALowerQualityCoarsensTheGrid) {
  EXPECT_EQ(parse_scene(k_least, "a.toml", {Quality::draft, {}}).dx(), 0.04);
  EXPECT_EQ(parse_scene(k_least, "a.toml").dx(), 0.01);
}

TEST(SceneReader, KeysOfEffectsThatAreOffAreReadAndNotRequired) {
  const std::string with_material = "effects = [\"motion\"]\n" + k_least + "[[material]]\nname = \"a\"\ndensity_kg_per_m3 = 500\n";
  EXPECT_EQ(of<Elasticity>(parse(with_material).materials[0]).young_modulus_Pa, 0);
  EXPECT_EQ(of<Elasticity>(parse(with_material + "young_modulus_Pa = 7\n").materials[0]).young_modulus_Pa, 7);
  EXPECT_EQ(error_of(with_material + "young_modulus_Pa = -5\n"),
            "bread.toml:13: material.a.young_modulus_Pa: found -5, allowed: a number above 0");
}

TEST(SceneReader, PathsStartAtTheFolderOfTheScene) {
  const std::string text =
      k_least + "[[material]]\nname = \"a\"\ndensity_kg_per_m3 = 500\n[[body]]\nmaterial = \"a\"\nparticles_file = \"p.h5\"\n";
  EXPECT_EQ(parse_scene(text, "kitchen/bread.toml").bodies[0].particles_file, "kitchen/p.h5");
}

TEST(SceneReader, NoKeyOfAMaterialBelongsToTwoEffects) {
  Names keys = keys_of<Material>();
  for_each_effect([&]<class Effect>() {
    for (const std::string& key : keys_of<typename Effect::Material>()) keys.push_back(key);
  });
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST(SceneReader, NoEffectIsCalledLikeATable) {
  Names names = effect_names();
  for (const std::string& table : table_names()) names.push_back(table);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(SceneFile, IsReadFromDisk) {
  const TemporaryFolder folder;
  std::ofstream(folder / "bread.toml") << k_full;
  const Scene scene = read_scene(folder / "bread.toml");
  EXPECT_EQ(scene.bodies[1].particles_file, folder / "chips/all.h5");
}

TEST(SceneFile, ThatIsMissingOrAFolderIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path missing = folder / "cake.toml";
  EXPECT_EQ(message_of<InputError>([&] { read_scene(missing); }), missing.string() + ": no such file");
  EXPECT_EQ(message_of<InputError>([&] { read_scene(folder.path()); }), folder.path().string() + ": found a folder, allowed: a TOML file");
}

}  // namespace
}  // namespace bake::test

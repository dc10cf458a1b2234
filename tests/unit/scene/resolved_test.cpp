// SPDX-License-Identifier: MIT
#include "solver/scene/resolved.h"

#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

/// A scene file that says everything that `scene` resolved to.
std::string written_out(const Scene& scene) {
  nlohmann::json values = resolved(scene);
  values.erase("file");
  values.erase("quality");
  std::string text;
  for (const auto& [key, value] : values.items()) text += key + " = " + toml_text(value) + "\n";
  return text;
}

TEST(ResolvedScene, HoldsDefaultsToo) {
  const nlohmann::json values = resolved(parse(k_full));
  EXPECT_EQ(values["run"]["end_s"], 3.0);
  EXPECT_EQ(values["run"]["seed"], 1);
  EXPECT_EQ(values["grid"]["kernel"], "cubic");
  EXPECT_EQ(values["quality"], "paper");
  EXPECT_EQ(values["leavening"]["reference_pressure_Pa"], 101325.0);
  EXPECT_EQ(values["material"][0]["leavener_mol_per_m3"], "inf");
  EXPECT_EQ(values["material"][0]["young_modulus_Pa"], 1e5);
  EXPECT_EQ(values["grip"][0]["from_s"], "-inf");
  EXPECT_TRUE(values["body"][0]["saturation"].is_null());
  EXPECT_EQ(values["oven"]["temperature_C"].dump(), "[[0.0,20.0],[60.0,200.0]]");
  EXPECT_EQ(values["body"][0]["shape"]["difference"].size(), 2u);
}

TEST(ResolvedScene, WrittenOutAndReadAgainIsTheSame) {
  const Scene scene = parse(k_full);
  const Scene again = parse(written_out(scene));
  EXPECT_EQ(resolved(again), resolved(scene));
  EXPECT_EQ(scene_fingerprint(again), scene_fingerprint(scene));
  EXPECT_EQ(resolved(parse(written_out(parse(k_least)))), resolved(parse(k_least)));
}

TEST(ResolvedScene, ShapesReadAgainAreTheSame) {
  const Scene scene = parse(k_full);
  const Scene again = parse(written_out(scene));
  for (int i = 0; i < 100; ++i) {
    const Point x = {0.01 * i - 0.5, 0.003 * i, 0.2 - 0.004 * i};
    EXPECT_EQ(again.bodies[0].shape->distance(x), scene.bodies[0].shape->distance(x));
  }
}

TEST(ResolvedScene, GivesPathsFromTheFolderOfTheScene) {
  EXPECT_EQ(resolved(parse_scene(k_full, "a/bread.toml"))["body"][1]["particles_file"], "chips/all.h5");
  EXPECT_EQ(resolved(parse_scene(k_full, "bread.toml"))["body"][1]["particles_file"], "chips/all.h5");
  EXPECT_EQ(resolved(parse_scene(k_full, "/a/bread.toml"))["body"][1]["particles_file"], "chips/all.h5");
}

TEST(ResolvedScene, CanBeDumpedWhateverTheFileIsCalled) { EXPECT_NO_THROW(resolved(parse_scene(k_least, "\xff.toml")).dump()); }

TEST(Fingerprint, IsTheSameForTheSamePhysics) {
  const std::string print = scene_fingerprint(parse(k_full));
  EXPECT_EQ(print.size(), 16u);
  EXPECT_EQ(scene_fingerprint(parse_scene(k_full, "elsewhere/cake.toml")), print);
  EXPECT_EQ(scene_fingerprint(parse(k_full, {"run.end_s=90", "run.checkpoint_every_frames=7"})), print);
  EXPECT_EQ(scene_fingerprint(parse(k_full, {"motion.inertia_scale=1.0"})), print);
}

TEST(Fingerprint, IsTheOneFromBeforeThereWasVapour) { EXPECT_EQ(scene_fingerprint(parse(k_full)), "8e28fa6195d565ac"); }

TEST(Fingerprint, IsAnotherForOtherPhysics) {
  const std::string print = scene_fingerprint(parse(k_full));
  EXPECT_NE(scene_fingerprint(parse_scene(k_full, "bread.toml", {Quality::draft, {}})), print);
  for (const char* change :
       {"run.frame_rate_per_s=24", "run.seed=2", "run.precision=single", "material.dough.young_modulus_Pa=100001", "body.0.shape.scale=2.5",
        "oven.temperature_C=[[0,20],[61,200]]", "effects=['motion']", "run.stress_in_frames=true", "motion.settle_damping_per_s=1",
        "material.dough.hygroscopic_water_kg_per_kg=0.06"}) {
    EXPECT_NE(scene_fingerprint(parse(k_full, {change})), print) << change;
  }
}

TEST(TomlText, WritesEveryKindOfValue) {
  EXPECT_EQ(toml_text({{"a", 1}, {"b", nullptr}, {"c", {1.5, "inf", "-inf"}}, {"d", "x\"y"}, {"e", true}}),
            "{ a = 1, c = [1.5, inf, -inf], d = \"x\\\"y\", e = true }");
  EXPECT_EQ(toml_text(nlohmann::json::object()), "{}");
}

}  // namespace
}  // namespace bake::test

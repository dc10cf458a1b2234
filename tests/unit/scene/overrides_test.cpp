// SPDX-License-Identifier: MIT
#include "solver/effects/heat.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

TEST(Override, ReplacesAnyKey) {
  const Scene scene = parse(k_full, {"run.end_s=9", "oven.temperature_C=[[0,20],[10,40]]", "heat.integrator=forward_euler",
                                     "title=another one", "body.0.temperature_C=7", "material.chip.density_kg_per_m3=1250",
                                     "material.0.density_kg_per_m3=640", "grip.hand.motion.1.time_s=2", "domain.max_m.2=3",
                                     "emitter.jug.shape.union.0.sphere.radius_m=0.5", "effects=['motion', 'heat']"});
  EXPECT_EQ(scene.run.end_s, 9);
  EXPECT_DOUBLE_EQ(scene.oven.temperature_C(5), 30);
  EXPECT_EQ(scene.of<Heat>().integrator, Heat::Integrator::forward_euler);
  EXPECT_EQ(scene.title, "another one");
  EXPECT_EQ(scene.bodies[0].temperature_C, 7);
  EXPECT_EQ(scene.materials[1].density_kg_per_m3, 1250);
  EXPECT_EQ(scene.materials[0].density_kg_per_m3, 640);
  EXPECT_EQ(scene.grips[0].motion[1].time_s, 2);
  EXPECT_EQ(scene.domain.max_m, (Vector3{1, 1, 3}));
  EXPECT_LT(scene.emitters[0].shape->distance({0.3, 0, 0}), 0);
  EXPECT_EQ(scene.effects.size(), 2u);
}

TEST(Override, AddsKeysAndTablesThatAreNotThere) {
  const Scene scene = parse(k_least, {"oven.heat_transfer_coefficient_W_per_m2K=3", "run.seed=5"});
  EXPECT_EQ(scene.oven.heat_transfer_coefficient_W_per_m2K(0), 3);
  EXPECT_EQ(scene.run.seed, 5);
}

TEST(Override, TheLastOneWins) { EXPECT_EQ(parse(k_least, {"run.end_s=3", "run.end_s=4"}).run.end_s, 4); }

TEST(Override, ErrorsNameTheOverrideInsteadOfTheLine) {
  EXPECT_EQ(error_of(k_least, {"run.end_s=-5"}), "override 'run.end_s=-5': run.end_s: found -5, allowed: a number above 0");
  EXPECT_EQ(error_of(k_least, {"run.end_s=2s"}), "override 'run.end_s=2s': run.end_s: found \"2s\", allowed: a number above 0");
  EXPECT_EQ(error_of(k_least, {"run.end_s="}), "override 'run.end_s=': run.end_s: found \"\", allowed: a number above 0");
  EXPECT_EQ(error_of(k_least, {"oven.temperature_C=[[0,20],[0,30]]"}),
            "override 'oven.temperature_C=[[0,20],[0,30]]': oven.temperature_C.1: found time 0 after time 0, allowed: rising times");
  EXPECT_EQ(error_of(k_least, {"domain.max_m=[1,1,-1]"}),
            "override 'domain.max_m=[1,1,-1]': domain.max_m: found z = -1, allowed: a number above 0 (min_m)");
}

TEST(Override, UnknownKeysComeWithTheNearestOne) {
  EXPECT_EQ(error_of(k_least, {"run.ends=3"}), "override 'run.ends=3': run: unknown key 'ends', did you mean 'end_s'?");
  EXPECT_EQ(error_of(k_least, {"rum.end_s=3"}), "override 'rum.end_s=3': unknown key 'rum', did you mean 'run'?");
}

TEST(Override, MistakesElsewhereKeepTheirLine) {
  EXPECT_EQ(error_of(replaced(k_least, "0.01", "-1"), {"run.end_s=5"}), "bread.toml:4: grid.dx_m: found -1, allowed: a number above 0");
}

TEST(Override, MembersOfListsMustBeThere) {
  EXPECT_EQ(error_of(k_full, {"body.3.jitter=0"}), "override 'body.3.jitter=0': there is no '3', allowed: an index from 0 to 1 or a name");
  EXPECT_EQ(error_of(k_full, {"material.cake.density_kg_per_m3=1"}),
            "override 'material.cake.density_kg_per_m3=1': there is no 'cake', allowed: an index from 0 to 1 or a name");
  EXPECT_EQ(error_of(k_least, {"body.0.jitter=0"}), "override 'body.0.jitter=0': body: found a table, allowed: tables under [[body]]");
}

TEST(Override, MustBeKeyAndValue) {
  EXPECT_EQ(error_of(k_least, {"run.end_s"}), "override 'run.end_s': found no '=', allowed: key=value");
  EXPECT_EQ(error_of(k_least, {"=3"}), "override '=3': found an empty name, allowed: key=value with a dotted key");
  EXPECT_EQ(error_of(k_least, {"run..end_s=3"}), "override 'run..end_s=3': found an empty name, allowed: key=value with a dotted key");
  EXPECT_EQ(error_of(k_least, {"effects=[motion]"}), "override 'effects=[motion]': found '[motion]', allowed: a TOML value or one word");
  EXPECT_EQ(error_of(k_least, {"run.end_s=1\nseed=2"}),
            "override 'run.end_s=1?seed=2': found '1?seed=2', allowed: a TOML value or one word");
  EXPECT_EQ(error_of(k_least, {"run.end_s.x=3"}),
            "override 'run.end_s.x=3': 'x' is part of a single value, allowed: the key of that value");
}

}  // namespace
}  // namespace bake::test

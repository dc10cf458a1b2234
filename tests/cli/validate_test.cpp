// SPDX-License-Identifier: MIT
// `bake validate`, `bake info` and `bake run` have one answer to a scene that cannot be run.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

std::string set(const std::string& override) { return " --set '" + override + "'"; }

const std::string k_ball_and_crumb = "{ union = [{ sphere = { centre_m = [0.1, 0.1, 0.1], radius_m = 0.04 } }, ";

/// All three refuse the scene in the same words, before anything is written.
void expect_refused(const std::string& options, const std::string& reason, const std::string& before = "") {
  const Workplace place;
  const std::string said = expect_refused(place, "run dough" + options, reason, before);
  EXPECT_EQ(expect_refused(place, "info dough" + options, reason, before), said);
  EXPECT_EQ(expect_refused(place, "validate dough" + options, reason, before), said);
}

TEST(Validate, RefusesEffectsThatNoModelHas) {
  expect_refused(set("effects=[\"motion\"]"), "bake: override 'effects=[\"motion\"]': effects: found motion, allowed: heat, ");
  expect_refused(set("effects=[\"motion\", \"elasticity\", \"heat\"]") + set("motion.transfer=flip") +
                     set("material.dough.specific_heat_J_per_kgK=1") + set("material.dough.conductivity_W_per_mK=1"),
                 "with transfer = \"flip\", allowed: heat, ");
}

TEST(Validate, RefusesABodyWithoutParticles) {
  expect_refused(set("grid.dx_m=1"),
                 "/dough.toml:21: body.0: found no particle in its shape at dx = 4 m, allowed: a shape of some cells' size");
  expect_refused(set("body.0.shape={sphere={centre_m=[0.1,0.1,0.1],radius_m=0.001}}"), "body.0: found no particle");
  expect_refused(set("body.0.shape={sphere={centre_m=[0.1,0.1,0.1],radius_m=0.001}}") + set("body.0.filling=poisson"),
                 "body.0: found no particle");
  expect_refused(set("body.0.shape={difference=[{sphere={radius_m=0.1}},{sphere={radius_m=0.2}}]}"), "body.0: found no particle");
}

TEST(Validate, RefusesABodyThatReachesOutOfTheDomain) {
  expect_refused(set("body.0.shape={sphere={centre_m=[0.1,0.1,0.18],radius_m=0.06}}"), "body.0: found a particle at (");
  expect_refused(set("body.0.shape={sphere={centre_m=[5,0.1,0.1],radius_m=0.06}}"), "outside the domain");
  expect_refused(set("body.0.shape=" + k_ball_and_crumb + "{ sphere = { centre_m = [0.3, 0.1, 0.1], radius_m = 0.03 } }] }"),
                 "body.0: found a particle at (0.");
}

TEST(Validate, SaysWhereItFoundWhatOnlyTheWholeSceneShows) {
  expect_refused(set("run.end_s=1e9"), "bake: override 'run.end_s=1e9': run.end_s: found 1e+09 s, that is 2e+11 frames");
  expect_refused(set("body.0={material=\"dough\", particles_file=\"grains.h5\"}"), ": body.0.particles_file: ");
}

TEST(Validate, RefusesAnEmitterForTheSameReasons) {
  const auto emitter = [](const std::string& shape) {
    return set("emitter=[{name=\"jug\",material=\"dough\",velocity_m_per_s=[0,0,-1],shape=" + shape + "}]");
  };
  expect_refused(emitter("{sphere={centre_m=[0.1,0.1,0.1],radius_m=0.0001}}"), "emitter.jug: found no particle");
  expect_refused(emitter("{sphere={centre_m=[0.1,0.1,0.2],radius_m=0.05}}"), "emitter.jug: found a particle at (");
}

TEST(Validate, RefusesAFileOfParticlesThatCannotBeUsed) {
  expect_refused(set("body.0={material=\"dough\", particles_file=\"grains.h5\"}"), "grains.h5: cannot open");
  const std::string ring = BAKE_SOURCE_DIR "/experiments/features/ring.h5";
  const std::string from_file = set("body.0={material=\"dough\", particles_file=\"" + ring + "\"}");
  expect_refused(from_file, "ring.h5: material: found 1, allowed: 0 to 0");
  const std::string stuff = "\", density_kg_per_m3=1000, young_modulus_Pa=1e4}";
  expect_refused(from_file + set("material=[{name=\"dough" + stuff + ", {name=\"other" + stuff + "]"), "body.0: found a particle at (-");
}

TEST(Validate, RefusesWhatDoesNotFitIntoMemory) {
  expect_refused(set("grid.dx_m=1e-7"), "/dough.toml:11: domain: found about ");
  expect_refused(set("domain.max_m=[1e4,1e4,1e4]") + set("body.0.shape={sphere={centre_m=[5e3,5e3,5e3],radius_m=4e3}}"), "domain: found");
  expect_refused(set("body.0.shape={sphere={centre_m=[0.1,0.1,0.1],radius_m=1e9}}"),
                 "body.0: found about 3.9e+32 particles, which take about 3.9e+25 s a step (at least ");
  expect_refused(set("body.0.shape=" + k_ball_and_crumb + "{ sphere = { centre_m = [1e4, 1e4, 1e4], radius_m = 0.001 } }] }"),
                 "found bounds with room for about ");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which take all addresses for themselves
TEST(Validate, RefusesWhatDoesNotFitIntoTheMemoryThatItMayHave) {
  expect_refused(set("grid.dx_m=1e-5"), "domain: found about ", "ulimit -v 1000000;");
  expect_refused(set("grid.dx_m=2e-4"), "allowed: up to 1.02 GB of memory", "ulimit -v 1000000;");
}

TEST(Info, TellsOfDraftWherePaperDoesNotFitIntoMemory) {
  const Workplace place;
  const Outcome info = place.bake("info dough --threads 1" + set("grid.dx_m=0.0012"), "ulimit -v 300000;");
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_NE(info.out.find("\n  draft        dx 0.0048 m, "), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("\n  paper        cannot be run: "), std::string::npos) << info.out;
}
#endif

TEST(Validate, TakesABodyThatFillsTheDomainToItsFaces) {
  const Workplace place;
  const std::string full = set("body.0.shape={box={centre_m=[0.1,0.1,0.1],half_extents_m=[0.1,0.1,0.1]}}") + " --quality standard";
  EXPECT_EQ(place.bake("validate dough" + full).exit_code, 0);
  EXPECT_EQ(place.bake("run dough --quiet --frames 1" + full).exit_code, 0);
}

TEST(Validate, AnswersForTheQualityThatIsAsked) {
  const Workplace place;
  const std::string thin = " dough" + set("body.0.shape={sphere={centre_m=[0.1,0.1,0.1],radius_m=0.008}}");
  EXPECT_EQ(place.bake("validate" + thin).exit_code, 2);
  EXPECT_EQ(place.bake("validate" + thin + " --quality paper").exit_code, 0);
  const Outcome info = place.bake("info" + thin + " --quality paper");
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_NE(info.out.find("\n  draft        cannot be run: "), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("\n  paper        dx 0.01 m, "), std::string::npos) << info.out;
}

TEST(CompareTextbook, RefusesWhatARunRefuses) {
  const Workplace place;
  for (const auto& [options, reason] : {std::pair{set("effects=[\"motion\"]"), "': effects: found motion, "},
                                        std::pair{set("grid.dx_m=1"), "dough.toml:21: body.0: found no particle"},
                                        std::pair{set("domain.max_m=[1e6,1e6,1e6]"), "dough.toml:11: domain: found about "}})
    expect_refused(place, "compare-textbook dough" + options, reason);
}

}  // namespace
}  // namespace bake::test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

TEST(CommandLine, WrongCommandsAreRefused) {
  const Workplace place;
  expect_refused(place, "", "no command");
  expect_refused(place, "rum dough", "did you mean 'run'?");
  expect_refused(place, "--bogus", "subcommand is required");
  expect_refused(place, "list extra", "extra");
  expect_refused(place, "run", "scene");
  expect_refused(place, "run dough more", "more");
  expect_refused(place, "study", "study is required");
  expect_refused(place, "study orders", "orders not in");
  expect_refused(place, "study convergence --case slap", "allowed: slab_cosine, ");
  expect_refused(place, "study surface --case slab_cosine", "allowed: with convergence, accuracy");
  expect_refused(place, "study surface --full", "--full: found with the study \"surface\", allowed: with accuracy");
  expect_refused(place, "study surface --measure-only", "--measure-only: found with the study \"surface\", allowed: with accuracy");
  expect_refused(place, "study accuracy --quick --full", "--quick excludes --full");
  expect_refused(place, "study accuracy --case slap", "allowed: heated_slab, ");
  expect_refused(place, "study accuracy --reference elastic_bar", "allowed: a case without an exact solution");
}

#ifndef __clang__  // whose OpenMP library has other words for it
TEST(CommandLine, WaitingThreadsSleepSoonUnlessTheUserSaysOtherwise) {
  const Workplace place;
  const auto spins = [&](const std::string& environment) {
    const std::string shown =
        place.bake("--version", "env -u GOMP_SPINCOUNT -u OMP_WAIT_POLICY OMP_DISPLAY_ENV=verbose " + environment).err;
    const std::size_t last = shown.rfind("GOMP_SPINCOUNT = '");
    EXPECT_NE(last, std::string::npos) << shown;
    return shown.substr(last + 18, shown.find('\'', last + 18) - last - 18);
  };
  EXPECT_EQ(spins(""), "3000");
  EXPECT_EQ(spins("GOMP_SPINCOUNT=70"), "70");
  EXPECT_NE(spins("OMP_WAIT_POLICY=active"), "3000");
}
#endif

TEST(CommandLine, WhatCannotBeToldStillEndsWithItsExitCode) {
  const Workplace place;
  for (const char* lost : {"2>&-", "2>/dev/full", "2>&- >&- <&-"})
    EXPECT_EQ(place.bake(std::string("run nowhere ") + lost).exit_code, 2) << lost;
}

TEST(CommandLine, UnknownScenesAreRefusedWithTheNearestName) {
  const Workplace place;
  for (const std::string command : {"run", "info", "validate"}) {
    expect_refused(place, command + " duogh", "did you mean 'dough'?");
    expect_refused(place, command + " nowhere.toml", "nowhere.toml");
  }
}

TEST(CommandLine, ANameThatTwoExperimentsHaveMustSayWhichOne) {
  const Workplace place;
  std::filesystem::copy(place.folder() / "experiments/fig01_dough", place.folder() / "experiments/fig02_dough");
  expect_refused(place, "validate dough", "ambiguous");
  expect_success(place, "validate fig02_dough/dough", "fig02_dough/dough.toml: valid");
}

TEST(CommandLine, ASceneHereHidesThatOfTheSourcesItWasBuiltFrom) {
  const Workplace place;
  place.write("experiments/fig15_bread/bread.toml", contents(place.folder() / "experiments/fig01_dough/dough.toml"));
  expect_success(place, "validate bread", place.folder().filename().string() + "/experiments/fig15_bread/bread.toml: valid");
}

TEST(CommandLine, WrongOptionsAreRefused) {
  const Workplace place;
  expect_refused(place, "run dough --bogus", "--bogus");
  expect_refused(place, "run dough --threads 0", "--threads");
  expect_refused(place, "run dough --threads -2", "--threads");
  expect_refused(place, "run dough --threads many", "--threads");
  expect_refused(place, "run dough --threads 1.5", "--threads");
  expect_refused(place, "run dough --threads", "--threads");
  expect_refused(place, "run dough --threads 1 --threads 2", "--threads");
  expect_refused(place, "run dough --frames 0", "--frames: found 0, allowed: a whole number from 1 to 1000000000");
  expect_refused(place, "run dough --frames 1.5", "--frames");
  expect_refused(place, "run dough --frames 3 --end 1", "excludes");
  expect_refused(place, "run dough --end 0", "--end");
  expect_refused(place, "run dough --end nan", "--end");
  expect_refused(place, "run dough --end inf", "--end");
  expect_refused(place, "run dough --end soon", "--end");
  expect_refused(place, "run dough --quality best", "draft,standard,paper");
  expect_refused(place, "info dough --quality best", "draft,standard,paper");
  expect_refused(place, "run dough --precision half", "single,double");
  expect_refused(place, "run dough --set", "--set");
}

TEST(CommandLine, WrongOverridesAreRefused) {
  const Workplace place;
  expect_refused(place, "run dough --set run.end_s", "run.end_s");
  expect_refused(place, "run dough --set run.end_s=-1", "run.end_s");
  expect_refused(place, "run dough --set run.ends_s=1", "did you mean 'end_s'?");
  expect_refused(place, "run dough --set material.sand.density_kg_per_m3=1", "sand");
}

TEST(CommandLine, WrongScenesAreRefusedWithFileAndLine) {
  const Workplace place;
  place.write("broken.toml", "title = \"no end\n");
  expect_refused(place, "validate broken.toml", "broken.toml:1");
  expect_refused(place, "run broken.toml", "broken.toml:1");
  place.write("empty.toml", "");
  expect_refused(place, "validate empty.toml", "empty.toml");
  std::filesystem::create_directory(place.folder() / "folder.toml");
  expect_refused(place, "validate folder.toml", "folder.toml");
}

TEST(CommandLine, UnknownKeysAreNotExplained) {
  const Workplace place;
  expect_refused(place, "explain run.ends_s", "run.end_s");
  expect_refused(place, "explain heat_contents_J", "did you mean 'heat_content_J'?");
  expect_refused(place, "explain plastic_volume", "did you mean 'plastic_volume_ratio'?");
}

TEST(CommandLine, KeysAndColumnsOfOneNameAreBothExplained) {
  const Workplace place;
  expect_success(place, "explain heat_content_J", "a column of ledger.csv");
  expect_success(place, "explain saturation", "a column of frames");
  expect_success(place, "explain saturation", "body.saturation");
  expect_success(place, "explain twist_x_kg_m2_per_s", "angular_impulse_x_kg_m2_per_s, a column of ledger.csv");
}

TEST(CommandLine, ScenesAreFoundByNameFromAnyFolderBelow) {
  const Workplace place;
  expect_success(place, "validate dough", "dough.toml: valid");
  std::filesystem::create_directories(place.folder() / "experiments/notes/deep");
  const std::string below = (place.folder() / "experiments/notes/deep").string();
  const Outcome outcome = place.bake("version && cd '" + below + "' && '" BAKE_PROGRAM "' validate dough");
  EXPECT_EQ(outcome.exit_code, 0);
}

TEST(CommandLine, QuestionsAreAnswered) {
  const Workplace place;
  expect_success(place, "list", "Dough at rest");
  expect_success(place, "info dough", "\n  body.0       dough: 1 kg, 0.001 m^3, 0 kg of it water, 125 particles\n");
  expect_success(place, "explain run.end_s", "end_s");
  expect_success(place, "explain", "density_kg_per_m3");
  expect_success(place, "version", "bake ");
  expect_success(place, "--version", "bake ");
  expect_success(place, "--help", "validate");
  expect_success(place, "run --help", "--resume");
}

TEST(CommandLine, InfoWarnsOfAnEffectThatAMaterialNamesAndTheSceneDoesNotList) {
  const Workplace place;
  const auto warnings = [&](const std::string& scene) {
    return place.bake("info --quality paper " + scene).out.find("\n  warning      ") != std::string::npos;
  };
  EXPECT_FALSE(warnings("dough"));
  std::string text = contents(place.folder() / "experiments/fig01_dough/dough.toml");
  const std::string key = "poisson_ratio = 0.3\n";
  place.write("warm.toml", text.replace(text.find(key), key.size(), "conductivity_W_per_mK = 1\n"));
  EXPECT_TRUE(warnings("warm.toml"));
  expect_success(place, "info warm.toml", "material.dough.conductivity_W_per_mK is given, but effects does not list heat");
}

TEST(CommandLine, AKeyUnderItsFormerNameGetsOneLineOfNoticeUnlessQuiet) {
  const Workplace place;
  place.write("old.toml", contents(place.folder() / "experiments/fig01_dough/dough.toml") + "spin_rad_per_s = [0, 0, 1]\n");
  const std::string file = contents(place.folder() / "old.toml");
  const auto line = std::count(file.begin(), file.end(), '\n');
  const std::string notice = "bake: old.toml:" + std::to_string(line) +
                             ": body.0.spin_rad_per_s is now called angular_velocity_rad_per_s; the old name is read until 1.0\n";
  for (const std::string command : {"validate", "info"}) EXPECT_EQ(place.bake(command + " old.toml").err, notice) << command;
  EXPECT_EQ(place.bake("run old.toml --frames 1").err.rfind(notice, 0), 0u);
  EXPECT_EQ(place.bake("run old.toml --frames 1 --quiet").err, "");
}

TEST(CommandLine, AnInvalidSceneIsListedAsSuch) {
  const Workplace place;
  place.write("experiments/fig02_bad/bad.toml", "title = 3\n");
  expect_success(place, "list", "not a valid scene");
}

TEST(CommandLine, ARunLeavesItsResultsWhereItSays) {
  const Workplace place;
  EXPECT_EQ(place.bake("run dough").exit_code, 0);
  const auto holds_results = [&](const std::string& folder) {
    for (const char* file : {"run.json", "ledger.csv", "checkpoint.h5", "frames.hdf.series", "frames/0000.hdf", "frames/0001.hdf"})
      EXPECT_TRUE(std::filesystem::is_regular_file(place.folder() / folder / file)) << file;
  };
  holds_results("results/dough-draft");
  expect_success(place, "run dough --quiet --quality draft --out 'my bread' --frames 1 --threads 1 --precision double", "");
  holds_results("my bread");
}

TEST(CommandLine, AQuietRunPrintsNothing) {
  const Workplace place;
  const Outcome outcome = place.bake("run dough --quiet --set run.end_s=0.005");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(CommandLine, WhatCannotBePrintedIsNoSuccess) {
  const Workplace place;
  for (const char* to : {" >/dev/full", " >&-"})
    for (const char* command : {"list", "--version", "run --help", "explain run.end_s"})
      expect_refused(place, std::string(command) + to, "cannot write to the standard output", "", 3);
  EXPECT_EQ(place.bake("run dough --quiet --out a >&-").exit_code, 0) << "which prints nothing";
}

TEST(Readme, ItsExampleIsAValidScene) {
  const Workplace place;
  const std::string readme = contents(std::filesystem::path(BAKE_SOURCE_DIR) / "README.md");
  const std::string opening = "```toml\n";
  const auto begin = readme.find(opening);
  ASSERT_NE(begin, std::string::npos);
  const auto first = begin + opening.size();
  place.write("ball.toml", readme.substr(first, readme.find("```", first) - first));
  expect_success(place, "validate ball.toml", "ball.toml: valid");
}

}  // namespace
}  // namespace bake::test

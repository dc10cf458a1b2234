// SPDX-License-Identifier: MIT
// Whole runs: what is left when something goes wrong, and going on afterwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_long = "run dough --quiet --threads 1 --set run.end_s=0.5 --set time.largest_step_s=1e-4";

void expect_one_line(const Outcome& outcome, int exit_code, const std::string& reason) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("bake: ", 0), 0u) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
}

bool half_written_files(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".part") return true;
  return false;
}

TEST(Run, InterruptedAndResumedGivesTheSameBitsAsNeverStopped) {
  const Workplace place;
  ASSERT_EQ(place.bake(std::string(k_long) + " --out whole").exit_code, 0);
  // as soon as the fourth line of the ledger is there, that is in the middle of a frame
  const std::string until_under_way =
      " & run=$!; while [ \"$(cat parts/ledger.csv 2>/dev/null | wc -l)\" -lt 4 ]; do sleep 0.01; done; kill -TERM $run; wait $run";
  const Outcome stopped = place.bake(std::string(k_long) + " --out parts" + until_under_way);
  ASSERT_EQ(stopped.exit_code, 3) << "the run was over before the signal: make it longer";
  EXPECT_TRUE(fs::exists(place.folder() / "parts/checkpoint.h5"));
  // as if the first part had taken an hour
  nlohmann::json run = nlohmann::json::parse(contents(place.folder() / "parts/run.json"));
  EXPECT_GT(run["summary"]["wall_s"], 0);
  run["summary"]["wall_s"] = 3600;
  place.write("parts/run.json", run.dump());
  ASSERT_EQ(place.bake(std::string(k_long) + " --out parts --resume").exit_code, 0);
  EXPECT_EQ(contents(place.folder() / "whole/checkpoint.h5"), contents(place.folder() / "parts/checkpoint.h5"));
  EXPECT_EQ(contents(place.folder() / "whole/ledger.csv"), contents(place.folder() / "parts/ledger.csv"));
  EXPECT_GT(nlohmann::json::parse(contents(place.folder() / "parts/run.json"))["summary"]["wall_s"], 3600) << "of both parts";
}

TEST(Run, ThatCannotGoOnSaysWhyAndLeavesACheckpointOfItsLastFrame) {
  const Workplace place;
  const std::string falls_too_fast =
      "run dough --quiet --set run.end_s=0.2 --set run.checkpoint_every_frames=1 --set motion.gravity_m_per_s2=[0,0,-200] "
      "--set time.smallest_step_s=2.6e-3 --out a";
  const Outcome first = place.bake(falls_too_fast);
  expect_one_line(first, 3, "time.smallest_step_s");
  EXPECT_FALSE(half_written_files(place.folder() / "a"));
  EXPECT_NE(contents(place.folder() / "a/run.json").find(R"("state": "failed")"), std::string::npos);
  // it can be gone on with, and ends in the same step for the same reason
  const Outcome again = place.bake(falls_too_fast + " --resume");
  expect_one_line(again, 3, "time.smallest_step_s");
  EXPECT_EQ(again.err, first.err);
}

TEST(Run, ResumingNeedsACheckpoint) {
  const Workplace place;
  expect_one_line(place.bake("run dough --resume --out nothing"), 2, "checkpoint");
}

TEST(Run, ACheckpointOfAnotherSceneIsRefused) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --out a").exit_code, 0);
  expect_one_line(place.bake("run dough --resume --out a --set material.dough.density_kg_per_m3=900"), 2, "checkpoint");
  expect_one_line(place.bake("run dough --resume --out a --precision double"), 2, "checkpoint");
}

TEST(Run, ATruncatedCheckpointIsRefused) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --out a").exit_code, 0);
  const fs::path file = place.folder() / "a/checkpoint.h5";
  fs::resize_file(file, fs::file_size(file) / 2);
  expect_one_line(place.bake("run dough --resume --out a"), 2, "checkpoint.h5");
}

TEST(Run, AFolderThatCannotBeWrittenIsRefused) {
  const Workplace place;
  place.write("taken", "a file, not a folder");
  expect_one_line(place.bake("run dough --out taken/results"), 2, "taken");
}

TEST(Run, AFullDiskLeavesNothingHalfWritten) {
  const Workplace place;
  // the kernel refuses to let files grow beyond 4 kB, as a full disk would; the signal that comes with it is ignored
  expect_one_line(place.bake("run dough --quiet --out a", "trap '' XFSZ; ulimit -f 4;"), 2, "a/");
  EXPECT_FALSE(half_written_files(place.folder() / "a"));
}

TEST(Run, AMissingOrBrokenParticlesFileIsRefused) {
  const Workplace place;
  const std::string body = "run dough --set \"body.0={material='dough', particles_file='grains.h5'}\"";
  expect_one_line(place.bake(body), 2, "grains.h5");
  place.write("experiments/fig01_dough/grains.h5", "this is no HDF5 file");
  expect_one_line(place.bake(body), 2, "grains.h5");
}

TEST(Run, ASceneWhoseEffectsHaveNoModelSaysWhichOnesThereAre) {
  const Workplace place;
  expect_one_line(place.bake("run dough --set 'effects=[\"motion\"]'"), 2, "motion+elasticity");
}

TEST(Run, AnEmptySceneEndsAtOnce) {
  const Workplace place;
  place.write("empty.toml", R"(effects = ["motion", "elasticity"]
[run]
end_s = 0.1
[grid]
dx_m = 0.01
[domain]
min_m = [0, 0, 0]
max_m = [0.2, 0.2, 0.2]
)");
  EXPECT_EQ(place.bake("run empty.toml --quiet").exit_code, 0);
}

}  // namespace
}  // namespace bake::test

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
  const std::string first = expect_refused(place, falls_too_fast, "time.smallest_step_s", "", 3);
  EXPECT_FALSE(half_written_files(place.folder() / "a"));
  EXPECT_NE(contents(place.folder() / "a/run.json").find(R"("state": "failed")"), std::string::npos);
  const std::string ledger = contents(place.folder() / "a/ledger.csv");
  const nlohmann::json series = nlohmann::json::parse(contents(place.folder() / "a/frames.hdf.series"));
  ASSERT_GT(series["files"].size(), 1u);
  EXPECT_EQ(std::count(ledger.begin(), ledger.end(), '\n') - 1, static_cast<std::ptrdiff_t>(series["files"].size()));
  // it can be gone on with, and ends in the same step for the same reason
  EXPECT_EQ(expect_refused(place, falls_too_fast + " --resume", "time.smallest_step_s", "", 3), first);
}

TEST(Run, ResumingNeedsACheckpoint) {
  const Workplace place;
  expect_refused(place, "run dough --resume --out nothing", "checkpoint");
}

TEST(Run, ACheckpointOfAnotherSceneIsRefused) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --out a").exit_code, 0);
  expect_refused(place, "run dough --resume --out a --set material.dough.density_kg_per_m3=900", "checkpoint");
  expect_refused(place, "run dough --resume --out a --precision double", "checkpoint");
}

TEST(Run, ATruncatedCheckpointIsRefused) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --out a").exit_code, 0);
  const fs::path file = place.folder() / "a/checkpoint.h5";
  fs::resize_file(file, fs::file_size(file) / 2);
  expect_refused(place, "run dough --resume --out a", "checkpoint.h5");
}

TEST(Run, AFolderThatCannotBeWrittenIsRefused) {
  const Workplace place;
  place.write("taken", "a file, not a folder");
  expect_refused(place, "run dough --out taken/results", "taken");
}

TEST(Run, AFullDiskLeavesNothingHalfWritten) {
  const Workplace place;
  // the kernel refuses to let files grow beyond 4 kB, as a full disk would; the signal that comes with it is ignored
  expect_refused(place, "run dough --quiet --out a", "a/", "trap '' XFSZ; ulimit -f 4;");
  EXPECT_FALSE(half_written_files(place.folder() / "a"));
}

TEST(Run, StopsSoonAfterAFrameThatCannotBeWrittenNamesItAndCanBeGoneOnWith) {
  const Workplace place;
  const std::string ten_frames = "run dough --quiet --set run.end_s=0.05 --out ";
  ASSERT_EQ(place.bake(ten_frames + "whole").exit_code, 0);
  ASSERT_EQ(place.bake(ten_frames + "a --frames 2").exit_code, 0);
  fs::create_directory(place.folder() / "a/frames/0004.hdf.part");  // where the file would be written
  expect_refused(place, ten_frames + "a --resume", "frame 4: a/frames/0004.hdf: cannot create: Is a directory");
  EXPECT_TRUE(fs::exists(place.folder() / "a/frames/0003.hdf"));
  EXPECT_FALSE(fs::exists(place.folder() / "a/frames/0005.hdf"));
  const nlohmann::json series = nlohmann::json::parse(contents(place.folder() / "a/frames.hdf.series"));
  EXPECT_EQ(series["files"].size(), 4u);
  const std::string ledger = contents(place.folder() / "a/ledger.csv");
  EXPECT_EQ(std::count(ledger.begin(), ledger.end(), '\n'), 5) << "the heading and frames 0 to 3";

  fs::remove(place.folder() / "a/frames/0004.hdf.part");
  ASSERT_EQ(place.bake(ten_frames + "a --resume").exit_code, 0);
  for (const char* file : {"checkpoint.h5", "ledger.csv", "frames.hdf.series", "frames/0004.hdf", "frames/0010.hdf"})
    EXPECT_TRUE(contents(place.folder() / "whole" / file) == contents(place.folder() / "a" / file)) << file;
}

TEST(Run, AMissingOrBrokenParticlesFileIsRefused) {
  const Workplace place;
  const std::string body = "run dough --set \"body.0={material='dough', particles_file='grains.h5'}\"";
  expect_refused(place, body, "grains.h5");
  place.write("experiments/fig01_dough/grains.h5", "this is no HDF5 file");
  expect_refused(place, body, "grains.h5");
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

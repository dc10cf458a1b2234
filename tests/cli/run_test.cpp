// SPDX-License-Identifier: MIT
// Whole runs: what is left when something goes wrong, and going on afterwards.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

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

/// The first column of the ledger, which must be the times of frames.hdf.series, too.
std::vector<double> times_of(const Workplace& place, const std::string& folder) {
  std::vector<double> times, series;
  std::istringstream ledger(contents(place.folder() / folder / "ledger.csv"));
  std::string line;
  std::getline(ledger, line);
  while (std::getline(ledger, line)) times.push_back(std::stod(line));
  const nlohmann::json list = nlohmann::json::parse(contents(place.folder() / folder / "frames.hdf.series"));
  for (const auto& entry : list["files"]) series.push_back(entry["time"].get<double>());
  EXPECT_EQ(times, series);
  return times;
}

std::string state_of(const Workplace& place, const std::string& folder) {
  return nlohmann::json::parse(contents(place.folder() / folder / "run.json"))["summary"]["state"];
}

void expect_same_results(const Workplace& place, const std::string& a, const std::string& b, int frames) {
  for (const char* file : {"checkpoint.h5", "ledger.csv", "frames.hdf.series"})
    EXPECT_TRUE(contents(place.folder() / a / file) == contents(place.folder() / b / file)) << file;
  for (int f = 0; f <= frames; ++f) {
    const std::string file = fmt::format("frames/{:04}.hdf", f);
    ASSERT_TRUE(fs::exists(place.folder() / a / file)) << file;
    EXPECT_TRUE(contents(place.folder() / a / file) == contents(place.folder() / b / file)) << file;
  }
}

TEST(Run, ReadsNumbersInBaseTen) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --threads 01 --frames 010 --out ten").exit_code, 0);
  EXPECT_TRUE(fs::exists(place.folder() / "ten/frames/0010.hdf"));
  EXPECT_FALSE(fs::exists(place.folder() / "ten/frames/0011.hdf"));
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

TEST(Run, IsSavedHoweverItIsAskedToStop) {
  const Workplace place;
  const std::string under_way = " & run=$!; while [ \"$(cat out/ledger.csv 2>/dev/null | wc -l)\" -lt 4 ]; do sleep 0.01; done; ";
  for (const std::string signals :
       {"kill -TERM $run; kill -TERM $run", "kill -TERM $run; sleep 0.001; kill -TERM $run", "kill -HUP $run"}) {
    const Outcome stopped = place.bake(std::string(k_long) + " --out out" + under_way + signals + "; wait $run");
    EXPECT_EQ(stopped.exit_code, 3) << signals;
    EXPECT_TRUE(fs::exists(place.folder() / "out/checkpoint.h5")) << signals;
    EXPECT_EQ(state_of(place, "out"), "interrupted") << signals;
    fs::remove_all(place.folder() / "out");
  }
}

TEST(Run, IsSavedWhenNobodyReadsWhatItSays) {
  const Workplace place;
  place.bake("run dough --set run.end_s=0.2 --out out 2>&1 | true");  // whose exit code is that of the pipe
  EXPECT_TRUE(fs::exists(place.folder() / "out/checkpoint.h5"));
  EXPECT_FALSE(half_written_files(place.folder() / "out"));
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

TEST(Run, EndsAtItsEndWithALastFrameThere) {
  const Workplace place;  // 200 frames a second
  ASSERT_EQ(place.bake("run dough --quiet --end 0.0123 --out a").exit_code, 0);
  EXPECT_EQ(times_of(place, "a"), (std::vector<double>{0, 0.005, 0.01, 0.0123}));
  EXPECT_TRUE(fs::exists(place.folder() / "a/frames/0003.hdf"));
  EXPECT_FALSE(fs::exists(place.folder() / "a/frames/0004.hdf"));
  ASSERT_EQ(place.bake("run dough --quiet --end 0.0003 --out b").exit_code, 0);
  EXPECT_EQ(times_of(place, "b"), (std::vector<double>{0, 0.0003}));
}

TEST(Run, OfMoreFramesThanCanBeCountedIsRefused) {
  const Workplace place;
  expect_refused(place, "run dough --end 1e9", "run.end_s: found 1e+09 s, that is 2e+11 frames");
  expect_refused(place, "validate dough --set run.end_s=1e9", "run.end_s: found 1e+09 s, that is 2e+11 frames");
}

TEST(Run, ResumedGivesTheSameBitsAlsoIfItEndsBetweenTwoFrames) {
  const Workplace place;
  const std::string run = "run dough --quiet --set run.end_s=0.0212 --out ";
  ASSERT_EQ(place.bake(run + "whole").exit_code, 0);
  for (const std::string frames : {"3", "4"}) {  // the fourth is the last whole one: the end shortens the step behind it
    ASSERT_EQ(place.bake(run + "parts --overwrite --frames " + frames).exit_code, 0);
    ASSERT_EQ(place.bake(run + "parts --resume").exit_code, 0);
    expect_same_results(place, "whole", "parts", 5);
  }
}

TEST(Run, ResumedWithALaterEndGivesTheBitsOfARunToThatEndOrIsRefused) {
  const Workplace place;
  const std::string run = "run dough --quiet --out ";
  ASSERT_EQ(place.bake(run + "whole --end 0.03").exit_code, 0);
  ASSERT_EQ(place.bake(run + "parts --end 0.02").exit_code, 0);
  ASSERT_EQ(place.bake(run + "parts --end 0.03 --resume").exit_code, 0);
  expect_same_results(place, "whole", "parts", 6);
  ASSERT_EQ(place.bake(run + "between --end 0.0212").exit_code, 0);
  expect_refused(place, run + "between --end 0.03 --resume", "frame 6 is due at 0.0262 s");
  ASSERT_EQ(place.bake(run + "between --end 0.0212 --resume").exit_code, 0) << "it is done already";
  expect_refused(place, run + "parts --frames 3 --resume", "behind the end at frame 3");
}

TEST(Run, KeepsASecondOneOutOfItsFolder) {
  const Workplace place;
  const std::string meanwhile =
      " & run=$!; while [ \"$(cat a/ledger.csv 2>/dev/null | wc -l)\" -lt 3 ]; do sleep 0.01; done;"
      "flock -n a/.bake-run true && touch free; kill -TERM $run; wait $run";
  ASSERT_EQ(place.bake(std::string(k_long) + " --out a" + meanwhile).exit_code, 3) << "the run was over before the signal: make it longer";
  EXPECT_FALSE(fs::exists(place.folder() / "free"));
  const auto before = times_of(place, "a");
  const std::string held = "exec 9>>a/.bake-run; flock -n 9; echo 'process 4711' >a/.bake-run;";
  for (const char* how : {"", " --resume", " --overwrite"})
    expect_refused(place, std::string(k_long) + " --out a" + how, "a: a run of process 4711 writes here", held);
  EXPECT_EQ(times_of(place, "a"), before);
  EXPECT_EQ(place.bake("run dough --quiet --out a --overwrite").exit_code, 0) << "whose process has gone";
}

TEST(Run, TouchesNothingThatNoRunHasMade) {
  const Workplace place;
  place.write("a/frames/mine.txt", "a picture frame");
  expect_refused(place, "run dough --quiet --out a", "a/frames: is there already, and not from a run of Bake");
  expect_refused(place, "run dough --quiet --out a --overwrite", "a/frames: is there already");
  EXPECT_EQ(contents(place.folder() / "a/frames/mine.txt"), "a picture frame");
  EXPECT_FALSE(fs::exists(place.folder() / "a/.bake-run"));
  place.write("b/ledger.csv", "1,2\n");
  expect_refused(place, "run dough --quiet --out b", "b/ledger.csv: is there already");
  place.write("c/notes.txt", "mine");
  ASSERT_EQ(place.bake("run dough --quiet --frames 2 --out c").exit_code, 0);
  place.write("c/frames/mine.txt", "mine, too");
  ASSERT_EQ(place.bake("run dough --quiet --frames 1 --out c --overwrite").exit_code, 0);
  EXPECT_EQ(contents(place.folder() / "c/notes.txt"), "mine");
  EXPECT_EQ(contents(place.folder() / "c/frames/mine.txt"), "mine, too");
  EXPECT_FALSE(fs::exists(place.folder() / "c/frames/0002.hdf")) << "of the run before";
}

TEST(Run, ReplacesResultsOfSomethingElseOnlyIfAskedTo) {
  const Workplace place;
  place.write("other.toml", contents(place.folder() / "experiments/fig01_dough/dough.toml"));
  ASSERT_EQ(place.bake("run dough --quiet --out a").exit_code, 0);
  const std::string kept = contents(place.folder() / "a/checkpoint.h5");
  expect_refused(place, "run other.toml --quiet --out a --set grid.dx_m=0.02",
                 "a: here are the results of dough.toml (grid.dx_m: found 0.02");
  expect_refused(place, "run dough --quiet --out a --set grid.dx_m=0.02", "other values of the scene (grid.dx_m: found 0.02, there 0.01)");
  EXPECT_EQ(contents(place.folder() / "a/checkpoint.h5"), kept);
  expect_refused(place, "run dough --quiet --out a --frames 1", "other values of the scene (its end: found ");
  EXPECT_EQ(contents(place.folder() / "a/checkpoint.h5"), kept);
  EXPECT_EQ(place.bake("run dough --quiet --out a").exit_code, 0) << "the same scene";
  EXPECT_EQ(place.bake("run dough --quiet --out a --frames 1 --overwrite").exit_code, 0);
  EXPECT_EQ(place.bake("run dough --quiet --out a --set grid.dx_m=0.02 --overwrite").exit_code, 0);
  EXPECT_EQ(place.bake("run dough --quiet").exit_code, 0);
  EXPECT_EQ(place.bake("run dough --quiet --set grid.dx_m=0.02").exit_code, 0) << "the folder is named by the scene";
  expect_refused(place, "run dough --quiet --out ''", "--out: found an empty name");
}

TEST(Run, ThatIsToResumeBeginsWhereThereIsNoCheckpoint) {
  const Workplace place;
  const Outcome outcome = place.bake("run dough --resume --out a");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("bake: a: found no checkpoint, so the run begins at its start\n"), std::string::npos) << outcome.err;
  fs::remove(place.folder() / "a/checkpoint.h5");
  expect_refused(place, "run dough --resume --out a", "found a run that is done, and no checkpoint");
  EXPECT_TRUE(fs::exists(place.folder() / "a/frames/0002.hdf"));
}

TEST(Run, ResumesOnlyFromWholeResults) {
  const Workplace place;
  const std::string run = "run dough --quiet --set run.end_s=0.05 --out ";
  ASSERT_EQ(place.bake(run + "whole --frames 4").exit_code, 0);
  const std::string ledger = contents(place.folder() / "whole/ledger.csv");
  const auto refused = [&](const std::string& reason, const auto& damage) {
    fs::remove_all(place.folder() / "a");
    fs::copy(place.folder() / "whole", place.folder() / "a", fs::copy_options::recursive);
    damage();
    const std::string checkpoint = contents(place.folder() / "a/checkpoint.h5");
    expect_refused(place, run + "a --resume", reason);
    EXPECT_EQ(contents(place.folder() / "a/checkpoint.h5"), checkpoint);
  };
  const std::size_t heading = ledger.find('\n') + 1, second = ledger.find('\n', heading) + 1, third = ledger.find('\n', second) + 1;
  const auto with_ledger = [&](const std::string& text) { return [&, text] { place.write("a/ledger.csv", text); }; };
  refused("a/ledger.csv: found 0 rows", with_ledger(ledger.substr(0, heading)));
  refused("a/ledger.csv: found 2 rows", with_ledger(ledger.substr(0, third)));
  refused("a/ledger.csv:3: found the time 0.01 s, allowed: 0.005 s", with_ledger(ledger.substr(0, second) + ledger.substr(third)));
  refused("a/ledger.csv:3: found the time nan s", with_ledger(ledger.substr(0, second) + "nan" + ledger.substr(ledger.find(',', second))));
  const std::size_t last_comma = ledger.rfind(',', third - 2) + 1;
  refused("a/ledger.csv:3: found nan for ", with_ledger(ledger.substr(0, last_comma) + "nan" + ledger.substr(third - 1)));
  refused("a/ledger.csv", [&] { fs::remove(place.folder() / "a/ledger.csv"); });
  refused("a/frames/0002.hdf: is missing", [&] { fs::remove(place.folder() / "a/frames/0002.hdf"); });
  refused("a/frames/0002.hdf", [&] { fs::resize_file(place.folder() / "a/frames/0002.hdf", 100); });
  refused("a/frames/0003.hdf: found the time 0.01 s", [&] {
    fs::copy_file(place.folder() / "a/frames/0002.hdf", place.folder() / "a/frames/0003.hdf", fs::copy_options::overwrite_existing);
  });
}

TEST(Run, ThatIsResumedMakesAnewWhatStandsBehindTheCheckpoint) {
  const Workplace place;
  const std::string run = "run dough --quiet --set run.end_s=0.02 --out ";
  ASSERT_EQ(place.bake(run + "whole").exit_code, 0);
  ASSERT_EQ(place.bake(run + "a --frames 2").exit_code, 0);
  place.write("a/frames/0003.hdf", "half a frame");
  place.write("a/frames/0007.hdf", "of a run that was longer");
  place.write("a/run.json", "{\"summary\": {\"wall_s\": \"long\"}}");
  fs::remove(place.folder() / "a/frames.hdf.series");
  ASSERT_EQ(place.bake(run + "a --resume").exit_code, 0);
  expect_same_results(place, "whole", "a", 4);
  EXPECT_FALSE(fs::exists(place.folder() / "a/frames/0007.hdf"));
}

TEST(Run, NoticesThatItsFilesAreRemovedOrDamagedMeanwhile) {
  const Workplace place;
  const auto meanwhile = [](const std::string& folder, const std::string& done) {
    return fmt::format(
        "{} --out {} & run=$!; while [ \"$(cat {}/ledger.csv 2>/dev/null | wc -l)\" -lt 4 ]; do sleep 0.01; done; "
        "{}; wait $run",
        k_long, folder, folder, done);
  };
  expect_refused(place, meanwhile("a", "rm a/ledger.csv"), "a/ledger.csv: cannot append: the file was removed", "", 3);
  EXPECT_EQ(state_of(place, "a"), "failed");
  expect_refused(place, meanwhile("b", "rm b/frames/0001.hdf"), "b/frames/0001.hdf: is missing", "", 3);
  EXPECT_EQ(state_of(place, "b"), "failed");
  expect_refused(place, meanwhile("c", ": > c/frames/0001.hdf"), "c/frames/0001.hdf: ", "", 3);
  EXPECT_EQ(state_of(place, "c"), "failed");
  place.write("other/run.json", "of somebody else");
  expect_refused(place, meanwhile("d", "mv d gone; mv other d"), "bake: ", "", 3);
  EXPECT_EQ(contents(place.folder() / "d/run.json"), "of somebody else");
  EXPECT_FALSE(fs::exists(place.folder() / "d/frames"));
}

TEST(Run, SaysHowManyThreadsRan) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --threads 2 --out a", "OMP_THREAD_LIMIT=1").exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(place.folder() / "a/run.json"))["provenance"]["threads"], 1);
  ASSERT_EQ(place.bake("run dough --quiet --threads 2 --out a").exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(place.folder() / "a/run.json"))["provenance"]["threads"], 2);
}

#ifndef __clang__  // whose OpenMP library binds the first thread later
TEST(Run, UsesAllProcessorsWhereThreadsAreBoundToThem) {
  const Workplace place;
  const auto threads = [&](const std::string& environment) {
    EXPECT_EQ(place.bake("run dough --quiet --frames 1 --out a", "env -u OMP_NUM_THREADS " + environment).exit_code, 0);
    return nlohmann::json::parse(contents(place.folder() / "a/run.json"))["provenance"]["threads"].get<int>();
  };
  const int unbound = threads("");
  for (const char* bound : {"OMP_PROC_BIND=true", "OMP_PROC_BIND=close OMP_PLACES=cores"}) EXPECT_EQ(threads(bound), unbound) << bound;
}
#endif

TEST(Run, ThatEndsLongBeforeItsSecondFrameTakesTheStepsThatItNeeds) {
  const Workplace place;
  EXPECT_EQ(place.bake("run dough --quiet --end 0.001 --set run.frame_rate_per_s=1e-9").exit_code, 0);
}

TEST(Run, ACheckpointOfAnotherSceneIsRefusedAndTheKeyNamed) {
  const Workplace place;
  ASSERT_EQ(place.bake("run dough --quiet --out a").exit_code, 0);
  expect_refused(place, "run dough --resume --out a --set material.dough.density_kg_per_m3=900",
                 "checkpoint.h5: belongs to another scene (material.dough.density_kg_per_m3: found 900, there 1000)");
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
  expect_refused(place, "run dough --quiet --out a", "a/", "trap '' XFSZ; ulimit -f 4;", 3);
  EXPECT_FALSE(half_written_files(place.folder() / "a"));
}

TEST(Run, StopsSoonAfterAFrameThatCannotBeWrittenNamesItAndCanBeGoneOnWith) {
  const Workplace place;
  const std::string ten_frames = "run dough --quiet --set run.end_s=0.05 --out ";
  ASSERT_EQ(place.bake(ten_frames + "whole").exit_code, 0);
  ASSERT_EQ(place.bake(ten_frames + "a --frames 2").exit_code, 0);
  fs::create_directory(place.folder() / "a/frames/0004.hdf.part");  // where the file would be written
  const std::string checkpoint = contents(place.folder() / "a/checkpoint.h5");
  expect_refused(place, ten_frames + "a --resume", "frame 4: a/frames/0004.hdf: cannot create: Is a directory", "", 3);
  EXPECT_EQ(state_of(place, "a"), "failed");
  EXPECT_TRUE(contents(place.folder() / "a/checkpoint.h5") == checkpoint);
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

// SPDX-License-Identifier: MIT
// Figures as a user makes them, from a paper of one small figure. bake-mesh and bake-render are stand-ins that do as little as can be.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_items = R"([[item]]
number = "figure 1"
name = "dough"
shows = "dough at rest"
experiment = "fig01_dough"
status = "done"

[[item]]
number = "table 1"
name = "costs"
shows = "costs"
status = "not there yet"
claims = ["cheap"]
)";

constexpr const char* k_runs = R"(title = "Dough & rest"
shows = "it <rests>"
[[run]]
name = "soft"
scene = "dough"
[[run]]
name = "hard"
scene = "dough"
set = "material.dough.young_modulus_Pa=1e5"
)";

constexpr const char* k_claims = R"([[claim]]
metric = "volume_gain"
of = ["soft", "hard"]
expected = 1
tolerance = 0.01
kind = "analytic"
why = "it is hardly pressed"
[[claim]]
metric = "distance_gain"
of = "hard"
from_m = [0.1, 0.1, 0.05]
to_m = [0.1, 0.1, 0.15]
greater_than = "soft"
factor = 0.9
kind = "analytic"
why = "what is harder is pressed less"
)";

class AFigure : public testing::Test {
 protected:
  AFigure() {
    place.write("paper/items.toml", k_items);
    figure("", "");
  }
  /// The figure's file, with further tables between runs and claims and a change of one of its words.
  void figure(const std::string& more, const std::string& from = "", const std::string& to = "") const {
    std::string text = std::string(k_runs) + more + k_claims;
    text.replace(text.find(from), from.size(), to);
    place.write("experiments/fig01_dough/figure.toml", text);
  }
  void program(const char* name, const std::string& script) const {
    place.write(fs::path("bin") / name, "#!/bin/sh\n" + script);
    fs::permissions(place.folder() / "bin" / name, fs::perms::owner_all);
  }
  nlohmann::json claims() const { return nlohmann::json::parse(contents(place.folder() / "results/items/dough-draft/claims.json")); }
  Workplace place;
};

TEST_F(AFigure, ThatHoldsSucceedsAndWritesItsClaims) {
  expect_success(place, "figure 1 --quiet", "3 of 3 claims hold");
  EXPECT_EQ(claims()["claims"].size(), 3u);
  EXPECT_TRUE(claims()["claims"][2]["holds"]);
  EXPECT_GT(claims()["runs"][1]["particles"], 0);
  EXPECT_GE(claims()["runs"][1]["seconds"], 0);
  EXPECT_TRUE(claims()["runs"][1]["provenance"]["program"].contains("commit"));
}

TEST_F(AFigure, ThatDoesNotHoldIsExitOneAndSaysWhy) {
  figure("", "expected = 1", "expected = 2");
  const Outcome outcome = place.bake("figure dough --quiet");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("MISSED: it is hardly pressed"), std::string::npos) << outcome.out;
  EXPECT_FALSE(claims()["claims"][0]["holds"]);
  EXPECT_EQ(place.bake("figure --all --quiet").exit_code, 1);
}

TEST_F(AFigure, RunsOnlyWhatIsMissing) {
  EXPECT_EQ(place.bake("figure 1 --only-run soft").exit_code, 0);
  EXPECT_FALSE(fs::exists(place.folder() / "results/hard-draft"));
  EXPECT_FALSE(fs::exists(place.folder() / "results/items"));
  const auto made = fs::last_write_time(place.folder() / "results/soft-draft/run.json");
  const Outcome outcome = place.bake("figure 1");
  EXPECT_NE(outcome.err.find("run soft: is finished already"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("run hard: begins"), std::string::npos) << outcome.err;
  EXPECT_EQ(fs::last_write_time(place.folder() / "results/soft-draft/run.json"), made);
}

TEST_F(AFigure, GoesOnWithWhatIsHalfFinished) {
  ASSERT_EQ(place.bake("run dough --frames 1 --quiet --out results/soft-draft").exit_code, 0);
  const Outcome outcome = place.bake("figure 1");
  EXPECT_NE(outcome.err.find("run soft: resumes from its checkpoint"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_TRUE(fs::exists(place.folder() / "results/soft-draft/frames/0002.hdf"));
}

/// The threads that a run was made by.
int threads_of(const Workplace& place, const std::string& run) {
  return nlohmann::json::parse(contents(place.folder() / "results" / (run + "-draft") / "run.json"))["provenance"]["threads"];
}

TEST_F(AFigure, MakesRunsSideBySideOfWhichTheLastHasAllThreads) {
  figure("[[run]]\nname = \"third\"\nscene = \"dough\"\nset = \"material.dough.young_modulus_Pa=2e4\"\n");
  const Outcome outcome = place.bake("figure 1 --threads 2");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(threads_of(place, "soft"), 1);
  EXPECT_EQ(threads_of(place, "hard"), 1);
  EXPECT_EQ(threads_of(place, "third"), 2);
  EXPECT_NE(outcome.err.find("run hard: begins\n"), std::string::npos) << outcome.err;
  const std::string side_by_side = contents(place.folder() / "results/hard-draft/frames/0002.hdf");
  ASSERT_EQ(place.bake("figure 1 --only-run hard --threads 2").exit_code, 0);
  EXPECT_EQ(threads_of(place, "hard"), 1) << "it is there";
  fs::remove_all(place.folder() / "results/hard-draft");
  ASSERT_EQ(place.bake("figure 1 --threads 2").exit_code, 0);
  EXPECT_EQ(threads_of(place, "hard"), 2) << "alone";
  EXPECT_TRUE(contents(place.folder() / "results/hard-draft/frames/0002.hdf") == side_by_side);
}

TEST_F(AFigure, MakesTimedRunsOneAfterTheOther) {
  figure("", "shows = ", "timed = true\nshows = ");
  ASSERT_EQ(place.bake("figure 1 --threads 2").exit_code, 0);
  EXPECT_EQ(threads_of(place, "soft"), 2);
  EXPECT_EQ(threads_of(place, "hard"), 2);
}

TEST_F(AFigure, TellsWhichOfTheRunsSideBySideFails) {
  expect_refused(place, "figure 1 --quiet --threads 2", "bake: run soft: exit 3: results/soft-draft/", "trap '' XFSZ; ulimit -f 4;", 3);
}

TEST_F(AFigure, InterruptedKeepsTheCheckpointsOfAllThatWereUnderWay) {
  std::string scene = contents(place.folder() / "experiments/fig01_dough/dough.toml");
  scene.replace(scene.find("end_s = 0.01"), 12, "end_s = 0.3");
  place.write("experiments/fig01_dough/dough.toml", scene + "[time]\nlargest_step_s = 1e-4\n");
  const std::string until_under_way =
      " & made=$!; for run in soft hard; do while [ \"$(cat results/$run-draft/ledger.csv 2>/dev/null | wc -l)\" -lt 4 ]; do sleep 0.01; "
      "done; "
      "done; kill -TERM $made; wait $made";
  const Outcome stopped = place.bake("figure 1 --threads 2 --quiet" + until_under_way);
  EXPECT_EQ(stopped.exit_code, 3) << "the runs were over before the signal: make them longer";
  EXPECT_NE(stopped.err.find("interrupted; the same command resumes from the checkpoint"), std::string::npos) << stopped.err;
  for (const char* run : {"soft", "hard"})
    EXPECT_TRUE(fs::exists(place.folder() / "results" / (std::string(run) + "-draft") / "checkpoint.h5"));
  const Outcome resumed = place.bake("figure 1 --threads 2");
  EXPECT_NE(resumed.err.find("run hard: resumes from its checkpoint"), std::string::npos) << resumed.err;
}

TEST_F(AFigure, RunsAnewWhatWasMadeFromAnotherScene) {
  ASSERT_EQ(place.bake("run dough --quiet --out results/soft-draft --set material.dough.poisson_ratio=0.2").exit_code, 0);
  EXPECT_NE(place.bake("figure 1").err.find("run soft: begins"), std::string::npos);
  std::string run = contents(place.folder() / "results/soft-draft/run.json");
  const auto solver = run.find("\"solver\": \"") + 11;
  run.replace(solver, 4, "0000");
  place.write("results/soft-draft/run.json", run);
  EXPECT_NE(place.bake("figure 1").err.find("run soft: begins"), std::string::npos) << "of another solver";
}

TEST_F(AFigure, ThatIsNotThereIsRefused) {
  expect_refused(place, "figure 2", "unknown figure '2'");
  expect_refused(place, "figure dogh", "unknown figure 'dogh'; did you mean 'dough'?");
  expect_refused(place, "figure", "found no figure, allowed: a number or name (bake list figures), or --all");
  expect_refused(place, "figure 1 --all", "--all: found an item");
  expect_refused(place, "figure costs", "table 1 (costs): not there yet, allowed: an item that is done");
  expect_refused(place, "table 1", "table 1 (costs): not there yet");
  expect_refused(place, "table 9", "unknown table '9'; allowed: costs (bake list figures)");
  expect_refused(place, "figure 1 --only-run sotf", "--only-run: unknown run 'sotf'; did you mean 'soft'?");
  figure("", "metric = \"volume_gain\"", "metric = \"volume_gian\"");
  expect_refused(place, "figure 1", "figure.toml:11: claim.0.metric: unknown metric 'volume_gian'; did you mean 'volume_gain'?");
}

TEST_F(AFigure, NeedsTheOtherProgramsForMeshesAndPictures) {
  place.move_program_here();
  figure("mesh = true\n");
  expect_refused(place, "figure 1", "bake-mesh: found no such program beside bake, allowed: one built by ./bake figure");
  place.write("experiments/fig01_dough/views/side.toml", "");
  figure("[[picture]]\nname = \"side\"\nshows = \"dough\"\nview = \"side\"\nof = \"soft\"\n");
  expect_refused(place, "figure 1", "bake-render: found no such program beside bake");
  EXPECT_FALSE(fs::exists(place.folder() / "results")) << "not after hours of simulation";
  EXPECT_EQ(place.bake("figure 1 --no-pictures --quiet").exit_code, 0);
  EXPECT_TRUE(claims()["pictures"].empty());
}

TEST_F(AFigure, PassesOnWhatTheOtherProgramsSay) {
  place.move_program_here();
  place.write("experiments/fig01_dough/views/side.toml", "");
  figure("[[picture]]\nname = \"side\"\nshows = \"dough\"\nview = \"side\"\nof = [\"soft\", \"hard\"]\ntimes_s = 0.005\n");
  program("bake-render", "echo working; kill -9 $$");
  expect_refused(place, "figure 1 --quiet", "bake: bake-render: exit 137: working (log: results/items/dough-draft/side.log)", "", 3);
  program("bake-render", "echo 'bake-render: side.toml:3: camera: missing' >&2; exit 2");
  expect_refused(place, "figure 1 --quiet", "bake: bake-render: side.toml:3: camera: missing\n");
  program("bake-render", "[ $1 = jpeg ] || echo \"$@\" >arguments; echo png >results/items/dough-draft/side.png");
  for (const char* size : {"10", "8x48", "64x99999", "64*48", "x"})
    expect_refused(place, fmt::format("figure 1 --quiet --size {}", size), fmt::format("found {}, allowed: WIDTHxHEIGHT", size));
  EXPECT_EQ(place.bake("figure 1 --quiet --size 64x48 --samples 2 --threads 1").exit_code, 0);
  EXPECT_EQ(contents(place.folder() / "arguments"),
            fmt::format("picture {}/experiments/fig01_dough/views/side.toml results/soft-draft/frames/0001.hdf "
                        "results/hard-draft/frames/0001.hdf --out results/items/dough-draft/side.png --results results/soft-draft "
                        "--results results/hard-draft --size 64x48 --samples 2 --threads 1\n",
                        fs::canonical(place.folder()).string()));
  EXPECT_EQ(claims()["pictures"][0]["file"], "side.png");
  fs::remove(place.folder() / "arguments");
  EXPECT_EQ(place.bake("figure 1 --quiet --size 64x48 --samples 2 --threads 2").exit_code, 0);
  EXPECT_FALSE(fs::exists(place.folder() / "arguments")) << "it was there: threads change no picture";
}

TEST_F(AFigure, ShowsItsBodiesFromTheirTimeOn) {
  place.move_program_here();
  place.write("experiments/fig01_dough/views/side.toml", "");
  const std::string picture = "[[picture]]\nname = \"side\"\nshows = \"dough\"\nview = \"side\"\nof = \"soft\"\n";
  const std::string object = "[[object]]\nname = \"turning\"\nshows = \"it\"\nview = \"side\"\npicture = \"side\"\nof = \"soft\"\n";
  program("bake-render", R"(if [ $1 = model ]; then echo "$@" >arguments; mkdir -p results/items/dough-draft/turning/soft
else echo png >results/items/dough-draft/side.png; fi)");
  for (const auto& [from, frames] : {std::pair{"", " --frames 0,1,2 "}, {"from_s = 0.005\n", " --frames 1,2 "}}) {
    figure(picture + object + from);
    ASSERT_EQ(place.bake("figure 1 --quiet").exit_code, 0);
    EXPECT_NE(contents(place.folder() / "arguments").find(frames), std::string::npos) << contents(place.folder() / "arguments");
  }
}

TEST_F(AFigure, RunsItsParticlesFromAMeshAndMeasuresItsFractureSurface) {
  place.move_program_here();
  // the particles of another run serve as the vertices of a mesh
  ASSERT_EQ(place.bake("run dough --frames 1 --quiet --out vertices").exit_code, 0);
  program("bake-mesh", R"(echo "$@" >>arguments
case $1 in
  tets) cp vertices/frames/0000.hdf "$4" ;;
  fracture) mkdir -p "$5"; echo '{"mesh_volume_m3": 1, "frames": [{"time_s": 0.01, "volume_m3": 1, "cut_volume_m3": 1,
    "crack_area_m2": 0, "cracks": [], "pieces": [{"volume_m3": 1, "closed": true}]}]}' >"$5/fracture.json" ;;
esac)");
  figure(R"(mesh = true
[[surface]]
name = "skin"
run = "hard"
reference_time_s = 0.005
times_s = [0.005, 0.01]
[[claim]]
metric = "open_pieces"
of = "skin"
expected = 0
tolerance = 0
kind = "analytic"
why = "nothing tears it"
)");
  const Outcome outcome = place.bake("figure 1 --quiet");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const std::string calls = contents(place.folder() / "arguments");
  EXPECT_NE(calls.find("--quality draft --set material.dough.young_modulus_Pa=1e5"), std::string::npos) << calls;
  EXPECT_NE(
      calls.find("fracture results/hard-draft/mesh.hdf results/hard-draft --out results/items/dough-draft/skin --reference-time 0.005 "
                 "--frames 1,2"),
      std::string::npos)
      << calls;
  fs::remove(place.folder() / "arguments");
  EXPECT_EQ(place.bake("figure 1 --quiet").exit_code, 0);
  EXPECT_FALSE(fs::exists(place.folder() / "arguments")) << "all was there";
}

/// Beside the figure of dough another one, whose two pictures show runs of the first as the tiles of a montage.
class AMontage : public AFigure {
 protected:
  AMontage() {
    place.move_program_here();
    place.write("paper/items.toml", std::string(k_items) + k_tiles);
    place.write("experiments/fig02_tiles/views/side.toml", "");
    program("bake-render", "echo \"$@\" >>arguments\nwhile [ \"$1\" != --out ]; do shift; done\necho png >\"$2\"");
    tiles("soft", "hard");
  }
  void tiles(const std::string& left, const std::string& right, const std::string& figure = "dough") const {
    std::string text = "title = \"Tiles\"\nshows = \"s\"\n";
    for (const auto& [name, of] : {std::pair{"left", left}, std::pair{"right", right}})
      text += fmt::format("[[picture]]\nname = \"{}\"\nshows = \"s\"\nfigure = \"{}\"\nview = \"side\"\nof = \"{}\"\n", name, figure, of);
    text += "[[montage]]\nname = \"both\"\nshows = \"two\"\nrows = \"left right right\"\ncell_width_px = 64\ncell_height_px = 48\n";
    for (const char* name : {"left", "right"})
      text += fmt::format("[[claim]]\nmetric = \"{}_claims_hold\"\nat_least = 1\nkind = \"published\"\nwhy = \"what is shown\"\n", name);
    place.write("experiments/fig02_tiles/figure.toml", text);
  }
  nlohmann::json made() const { return nlohmann::json::parse(contents(place.folder() / "results/items/tiles-draft/claims.json")); }

  static constexpr const char* k_tiles =
      "\n[[item]]\nnumber = \"figure 2\"\nname = \"tiles\"\nshows = \"others\"\nexperiment = \"fig02_tiles\"\nstatus = \"done\"\n";
};

TEST_F(AMontage, IsMadeOfRunsOfOtherFiguresWhoseClaimsHold) {
  const Outcome outcome = place.bake("figure 2 --quiet");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("left   dough   soft  1 of 1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("right  dough   hard  2 of 2"), std::string::npos) << outcome.out;
  EXPECT_EQ(made()["runs"].size(), 2u);
  ASSERT_EQ(made()["pictures"].size(), 1u) << "its tiles are not shown once more";
  EXPECT_EQ(made()["pictures"][0]["file"], "both.png");
  EXPECT_FALSE(fs::exists(place.folder() / "results/items/dough-draft")) << "the other figure's own results are left to it";
  const std::string calls = contents(place.folder() / "arguments");
  EXPECT_NE(calls.find("montage results/items/tiles-draft/left.png results/items/tiles-draft/right.png --row left right right --cell 64x48 "
                       "--out results/items/tiles-draft/both.png\n"),
            std::string::npos)
      << calls;
  EXPECT_NE(calls.find("jpeg results/items/tiles-draft/both.png"), std::string::npos) << calls;
  fs::remove(place.folder() / "arguments");
  EXPECT_NE(place.bake("figure 1").err.find("run soft: is finished already"), std::string::npos);
  EXPECT_EQ(place.bake("figure 2 --quiet").exit_code, 0);
  EXPECT_FALSE(fs::exists(place.folder() / "arguments")) << "all was there, but not " << contents(place.folder() / "arguments");
}

TEST_F(AMontage, HoldsNoMoreThanWhatItShows) {
  figure("", "expected = 1", "expected = 2");
  EXPECT_EQ(place.bake("figure 2 --quiet").exit_code, 1);
  EXPECT_EQ(made()["claims"][0]["measured"], 0);
  EXPECT_EQ(made()["claims"][1]["measured"], 0.5);
}

TEST_F(AMontage, HoldsNothingOfARunOfWhichNothingIsClaimed) {
  figure("[[run]]\nname = \"new\"\nscene = \"dough\"\n");
  tiles("soft", "new");
  const Outcome outcome = place.bake("figure 2 --quiet");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_TRUE(made()["claims"][0]["holds"]);
  EXPECT_FALSE(made()["claims"][1]["holds"]);
}

TEST_F(AMontage, NamesTheRunsOfOthersForProgramsThatDistributeThem) {
  EXPECT_EQ(place.bake("list runs").out, "dough soft\ndough hard\ntiles soft\ntiles hard\n");
  EXPECT_EQ(place.bake("figure tiles --only-run soft --quiet").exit_code, 0);
  EXPECT_TRUE(fs::exists(place.folder() / "results/soft-draft/run.json"));
  EXPECT_FALSE(fs::exists(place.folder() / "results/hard-draft"));
  expect_refused(place, "figure tiles --only-run sotf", "--only-run: unknown run 'sotf'; did you mean 'soft'?");
}

TEST_F(AMontage, OfItselfOrOfAnotherMontageIsRefused) {
  tiles("soft", "hard", "tiles");
  expect_refused(place, "figure 2", "picture.0.figure: found 'tiles', which is this one, allowed: another");
  tiles("soft", "hard", "costs");
  expect_refused(place, "figure 2", "picture.0.figure: table 1 (costs): not there yet");
}

TEST_F(AFigure, DrawsColumnsOfTheLedger) {
  figure("[[chart]]\nname = \"height\"\nshows = \"height over time\"\ncolumn = \"height_m\"\nof = [\"soft\", \"hard\"]\n");
  EXPECT_EQ(place.bake("figure 1 --quiet").exit_code, 0);
  EXPECT_TRUE(fs::exists(place.folder() / "results/items/dough-draft/height.svg"));
  expect_refused(place, "figure 1 --quiet", "gnuplot is missing", "env PATH=/nowhere");
  figure("[[chart]]\nname = \"height\"\nshows = \"height over time\"\ncolumn = \"hight_m\"\nof = \"soft\"\n");
  expect_refused(place, "figure 1 --quiet", "ledger.csv: found no column hight_m");
}

TEST_F(AFigure, IsListedWithItsStatusAndItsRuns) {
  const Outcome figures = place.bake("list figures");
  EXPECT_NE(figures.out.find("figure 1     dough             done"), std::string::npos) << figures.out;
  EXPECT_NE(figures.out.find("not there yet"), std::string::npos) << figures.out;
  EXPECT_EQ(place.bake("list runs").out, "dough soft\ndough hard\n");
  EXPECT_EQ(place.bake("list").out.find("figure"), std::string::npos) << "a figure.toml is no scene";
  EXPECT_EQ(place.bake("list cakes").exit_code, 2);
}

}  // namespace
}  // namespace bake::test

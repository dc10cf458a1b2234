// SPDX-License-Identifier: MIT
// The solver beside the textbook baker, and machines side by side, as a user asks for it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

TEST(CompareTextbook, AgreesOnASmallScene) {
  const Workplace place;
  const Outcome outcome = place.bake("compare-textbook dough --steps 20 --set run.end_s=1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* word : {"20 steps", "position", "velocity", "b_E", "they agree"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " is missing in\n" << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(place.folder() / "results"));
}

TEST(CompareTextbook, StopsAtTheEndOfTheScene) {
  const Workplace place;
  expect_success(place, "compare-textbook dough --steps 1000 --set time.largest_step_s=0.003", "0.01 s");
}

TEST(CompareTextbook, AGridThatWouldNotFitIsRefused) {
  const Workplace place;
  expect_refused(place, "compare-textbook dough --quality paper --set grid.dx_m=0.0005", "GB");
}

TEST(CompareTextbook, WrongStepsAreRefused) {
  const Workplace place;
  expect_refused(place, "compare-textbook dough --steps 0", "--steps: ");
}

/// A file as `./bake bench` writes it: five repetitions of one benchmark [ms].
std::string bench_file(const std::string& name, double time) {
  std::string runs;
  for (int i = 0; i < 5; ++i)
    runs += fmt::format(R"({}{{"name": "{}", "run_type": "iteration", "real_time": {}, "time_unit": "ms"}})", i > 0 ? ", " : "", name,
                        time * (1 + 0.01 * i));
  return R"({"context": {"limit.triad_GB_per_s.1_thread": "10", "limit.triad_GB_per_s.all_threads": "15",
"limit.single_GFLOPs.1_thread": "100", "limit.single_GFLOPs.all_threads": "200", "limit.double_GFLOPs.1_thread": "50",
"limit.double_GFLOPs.all_threads": "100"}, "benchmarks": [)" +
         runs + "]}";
}

TEST(Compare, SaysWhichMachineIsFasterAndDrawsIt) {
  const Workplace place;
  place.write("a.json", bench_file("Step/all", 10));
  place.write("b.json", bench_file("Step/all", 5));
  place.write("c.json", bench_file("Step/all", 10.01));
  const Outcome outcome = place.bake("compare a.json b.json c.json --out charts");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* word : {"2.000", "0.0079", " faster", " noise", "1 faster, 0 slower, 0 no different", "charts/compare.svg"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " is missing in\n" << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(place.folder() / "charts/compare.pdf"));
}

TEST(Compare, WrongFilesAreRefusedAndNothingIsWritten) {
  const Workplace place;
  place.write("a.json", bench_file("Step/all", 10));
  place.write("other.json", bench_file("Step/other", 10));
  place.write("cut.json", bench_file("Step/all", 10).substr(0, 200));
  place.write("scene.json", "{}");
  place.write("unlimited.json", R"({"context": {}, "benchmarks": []})");
  const std::pair<const char*, const char*> mistakes[] = {
      {"a.json", "At least 2 required"},
      {"a.json nowhere.json", "nowhere.json: found no such file"},
      {"a.json other.json", "other.json: found no benchmark that a.json has"},
      {"cut.json a.json", "cut.json: found JSON that is cut short"},
      {"a.json scene.json", "scene.json: found JSON of something else"},
      {"a.json unlimited.json", "unlimited.json: found no \"limit."},
  };
  for (const auto& [files, reason] : mistakes) expect_refused(place, fmt::format("compare {} --out charts", files), reason);
  EXPECT_FALSE(std::filesystem::exists(place.folder() / "charts"));
}

}  // namespace
}  // namespace bake::test

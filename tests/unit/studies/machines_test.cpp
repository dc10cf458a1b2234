// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>

#include "analysis/machines/comparison.h"
#include "solver/core/errors.h"
#include "tests/bench/counters.h"
#include "tests/support/temporary_folder.h"

namespace bake::studies {
namespace {

/// A file of the benchmark program, in short: repetitions of single benchmarks with their times in milliseconds.
struct Bench {
  std::string limits = R"("limit.triad_GB_per_s.1_thread": "10.0", "limit.triad_GB_per_s.all_threads": "15.0",
    "limit.single_GFLOPs.1_thread": "100.0", "limit.single_GFLOPs.all_threads": "200.0",
    "limit.double_GFLOPs.1_thread": "50.0", "limit.double_GFLOPs.all_threads": "100.0")";
  std::string load = "0.1";
  std::vector<std::pair<std::string, std::vector<double>>> runs;

  std::string text() const {
    std::string rows;
    for (const auto& [name, times] : runs) {
      for (const double t : times)
        rows += fmt::format(
            "{}{{\"name\": \"{}\", \"run_name\": \"{}\", \"run_type\": \"iteration\", \"real_time\": {}, \"time_unit\": \"ms\"}}",
            rows.empty() ? "" : ",\n", name, name, t);
      rows += fmt::format(
          ",\n{{\"name\": \"{}_mean\", \"run_name\": \"{}\", \"run_type\": \"aggregate\", \"real_time\": 77, \"flowing\": NaN, "
          "\"time_unit\": \"ms\"}}",
          name, name);
    }
    return fmt::format(
        "{{\"context\": {{{}, \"load_avg\": [{},0,0], \"machine.logical_cores\": \"2\", \"machine.cpu\": \"Abacus\"}},\n"
        "\"benchmarks\": [{}]}}",
        limits, load, rows);
  }
};

class Machines : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
    return folder_.path() / name;
  }
  BenchFile read(const std::string& name, const Bench& bench) { return read_bench_file(write(name, bench.text())); }
  std::string refusal(const std::string& text) {
    const std::string message = message_of<InputError>([&] { read_bench_file(write("bad.json", text)); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind((folder_.path() / "bad.json").string() + ": found ", 0), 0u) << message;
    EXPECT_NE(message.find(", allowed: "), std::string::npos) << message;
    return message;
  }
  TemporaryFolder folder_;
};

const Bench k_bench{.runs = {{"Step/all/single/500K/threads:2/iterations:5/real_time", {10, 11, 12, 13, 14}},
                             {"Part/return_map/double", {1, 1.1, 1.2, 1.3, 1.4}}}};

Bench scaled(Bench bench, double factor) {
  for (auto& [name, times] : bench.runs)
    for (double& t : times) t *= factor;
  return bench;
}

TEST_F(Machines, FilesAreReadWithLimitsAndSingleRepetitions) {
  const BenchFile bench = read("a.json", k_bench);
  ASSERT_EQ(bench.names, (std::vector<std::string>{"Step/all/single/500K/threads:2", "Part/return_map/double"}));
  const auto& seconds = bench.seconds.at("Part/return_map/double");
  ASSERT_EQ(seconds.size(), 5u);
  EXPECT_DOUBLE_EQ(seconds[1], 1.1e-3);
  EXPECT_EQ(bench.triad_GB_per_s.all_threads, 15);
  EXPECT_EQ(bench.double_GFLOPs.one_thread, 50);
  EXPECT_EQ(bench.load, 0.1);
  EXPECT_NE(bench.machine.find("Abacus"), std::string::npos);
}

TEST_F(Machines, WrongFilesAreRefusedInOneLine) {
  const std::string good = k_bench.text();
  EXPECT_NE(refusal("").find("an empty file"), std::string::npos);
  EXPECT_NE(refusal(good.substr(0, good.size() / 2)).find("JSON that is cut short after"), std::string::npos);
  EXPECT_NE(refusal("title = \"bread\"\n").find("no JSON"), std::string::npos);
  EXPECT_NE(refusal("{}").find("JSON of something else"), std::string::npos);
  EXPECT_NE(refusal("[1, 2]").find("JSON of something else"), std::string::npos);
  EXPECT_NE(refusal(R"({"context": {}, "benchmarks": []})").find("no \"limit.triad_GB_per_s.1_thread\""), std::string::npos);
  Bench bench = k_bench;
  bench.limits.replace(bench.limits.find("\"10.0\""), 6, "\"fast\"");
  EXPECT_NE(refusal(bench.text()).find("\"fast\" as \"limit.triad_GB_per_s.1_thread\""), std::string::npos);
  bench = k_bench;
  bench.runs = {{"Part/nothing", {}}};
  std::string aggregates = bench.text();
  aggregates.erase(aggregates.find(",\n{"), 1);
  EXPECT_NE(refusal(aggregates).find("no single repetition"), std::string::npos);
  EXPECT_THROW(read_bench_file(folder_.path() / "nowhere.json"), InputError);
  EXPECT_THROW(read_bench_file(folder_.path()), InputError);
}

TEST_F(Machines, FilesWithACounterThatIsNoNumberAreRead) {
  std::string text = k_bench.text();
  for (const char* word : {"NaN", "-NaN", "Infinity", "-Infinity"})
    text.replace(text.find("\"real_time\": "), 0, fmt::format("\"peak\": {}, ", word));
  EXPECT_EQ(read_bench_file(write("nan.json", text)).seconds.at("Step/all/single/500K/threads:2").size(), 5u);
}

TEST_F(Machines, FilesWithATimeThatIsNoNumberAreRefused) {
  for (const char* word : {"NaN", "-Infinity"}) {
    std::string text = k_bench.text();
    text.replace(text.find("\"real_time\": 10"), 15, fmt::format("\"real_time\": {}", word));
    EXPECT_NE(refusal(text).find("found \"Step/all/single/500K/threads:2\" without a time above 0"), std::string::npos) << refusal(text);
  }
  EXPECT_NE(refusal(std::string(k_bench.text()).replace(k_bench.text().find("77"), 2, "nan")).find("found no JSON (byte "),
            std::string::npos);
}

TEST(ACounter, ThatIsNotFiniteIsLeftOut) {
  std::map<std::string, double> counters;
  bench::set_counter(counters, "M/s", 3);
  bench::set_counter(counters, "peak", std::nan(""));
  bench::set_counter(counters, "triad", 1 / std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(counters, (std::map<std::string, double>{{"M/s", 3}}));
}

TEST_F(Machines, WithoutBenchmarksInCommonAreRefused) {
  Bench other = k_bench;
  other.runs = {{"Step/else", {1, 2}}};
  EXPECT_THROW(compare(read("a.json", k_bench), read("b.json", other)), InputError);
}

TEST_F(Machines, AreToldApartByRatioAndByTheirLimits) {
  Bench fast = scaled(k_bench, 0.5);
  fast.limits.replace(fast.limits.find("\"200.0\""), 7, "\"400.0\"");  // single, all threads
  fast.limits.replace(fast.limits.find("\"15.0\""), 6, "\"22.5\"");    // triad, all threads
  const auto ratios = compare(read("a.json", k_bench), read("b.json", fast));
  ASSERT_EQ(ratios.size(), 2u);
  EXPECT_NEAR(ratios[0].ratio.value, 2, 1e-12);
  EXPECT_EQ(ratios[0].verdict, BenchRatio::Verdict::faster);
  EXPECT_NEAR(ratios[0].fma_ratio, 2, 1e-12);
  EXPECT_NEAR(ratios[0].per_fma(), 1, 1e-12);
  EXPECT_NEAR(ratios[0].triad_ratio, 1.5, 1e-12);
  EXPECT_NEAR(ratios[1].fma_ratio, 1, 1e-12) << "double, one thread";
  EXPECT_NEAR(mean_ratio(ratios), 2, 1e-12);
  EXPECT_EQ(compare(read("a.json", fast), read("b.json", k_bench))[0].verdict, BenchRatio::Verdict::slower);
}

TEST_F(Machines, DifferencesWithinTheScatterAreNoise) {
  const auto ratios = compare(read("a.json", k_bench), read("b.json", scaled(k_bench, 1.05)));
  EXPECT_EQ(ratios[0].verdict, BenchRatio::Verdict::noise);
  const auto same = compare(read("a.json", k_bench), read("b.json", k_bench));
  EXPECT_EQ(same[0].verdict, BenchRatio::Verdict::noise);
  EXPECT_EQ(same[0].p, 1);
}

TEST_F(Machines, ThreeRepeatsAreTooFewToTell) {
  Bench three = k_bench;
  for (auto& [name, times] : three.runs) times.resize(3);
  const BenchFile a = read("a.json", three), b = read("b.json", scaled(three, 0.1));
  const auto ratios = compare(a, b);
  EXPECT_EQ(ratios[0].verdict, BenchRatio::Verdict::too_few);
  EXPECT_NE(in_words(a, b, ratios).find("too few repeats to tell"), std::string::npos);
}

TEST_F(Machines, ThatWereBusyAreNamed) {
  Bench busy = k_bench;
  busy.load = "7.5";
  const BenchFile a = read("a.json", k_bench), b = read("b.json", busy);
  const std::string words = in_words(a, b, compare(a, b));
  EXPECT_NE(words.find("b.json was measured at a load of 7.5 on 2 cores"), std::string::npos) << words;
  EXPECT_EQ(words.find("a.json was measured"), std::string::npos) << words;
}

TEST_F(Machines, AreDrawnWithAnIntervalPerBenchmark) {
  const BenchFile a = read("a.json", k_bench), b = read("b.json", scaled(k_bench, 0.5));
  const auto chart = chart_of(a, {b, b}, {compare(a, b), compare(a, b)});
  ASSERT_EQ(chart.panels.size(), 2u);
  EXPECT_EQ(chart.panels[0].y.tics.size(), 2u);
  EXPECT_NE(charts::csv_of(chart).find("told apart"), std::string::npos);
}

}  // namespace
}  // namespace bake::studies

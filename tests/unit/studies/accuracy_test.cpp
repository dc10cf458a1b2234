// SPDX-License-Identifier: MIT
// The study of accuracy: its fronts, its raw data, and that a study which was stopped goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "experiments/accuracy/expected.h"
#include "experiments/accuracy/reference.h"
#include "experiments/accuracy/result.h"
#include "experiments/common/study.h"
#include "solver/core/errors.h"
#include "solver/scene/entry.h"
#include "solver/scene/reader.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"
#include "tests/support/temporary_folder.h"

namespace bake::studies::accuracy {
namespace {

Point point(int cells, double error, double cost) {
  Point p;
  p.variant.cells = cells;
  p.error = error;
  p.particle_steps = cost;
  return p;
}

Curve curve(const char* label, std::vector<Point> points) {
  Curve c{label, std::move(points)};
  for (Point& p : c.points) p.variant.label = label;
  settle(c);
  return c;
}

TEST(AnErrorThatAFinerGridDoesNotKeep, IsNotSettled) {
  const Curve c = curve("default", {point(4, 0.1, 1), point(8, 0.001, 10), point(16, 0.02, 100)});
  EXPECT_EQ(c.points[0].settled, 0.1);
  EXPECT_EQ(c.points[1].settled, 0.02) << "by chance";
  EXPECT_EQ(c.points[2].settled, 0.02);
}

TEST(ACurveThatFailedOnAFinerGrid, SettlesNothing) {
  Curve c = curve("wild", {point(4, 0.1, 1), point(8, 0.01, 10)});
  c.points[1].failure = "the step became too small";
  settle(c);
  EXPECT_TRUE(front({c}, particle_steps).empty());
}

TEST(TheFront, FallsWithTheCostAndLeavesOutWhatIsBeaten) {
  const std::vector<Curve> curves{curve("default", {point(4, 0.1, 1), point(8, 0.05, 10), point(16, 0.025, 100)}),
                                  curve("good", {point(4, 0.04, 5), point(8, 0.02, 50)})};
  const auto best = front(curves, particle_steps);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[0]->particle_steps, 1);
  EXPECT_EQ(best[1]->particle_steps, 5);
  EXPECT_EQ(best[2]->particle_steps, 50);
  EXPECT_EQ(cheapest(curves, 0.03, particle_steps), best[2]);
  EXPECT_EQ(cheapest(curves, 0.01, particle_steps), nullptr);
  EXPECT_EQ(excess(curves, curves[0].points[2], particle_steps), 2) << "100 against 50 of a better one";
  EXPECT_EQ(excess(curves, *best[1], particle_steps), 1);
}

TEST(TheFront, IsOfTheSolverAlone) {
  std::vector<Curve> curves{curve("default", {point(4, 0.1, 10)}), curve("textbook", {point(4, 0.05, 1)})};
  curves[1].points[0].variant.by = By::textbook;
  ASSERT_EQ(front(curves, particle_steps).size(), 1u);
  EXPECT_EQ(front(curves, particle_steps)[0]->particle_steps, 10);
}

TEST(TheExponent, SaysWhatHalvingTheErrorCosts) {
  const Curve c = curve("default", {point(4, 0.1, 1), point(8, 0.05, 16), point(16, 0.025, 256)});
  EXPECT_NEAR(*order(c), 1, 1e-12);
  EXPECT_NEAR(*exponent(c, particle_steps), 0.25, 1e-12);
  EXPECT_NEAR(cost_of_halving(0.25), 16, 1e-12);
  EXPECT_FALSE(order(curve("short", {point(4, 0.1, 1)})));
}

TEST(EveryVariant, IsAScene) {
  for (const Case& c : all_cases()) {
    int variants = 0;
    for (const Variant& v : variants_of(c, Effort::full)) {
      EXPECT_NO_THROW(c.scene_of(v)) << c.name << ", " << v.label;
      ++variants;
    }
    EXPECT_GT(variants, 10) << c.name;
  }
}

TEST(AReference, OfAnotherSceneOrAnotherVersionOfItIsNotUsed) {
  Case c;
  refer(c, {"bread", "teaching/rising_ball", 0.1, 20, {}});
  EXPECT_NE(c.missing().find("of another version of the scene: reference/accuracy/bread.json"), std::string::npos) << c.missing();
  EXPECT_EQ(find_case("drying_cube").missing(), "");
}

/// Both write the frames and ledgers that quantities of interest are taken from.
TEST(TheTextbook, FindsTheQuantitiesOfInterestOfTheSolver) {
  for (const char* name : {"drying_cube", "rising_ball"}) {
    const Case& c = find_case(name);
    Variant v{"double", 3, 0, {"run.precision=double", "run.end_s=0.1"}, By::solver};
    if (name == std::string("drying_cube")) v.overrides.back() = "run.end_s=600";
    const Scene scene = c.scene_of(v);
    const Found fused = c.measure(scene, By::solver), staged = c.measure(scene, By::textbook);
    ASSERT_EQ(fused.failure + staged.failure, "");
    EXPECT_EQ(staged.particle_steps, fused.particle_steps);
    ASSERT_EQ(staged.parts.size(), fused.parts.size());
    for (const auto& [quantity, error] : fused.parts)
      EXPECT_NEAR(staged.parts.at(quantity), error, 1e-9 * error) << name << ", " << quantity;
  }
}

TEST(AVariantWhoseVeryFirstStepIsTooShort, IsAFailureAndNoEndOfTheStudy) {
  for (const char* name : {"heated_slab", "rising_ball"}) {  // against an exact solution, and against a fine run
    const Case& c = find_case(name);
    const Scene scene = c.scene_of({"too short", 3, 0, {"time.smallest_step_s=1e6", "time.largest_step_s=1e6"}});
    for (const By by : {By::solver, By::textbook}) {
      const Found found = c.measure(scene, by);
      EXPECT_NE(found.failure.find("below time.smallest_step_s"), std::string::npos) << name << ": " << found.failure;
      EXPECT_TRUE(std::isnan(found.error)) << name;
    }
  }
}

TEST(WhatIsExpectedOfAScene, IsWhatWasMeasuredAndWhereThatLeads) {
  const TemporaryFolder folder;
  const auto stored = folder.path() / "accuracy.json";
  const Case& c = find_case("heated_slab");
  const Scene scene = read_scene(scene_path(c.scene));
  const auto quality = [](const char* name, double error) {
    return nlohmann::json{{"quality", name}, {"error", error}, {"particle_steps", 2e6}, {"cpu_s", 3}};
  };
  const auto expected = [&](const std::vector<nlohmann::json>& qualities, const std::string& fingerprint) {
    const nlohmann::json slab{{"scene", c.scene}, {"scene_fingerprint", fingerprint}, {"measured", "Warmth."}, {"qualities", qualities}};
    std::ofstream(stored) << nlohmann::json{{"provenance", {{"machine", {{"cpu", "abacus"}}}}}, {"cases", nlohmann::json::array({slab})}};
    return expected_of(scene, stored);
  };
  const auto draft = quality("draft", 0.04), standard = quality("standard", 0.01);
  auto paper = quality("paper", 0.003);
  const std::string as_is = scene_fingerprint(scene);
  const auto two = expected({draft, standard}, as_is);
  ASSERT_EQ(two.size(), 4u);
  EXPECT_EQ(two[0], "draft: error 4 %, 2 million particle-steps, 3 s of one core of abacus");
  EXPECT_NE(two[2].find("paper: not measured; error about 0.25 %"), std::string::npos) << two[2];
  paper["particle_steps"] = 604e6;
  EXPECT_EQ(expected({draft, standard, paper}, as_is)[2], "paper: error 0.3 %, 604 million particle-steps, 3 s of one core of abacus");
  EXPECT_EQ(expected({draft}, as_is).size(), 2u);
  EXPECT_NE(expected({draft}, "another").at(0).find("another version"), std::string::npos);
  std::ofstream(stored) << "{";
  EXPECT_THROW(expected_of(scene, stored), InputError);
  EXPECT_TRUE(expected_of(scene, folder.path() / "none.json").empty());
}

/// The bar, which is measured in a second.
class AStudy : public testing::Test {
 protected:
  StudyOptions options() const {
    StudyOptions o;
    o.quick = true;
    o.out = folder.path();
    o.cases = {"elastic_bar"};
    return o;
  }
  bool run() const {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const bool held = run_accuracy(options());
    said = testing::internal::GetCapturedStdout();
    progress = testing::internal::GetCapturedStderr();
    return held;
  }
  std::filesystem::path raw() const { return folder.path() / "accuracy/elastic_bar.jsonl"; }
  std::string raw_text() const { return read_text_file(raw()); }
  const TemporaryFolder folder;
  mutable std::string said, progress;
};

TEST_F(AStudy, MeasuresWritesAndRepeatsNothing) {
  ASSERT_TRUE(run()) << said;
  const std::string first = raw_text();
  const auto lines = static_cast<std::size_t>(std::count(first.begin(), first.end(), '\n'));
  EXPECT_EQ(lines, 2 * variants_of(find_case("elastic_bar"), Effort::quick).size()) << "two repeats of each";
  const auto all = nlohmann::json::parse(read_text_file(folder.path() / "accuracy.json"));
  EXPECT_EQ(all.at("cases").at(0).at("case"), "elastic_bar");
  const CaseResult bar(find_case("elastic_bar"), RawData(folder.path() / "accuracy", "elastic_bar"));
  const auto& points = bar.default_curve()->points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_LT(points[2].error, points[0].error / 8) << "second order: a quarter twice";
  EXPECT_GT(front(bar.curves(), particle_steps).size(), 1u);
  const Curve *staged = bar.curve_of("textbook (staged, double)"), *fused = bar.curve_of("double");
  ASSERT_TRUE(staged && fused);
  ASSERT_EQ(staged->points.size(), 2u);
  for (std::size_t i : {0, 1}) {
    const double error = fused->points[i].error;
    EXPECT_NEAR(staged->points[i].error, error, 1e-9 * error) << "the same mathematics and the same steps";
    EXPECT_GT(staged->points[i].cpu_s.median, 0);
  }
  EXPECT_EQ(all.at("speed").at("measurements"), lines);
  for (const char* limit : {"triad_GB_per_s", "single_GFLOPs", "double_GFLOPs"}) {
    // between a processor of long ago and one of the future
    EXPECT_GT(all.at("speed").at(limit).at("low"), 0.1) << limit;
    EXPECT_LT(all.at("speed").at(limit).at("high"), 1e4) << limit;
  }
  const std::string page = read_text_file(folder.path() / "accuracy.md");
  EXPECT_NE(page.find("half the error costs"), std::string::npos);
  EXPECT_NE(page.find("GB/s (triad)"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "accuracy/elastic_bar.svg"));
  ASSERT_TRUE(run());
  EXPECT_EQ(raw_text(), first);
  EXPECT_NE(said.find(" 0 measured now"), std::string::npos) << said;
}

TEST_F(AStudy, LeavesThePageAndOtherCasesAloneIfItOnlyMeasures) {
  std::filesystem::create_directories(folder.path() / "accuracy");
  const auto other = folder.path() / "accuracy/vortex.jsonl";
  std::ofstream(other) << "{\"what\": ";  // another program is writing it
  StudyOptions o = options();
  o.measure_only = true;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_TRUE(run_accuracy(o));
  testing::internal::GetCapturedStderr();
  EXPECT_NE(testing::internal::GetCapturedStdout().find(" measured now; the page is left"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(raw()));
  EXPECT_EQ(read_text_file(other), "{\"what\": ");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "accuracy.json"));
  ASSERT_TRUE(run());
  EXPECT_NE(said.find(" 0 measured now"), std::string::npos) << said;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "accuracy.json"));
}

TEST_F(AStudy, GoesOnBehindAHalfWrittenLineAndRefusesADamagedOne) {
  ASSERT_TRUE(run());
  const std::string first = raw_text();
  std::ofstream(raw(), std::ios::trunc) << first.substr(0, first.size() - 100);
  ASSERT_TRUE(run());
  EXPECT_NE(progress.find("its last line is half-written and left out"), std::string::npos) << progress;
  EXPECT_NE(said.find(" 1 measured now"), std::string::npos) << said;
  std::ofstream(raw(), std::ios::trunc) << "{\"what\": 1\n" << first;
  const std::string message = message_of<InputError>([&] { run_accuracy(options()); });
  EXPECT_NE(message.find("elastic_bar.jsonl:1: found a damaged line"), std::string::npos) << message;
}

TEST_F(AStudy, MeasuresAnewWhatAnotherProgramHasMeasured) {
  ASSERT_TRUE(run());
  std::string text = raw_text();
  const std::string solver = nlohmann::json::parse(text.substr(0, text.find('\n'))).at("by").at("solver");
  for (std::size_t at = text.find(solver); at != std::string::npos; at = text.find(solver, at))
    text.replace(at, solver.size(), "0123456789abcdef");
  std::ofstream(raw(), std::ios::trunc) << text;
  ASSERT_TRUE(run());
  const std::string both = raw_text();
  EXPECT_EQ(std::count(both.begin(), both.end(), '\n'), 2 * std::count(text.begin(), text.end(), '\n')) << "added, nothing lost";
}

TEST_F(AStudy, MissesARepeatThatFoundAnotherError) {
  ASSERT_TRUE(run());
  std::string text = raw_text();
  const std::size_t last = text.rfind("\"error\":");
  text.insert(last + 8, "1");
  std::ofstream(raw(), std::ios::trunc) << text;
  EXPECT_FALSE(run());
  EXPECT_NE(said.find("MISSED: a repeat found another error"), std::string::npos) << said;
}

}  // namespace
}  // namespace bake::studies::accuracy

// SPDX-License-Identifier: MIT
#include "analysis/claims/reference.h"

#include <gtest/gtest.h>

#include <fstream>

#include "solver/core/errors.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

constexpr const char* k_reference = R"({
  "item": "loaf", "scene": "fig15_bread/bread", "quality": "draft",
  "metrics": [
    {"name": "volume_gain", "kind": "published", "at_least": 1.5, "why": "it rises"},
    {"name": "height", "kind": "regression", "expected": 0.4, "tolerance": 0.01, "why": "rounding"}
  ],
  "blessed": {"why": "first", "commit": "abc"}
})";

class AReference : public testing::Test {
 protected:
  Reference read(const std::string& text) const {
    std::ofstream(folder_ / "loaf.json") << text;
    return read_reference(folder_ / "loaf.json");
  }
  std::string error_of(std::string_view part, std::string_view other) const {
    std::string text = k_reference;
    text.replace(text.find(part), part.size(), other);
    try {
      read(text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.path().string().size() + 1);
    }
    return "nothing was thrown";
  }
  /// A finished run whose ledger has these columns and rows.
  Results results(const std::string& ledger, const char* state = "done") const {
    std::ofstream(folder_ / "run.json") << "{\"summary\": {\"state\": \"" << state << "\"}}";
    std::ofstream(folder_ / "ledger.csv") << ledger;
    return Results(folder_.path());
  }
  const TemporaryFolder folder_;
};

TEST_F(AReference, IsWrittenAsItWasRead) {
  Reference reference = read(k_reference);
  write_reference(reference);
  const Reference again = read_reference(reference.file);
  EXPECT_EQ(again.item, "loaf");
  EXPECT_EQ(again.quality, Quality::draft);
  ASSERT_EQ(again.metrics.size(), 2u);
  EXPECT_EQ(again.metrics[0].words(), ">= 1.5");
  EXPECT_EQ(again.metrics[1].words(), "0.4 +- 0.01");
  EXPECT_EQ(again.blessed["commit"], "abc");
}

TEST_F(AReference, WithAMistakeSaysWhereAndWhatIsAllowed) {
  EXPECT_EQ(error_of("\"volume_gain\"", "\"volume_gian\""),
            "loaf.json: metrics.0.name: unknown metric 'volume_gian'; did you mean 'volume_gain'?");
  EXPECT_EQ(error_of("published", "rumoured"),
            "loaf.json: metrics.0.kind: found 'rumoured', allowed: analytic, published, measured, regression");
  EXPECT_EQ(error_of("\"at_least\": 1.5, ", ""),
            "loaf.json: metrics.0: allowed: either expected with tolerance, or at_least, at_most or both");
  EXPECT_EQ(error_of("\"tolerance\": 0.01, ", ""), "loaf.json: metrics.1.expected: needs a tolerance beside it, and a tolerance needs it");
  EXPECT_EQ(error_of("\"why\": \"rounding\"", "\"why\": \"\""), "loaf.json: metrics.1.why: found \"\", allowed: a text");
  EXPECT_EQ(error_of("at_least", "at_laest"), "loaf.json: metrics.0.at_laest: unknown key, did you mean 'at_least'?");
  EXPECT_EQ(error_of("regression", "published").substr(0, 7), "nothing");
}

TEST_F(AReference, HoldsWithinItsToleranceAndNotBeyond) {
  const Reference reference = read(k_reference);
  const auto verdicts = [&](const char* rows) { return check(reference, results(std::string("time_s,volume_m3,height_m\n") + rows)); };
  const auto good = verdicts("0,1,0.2\n1,1.5,0.41\n");
  EXPECT_TRUE(good[0].holds() && good[1].holds());
  EXPECT_EQ(good[0].measured, 1.5);
  const auto bad = verdicts("0,1,0.2\n1,1.49,0.4101\n");
  EXPECT_FALSE(bad[0].holds() || bad[1].holds());
  EXPECT_NE(table(bad).find("MISSED: it rises"), std::string::npos);
  EXPECT_FALSE(verdicts("0,0,0.2\n1,1,0.4\n")[0].holds()) << "a gain over nothing is no number";
}

TEST_F(AReference, IsNotHeldAgainstARunThatDidNotEnd) {
  EXPECT_THROW(results("time_s,volume_m3\n0,1\n", "interrupted"), InputError);
  EXPECT_THROW(results("time_s,volume_m3\n"), InputError);
  EXPECT_THROW(results("time_s\n0\n").column("volume_m3"), InputError);
}

TEST_F(AReference, FindsWhatTheBooksDoNotExplain) {
  const Results run = results("time_s,solid_mass_kg,retired_solid_kg,emitted_solid_kg\n0,2,0,0\n1,1.5,0.5,0\n2,2.25,0.5,0.5\n");
  EXPECT_DOUBLE_EQ(find_metric("solid_drift").of_run(run, {}), 0.125);
}

}  // namespace
}  // namespace bake

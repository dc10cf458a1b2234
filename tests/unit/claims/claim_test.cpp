// SPDX-License-Identifier: MIT
#include "analysis/claims/claim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "analysis/claims/blessing.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

Claim claim(std::vector<std::string> of) {
  Claim c;
  c.metric = std::string("volume_gain");
  c.of = std::move(of);
  c.kind = Evidence::published;
  c.why = std::string("figure 15");
  return c;
}

std::vector<bool> holds(const Claim& c, std::map<std::string, double> values) {
  std::vector<bool> all;
  for (const auto& v : judge(c, {"1", "x"}, [&](const Claim&, const std::string& of) { return values.at(of); })) all.push_back(v.holds);
  return all;
}

TEST(AClaim, HoldsForEachOfItsRunsByItself) {
  Claim c = claim({"a", "b"});
  c.at_least = 2;
  EXPECT_EQ(holds(c, {{"a", 2}, {"b", 1.9}}), (std::vector{true, false}));
}

TEST(AClaim, ComparesWithAnotherRunTimesAFactor) {
  Claim c = claim({"a"});
  c.greater_than = std::string("b");
  c.factor = 1.5;
  EXPECT_EQ(holds(c, {{"a", 3.1}, {"b", 2}}), std::vector{true});
  EXPECT_EQ(holds(c, {{"a", 3}, {"b", 2}}), std::vector{false});
  EXPECT_EQ(holds(c, {{"a", std::nan("")}, {"b", 2}}), std::vector{false});
  EXPECT_EQ(holds(c, {{"a", 3}, {"b", std::nan("")}}), std::vector{false});
}

TEST(AClaim, OfAnOrderHoldsOnlyIfEveryStepDoes) {
  Claim c = claim({"a", "b", "c"});
  c.order = Trend::rising;
  EXPECT_EQ(holds(c, {{"a", 1}, {"b", 2}, {"c", 3}}), (std::vector{true, true, true}));
  EXPECT_EQ(holds(c, {{"a", 1}, {"b", 1}, {"c", 3}}), (std::vector{true, false, true}));
  c.order = Trend::falling;
  EXPECT_EQ(holds(c, {{"a", 3}, {"b", 2}, {"c", 2.5}}), (std::vector{true, true, false}));
  EXPECT_EQ(holds(c, {{"a", std::nan("")}, {"b", 2}, {"c", 1}}), (std::vector{false, false, true}));
  EXPECT_EQ(holds(c, {{"a", k_infinity}, {"b", 2}, {"c", -k_infinity}}), (std::vector{false, false, false}));
}

TEST(AClaim, TellsTheNumbersThatItIsHeldTo) {
  const std::map<std::string, double> values{{"a", 3}, {"b", 2}};
  const auto last = [&](const Claim& c) {
    const ClaimVerdict v = judge(c, {"1", "x"}, [&](const Claim&, const std::string& of) { return values.at(of); }).back();
    return std::pair{v.low, v.high};
  };
  using Bounds = std::pair<std::optional<double>, std::optional<double>>;
  Claim c = claim({"a"});
  c.at_least = 1;
  EXPECT_EQ(last(c), (Bounds{1, {}}));
  c.at_most = 4;
  EXPECT_EQ(last(c), (Bounds{1, 4}));
  c = claim({"a"});
  c.expected = 3;
  c.tolerance = 0.5;
  EXPECT_EQ(last(c), (Bounds{2.5, 3.5}));
  c = claim({"a"});
  c.greater_than = std::string("b");
  c.factor = 1.25;
  EXPECT_EQ(last(c), (Bounds{2.5, {}}));
  c = claim({"a", "b"});
  c.order = Trend::falling;
  EXPECT_EQ(last(c), (Bounds{{}, 3}));
  c.order = Trend::rising;
  c.says = std::string("they rise");
  EXPECT_EQ(last(c), (Bounds{3, {}}));
  EXPECT_EQ(judge(c, {"1", "x"}, [](const Claim&, const std::string&) { return 1.0; }).front().says, "they rise");
}

/// Every kind of condition; `of` a and b.
std::vector<Claim> all_conditions() {
  std::vector<Claim> all(7, claim({"a", "b"}));
  all[0].at_least = -1e300;
  all[1].at_most = 1e300;
  all[2].at_least = -1e300, all[2].at_most = 1e300;
  all[3].expected = 0, all[3].tolerance = 1e300;
  all[4].greater_than = std::string("c");
  all[5].order = Trend::rising;
  all[6].order = Trend::falling;
  return all;
}

TEST(AClaim, OfEveryKindIsMissedWhereANumberIsNone) {
  for (const Claim& c : all_conditions())
    for (const double none : {std::nan(""), k_infinity, -k_infinity})
      for (const ClaimVerdict& v : judge(c, {"1", "x"}, [&](const Claim&, const std::string&) { return Measurement(none); })) {
        EXPECT_FALSE(v.holds) << v.condition << " with " << none;
        EXPECT_FALSE(v.problem.empty()) << v.condition;
      }
}

TEST(AClaim, IsMissedWhereTheOtherRunHasNoNumber) {
  Claim c = claim({"a"});
  c.greater_than = std::string("b");
  const auto verdicts = judge(c, {"1", "x"}, [](const Claim&, const std::string& of) {
    return of == "a" ? Measurement(1e9) : Measurement(NoNumber("b/ledger.csv:7: height_m: found nan"));
  });
  EXPECT_FALSE(verdicts[0].holds);
  EXPECT_EQ(verdicts[0].problem, "b/ledger.csv:7: height_m: found nan");
  EXPECT_NE(table(verdicts).find("MISSED: b/ledger.csv:7: height_m: found nan; figure 15"), std::string::npos) << table(verdicts);
}

TEST(AClaim, HoldsWithinItsToleranceOrBoundsAndNotBeyond) {
  Claim c = claim({"a", "b", "c"});
  c.expected = 0.4, c.tolerance = 0.01;
  EXPECT_EQ(holds(c, {{"a", 0.409}, {"b", 0.4101}, {"c", std::nan("")}}), (std::vector{true, false, false}));
  c.expected = 0.5, c.tolerance = 0.25;
  EXPECT_EQ(holds(c, {{"a", 0.75}, {"b", 0.25}, {"c", 0.7500001}}), (std::vector{true, true, false}));
  c.expected = c.tolerance = std::nullopt;
  c.at_least = 1, c.at_most = 2;
  EXPECT_EQ(holds(c, {{"a", 2}, {"b", 0.9}, {"c", 2.1}}), (std::vector{true, false, false}));
}

TEST(AClaim, OfOneQualityIsNotJudgedAtAnother) {
  Claim c = claim({"a"});
  EXPECT_TRUE(c.is_judged_at("paper"));
  c.quality = Quality::draft;
  EXPECT_TRUE(c.is_judged_at("draft"));
  EXPECT_FALSE(c.is_judged_at("standard"));
}

TEST(Blessing, WritesNumbersAndReasonAndLeavesTheRest) {
  const std::string text = R"(title = "Brötchen" # 9 of them
[[claim]]
expected = 1.5
[[claim]]   # é
  expected = 2e1 # the old one
why = "w"

[[claim]]
expected = 3
)";
  const std::string after = cli::bless_claims(text, {{std::nullopt, 0.1 + 0.2, 4}, "a \"better\" rule", "abc"});
  std::string expected = text;
  expected.replace(expected.find("2e1"), 3, "0.30000000000000004");
  expected.replace(expected.find("= 3\n"), 4, "= 4\n");
  expected += "\n[blessed]\nwhy = \"a \\\"better\\\" rule\"\ncommit = \"abc\"\n";
  EXPECT_EQ(after, expected);
  EXPECT_EQ(cli::bless_claims(after, {{1, 2, 3}, "again", "def"}), cli::bless_claims(text, {{1, 2, 3}, "again", "def"}));
}

TEST(Blessing, RefusesWhatIsNoNumber) {
  const std::string message = message_of<InputError>([] {
    cli::bless_claims("[[claim]]\nexpected = 1\n", {{std::nan("")}, "why", "abc"});
  });
  EXPECT_EQ(message, "claims.toml: claim.0.expected: found nan, allowed: a finite number");
}

TEST(AClaim, IsPrintedWithItsReasonIfItIsMissed) {
  Claim c = claim({"loaf"});
  c.at_most = 1;
  const auto text = table(judge(c, {"1", "x"}, [](const Claim&, const std::string&) { return 2.0; }));
  EXPECT_NE(text.find("volume_gain of loaf"), std::string::npos) << text;
  EXPECT_NE(text.find("MISSED: figure 15"), std::string::npos) << text;
}

}  // namespace
}  // namespace bake

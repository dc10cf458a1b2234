// SPDX-License-Identifier: MIT
#include "analysis/claims/claim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "analysis/claims/blessing.h"

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
}

TEST(AClaim, HoldsWithinItsToleranceOrBoundsAndNotBeyond) {
  Claim c = claim({"a", "b", "c"});
  c.expected = 0.4, c.tolerance = 0.01;
  EXPECT_EQ(holds(c, {{"a", 0.409}, {"b", 0.4101}, {"c", std::nan("")}}), (std::vector{true, false, false}));
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

TEST(AClaim, IsPrintedWithItsReasonIfItIsMissed) {
  Claim c = claim({"loaf"});
  c.at_most = 1;
  const auto text = table(judge(c, {"1", "x"}, [](const Claim&, const std::string&) { return 2.0; }));
  EXPECT_NE(text.find("volume_gain of loaf"), std::string::npos) << text;
  EXPECT_NE(text.find("MISSED: figure 15"), std::string::npos) << text;
}

}  // namespace
}  // namespace bake

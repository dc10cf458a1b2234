// SPDX-License-Identifier: MIT
// Reference metrics as a user checks and blesses them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

/// A place with a reference of its small scene, whose dough settles for 0.01 s.
class ACheck : public testing::Test {
 protected:
  void write_reference(const std::string& bound) const {
    place.write("dough.json", fmt::format(R"({{"item": "dough", "scene": "dough", "quality": "draft",
"metrics": [{{"name": "volume_gain", "kind": "analytic", {}, "why": "it is hardly pressed"}}]}})",
                                          bound));
  }
  void expect_refused(const std::string& arguments, const std::string& reason, const std::string& before = "") const {
    SCOPED_TRACE("bake " + arguments);
    const Outcome outcome = place.bake(arguments, before);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  }
  const Workplace place;
};

TEST_F(ACheck, OfWhatHoldsSucceeds) {
  write_reference("\"expected\": 1, \"tolerance\": 1e-2");
  const Outcome outcome = place.bake("check dough.json --quiet");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 of 1 metrics hold"), std::string::npos) << outcome.out;
}

TEST_F(ACheck, OfWhatDoesNotHoldFailsAndSaysWhy) {
  write_reference("\"at_least\": 2");
  const Outcome outcome = place.bake("check dough.json --quiet --out elsewhere");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("MISSED: it is hardly pressed"), std::string::npos) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(place.folder() / "elsewhere/ledger.csv"));
}

TEST_F(ACheck, OfNothingThatIsKnownIsRefused) {
  expect_refused("check braed", "unknown item 'braed'; did you mean 'bread'?");
  expect_refused("check missing.json", "missing.json: cannot open");
  write_reference("\"at_most\": true");
  expect_refused("check dough.json", "dough.json: metrics.0.at_most: found true, allowed: a number");
  ASSERT_EQ(place.bake("run dough --quiet --out run").exit_code, 0);
  expect_refused("check run", "of which there is no reference");
}

TEST_F(ACheck, IsBlessedWithAReasonAndByPeopleOnly) {
  write_reference("\"at_most\": 2");
  expect_refused("bless dough.json --why ' '", "--why: found nothing", "env -u CI");
  expect_refused("bless dough.json --why because", "found CI in the environment", "env CI=1");
  expect_refused("bless dough.json", "--why is required", "env -u CI");
}

}  // namespace
}  // namespace bake::test

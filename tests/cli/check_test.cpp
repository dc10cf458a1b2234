// SPDX-License-Identifier: MIT
// Claims of one scene as a user checks and blesses them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

/// A place with claims of its small scene, whose dough settles for 0.01 s.
class ACheck : public testing::Test {
 protected:
  void write_claim(const std::string& bound, const std::string& more = "") const {
    place.write("experiments/fig01_dough/claims.toml", fmt::format(R"(title = "Dough"
shows = "it rests"
[[run]]
name = "dough"
scene = "dough"
[[claim]]
metric = "volume_gain"
of = "dough"
{}
kind = "analytic"
why = "it is hardly pressed"
{})",
                                                                   bound, more));
  }
  const Workplace place;
};

constexpr const char* k_file = "experiments/fig01_dough/claims.toml";

TEST_F(ACheck, OfWhatHoldsSucceeds) {
  write_claim("expected = 1\ntolerance = 1e-2");
  expect_success(place, fmt::format("check {} --quiet", k_file), "1 of 1 claims hold");
}

TEST_F(ACheck, OfWhatDoesNotHoldFailsAndSaysWhy) {
  write_claim("at_least = 2");
  const Outcome outcome = place.bake(fmt::format("check {} --quiet --out elsewhere", k_file));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("MISSED: it is hardly pressed"), std::string::npos) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(place.folder() / "elsewhere/ledger.csv"));
}

TEST_F(ACheck, LeavesOutWhatIsClaimedOfAnotherQuality) {
  write_claim("at_most = 2",
              "[[claim]]\nmetric = \"height\"\nof = \"dough\"\nexpected = 0\ntolerance = 0\nquality = \"paper\"\n"
              "kind = \"regression\"\nwhy = \"changed\"\n");
  expect_success(place, fmt::format("check {} --quiet", k_file), "1 of 1 claims hold");
}

TEST_F(ACheck, OfNothingThatIsKnownIsRefused) {
  expect_refused(place, "check braed", "unknown name 'braed'; did you mean 'bread'?");
  expect_refused(place, "check missing.toml", "missing.toml: no such file");
  write_claim("at_most = true");
  expect_refused(place, fmt::format("check {}", k_file), "claims.toml:9: claim.0.at_most: found true, allowed: any finite number");
  write_claim("at_most = 2", "[[run]]\nname = \"more\"\nscene = \"dough\"\n");
  expect_refused(place, fmt::format("check {}", k_file), "allowed: one [[run]] without a mesh");
  ASSERT_EQ(place.bake("run dough --quiet --out run").exit_code, 0);
  expect_refused(place, "check run", "of which nothing is claimed");
}

TEST_F(ACheck, IsBlessedWithAReasonAndByPeopleOnly) {
  write_claim("at_most = 2");
  expect_refused(place, fmt::format("bless {} --why ' '", k_file), "--why: found nothing", "env -u CI");
  expect_refused(place, fmt::format("bless {} --why because", k_file), "found CI in the environment", "env CI=1");
  expect_refused(place, fmt::format("bless {}", k_file), "--why is required", "env -u CI");
}

}  // namespace
}  // namespace bake::test

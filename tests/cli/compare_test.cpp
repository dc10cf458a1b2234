// SPDX-License-Identifier: MIT
// The solver beside the textbook baker, as a user asks for it.
#include <gtest/gtest.h>

#include <algorithm>

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
  const Outcome outcome = place.bake("compare-textbook dough --steps 1000 --set time.largest_step_s=0.003");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("0.01 s"), std::string::npos) << outcome.out;
}

TEST(CompareTextbook, AGridThatWouldNotFitIsRefused) {
  const Workplace place;
  const Outcome outcome = place.bake("compare-textbook dough --quality paper --set grid.dx_m=0.0005");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("GB"), std::string::npos) << outcome.err;
}

TEST(CompareTextbook, WrongStepsAreRefused) {
  const Workplace place;
  EXPECT_EQ(place.bake("compare-textbook dough --steps 0").exit_code, 2);
}

}  // namespace
}  // namespace bake::test

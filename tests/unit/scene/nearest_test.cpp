// SPDX-License-Identifier: MIT
#include "solver/scene/nearest.h"

#include <gtest/gtest.h>

namespace bake::test {
namespace {

const std::vector<std::string> k_words = {"motion", "heat", "water", "density_kg_per_m3"};

TEST(Nearest, FindsTheWordThatWasMeant) {
  EXPECT_EQ(nearest("motoin", k_words), "motion");
  EXPECT_EQ(nearest("haet", k_words), "heat");
  EXPECT_EQ(nearest("Heat", k_words), "heat");
  EXPECT_EQ(nearest("waters", k_words), "water");
}

TEST(Nearest, FindsKeysWhoseUnitWasForgotten) { EXPECT_EQ(nearest("density", k_words), "density_kg_per_m3"); }

TEST(Nearest, DoesNotGuessWildly) {
  EXPECT_EQ(nearest("zucchini", k_words), "");
  EXPECT_EQ(nearest("", k_words), "");
  EXPECT_EQ(nearest(std::string(1000, 'h'), k_words), "");
  EXPECT_EQ(suggestion("zucchini", {"a", "b"}), "allowed: a, b");
}

}  // namespace
}  // namespace bake::test

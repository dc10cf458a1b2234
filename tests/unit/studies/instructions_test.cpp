// SPDX-License-Identifier: MIT
#include "tests/count/instructions.h"

#include <gtest/gtest.h>

#include "solver/core/errors.h"
#include "tests/support/temporary_folder.h"

namespace bake::count {
namespace {

TEST(Instructions, MayChangeByThreePercent) {
  const Counts stored{{"heat", 1000}, {"all", 5000}};
  EXPECT_TRUE(compare({{"heat", 1000}, {"all", 5000}}, stored).second);
  EXPECT_TRUE(compare({{"heat", 1029}, {"all", 4851}}, stored).second);
  EXPECT_FALSE(compare({{"heat", 1031}, {"all", 5000}}, stored).second);
  EXPECT_FALSE(compare({{"heat", 1000}, {"all", 4800}}, stored).second) << "fewer is to be stored, else it is lost unseen";
}

TEST(Instructions, OfEveryCombinationAreStoredAndCounted) {
  EXPECT_FALSE(compare({{"heat", 1000}}, {{"heat", 1000}, {"all", 5000}}).second);
  EXPECT_FALSE(compare({{"heat", 1000}, {"all", 5000}}, {{"heat", 1000}}).second);
  EXPECT_NE(compare({{"all", 5000}}, {}).first.find("NOT STORED"), std::string::npos);
  EXPECT_NE(compare({}, {{"all", 5000}}).first.find("NOT COUNTED"), std::string::npos);
}

TEST(Instructions, AreStoredWithCompilerAndReason) {
  const TemporaryFolder folder;
  write_stored(folder / "i.json", {{"heat", 1234}, {"all", 5678}}, "a test", std::string(40, 'a'));
  const Stored stored = read_stored(folder / "i.json");
  EXPECT_EQ(stored.compiler, this_compiler());
  EXPECT_EQ(this_compiler().find('.'), std::string::npos);
  EXPECT_TRUE(compare(stored.counts, {{"heat", 1234}, {"all", 5678}}).second);
}

TEST(Instructions, FromAWrongFileAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_stored(folder / "nowhere.json"), InputError);
  for (const char* text :
       {"", "{", "{}", R"({"compiler": 3, "instructions": {}})", R"({"compiler": "g++ 12", "instructions": {"heat": -1}})"}) {
    std::ofstream(folder / "bad.json") << text;
    EXPECT_THROW(read_stored(folder / "bad.json"), InputError) << text;
  }
}

}  // namespace
}  // namespace bake::count

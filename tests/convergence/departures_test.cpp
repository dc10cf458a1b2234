// SPDX-License-Identifier: MIT
#include "experiments/departures/departures.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace bake::studies {
namespace {

const std::filesystem::path k_sources = BAKE_SOURCE_DIR;

TEST(Departures, OfTheSourcesAllStandOnThePage) {
  const std::string page = contents(k_sources / "paper/departures.md");
  const auto all = find_departures(k_sources);
  EXPECT_GE(all.size(), 10u);
  for (const Departure& d : all)
    EXPECT_NE(page.find("| " + d.equation + " | `" + d.file + "` | " + d.text + " |"), std::string::npos)
        << d.file << " " << d.equation << ": paper/departures.md is old, bake study departures --out paper writes it anew";
}

TEST(APrintedForm, DoesWhatIsSaidOfIt) {
  for (const Consequence& c : all_consequences(true))
    EXPECT_TRUE(c.departs) << c.equation << ": " << c.measured << ": here " << c.standard << ", as printed " << c.published;
}

TEST(ACommentOfADeparture, GoesOnToItsEnd) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "solver");
  std::ofstream(folder / "solver/law.h")
      << "/// Some law.\n/// DEPARTS [Ding19 Eq. 1]: one thing\n/// and its reason.\n///\n/// Not part of it.\nint x;\n"
         "// DEPARTS [Ding19 Sec. 2]: another.\n// DEPARTS [Ding19 Eq. 3]: a third.\n";
  const auto all = find_departures(folder.path());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].equation, "Eq. 1");
  EXPECT_EQ(all[0].text, "one thing and its reason.");
  EXPECT_EQ(all[1].text, "another.");
  EXPECT_EQ(all[2].file, "solver/law.h");
}

}  // namespace
}  // namespace bake::studies

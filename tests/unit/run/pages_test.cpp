// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "solver/run/ledger.h"
#include "solver/run/simulation.h"
#include "tests/conservation/dough.h"
#include "tests/support/page.h"

namespace bake {
namespace {

TEST(Pages, SayWhatEveryColumnIs) { expect_page("columns.md", columns_page()); }
TEST(Pages, SayWhatEverySymbolIs) { expect_page("notation.md", notation_page()); }

TEST(Ledger, HasEachNameOnceWithAMeaning) {
  std::set<std::string> names;
  for (const LedgerColumn& c : ledger()) {
    EXPECT_TRUE(names.insert(c.name).second) << c.name;
    EXPECT_FALSE(c.meaning.empty() || c.unit.empty() || c.how.empty()) << c.name;
    EXPECT_NE(explain_column(c.name).find(c.meaning), std::string::npos);
  }
  EXPECT_EQ(ledger().front().name, "time_s");  // the ledger's file is ordered by it
  EXPECT_EQ(explain_column("heat_contents_J"), "");
}

TEST(Ledger, OfAnEffectThatIsNotListedIsZero) {
  Dough dough("heat");
  const auto s = dough.begin();
  for (const LedgerColumn& c : ledger()) {
    if (is_of_scene(dough.scene(), c.name)) continue;
    EXPECT_EQ(c.value(*s, s->extent()), 0) << c.name;
  }
  EXPECT_TRUE(is_of_scene(dough.scene(), "temperature_max_C"));
  EXPECT_FALSE(is_of_scene(dough.scene(), "water_mass_kg"));
  EXPECT_GT(s->total(total::heat_content), 0);
}

}  // namespace
}  // namespace bake

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

TEST(Ledger, HasColumnsForEachGiverOnRequest) {
  Dough dough;
  dough.tables =
      "[[collider]]\nname = \"plate\"\nshape = { half_space = { point_m = [0, 0, -0.9], normal = [0, 0, 1] } }\nledger = true\n"
      "[[grip]]\nname = \"hand\"\nshape = { sphere = { radius_m = 0.1 } }\nledger = true\n";
  std::vector<std::string> columns = ledger_columns(dough.scene());
  const std::vector<std::string> own(columns.begin() + static_cast<std::ptrdiff_t>(ledger_columns().size()), columns.end());
  EXPECT_EQ(own, (std::vector<std::string>{"collider_plate_impulse_x_kg_m_per_s", "collider_plate_impulse_y_kg_m_per_s",
                                           "collider_plate_impulse_z_kg_m_per_s", "collider_plate_heat_J", "grip_hand_impulse_x_kg_m_per_s",
                                           "grip_hand_impulse_y_kg_m_per_s", "grip_hand_impulse_z_kg_m_per_s"}));
  EXPECT_EQ(ledger_row(*dough.begin()).size(), columns.size());
  for (const std::string& name : own) EXPECT_NE(explain_column(name).find("gave to the dough"), std::string::npos) << name;
  EXPECT_EQ(ledger_columns(Dough().scene()), ledger_columns());
  for (const LedgerColumn& c : ledger())
    for (const char* kind : {"collider_", "grip_", "face_"}) EXPECT_FALSE(c.name.starts_with(kind)) << c.name;
}

}  // namespace
}  // namespace bake

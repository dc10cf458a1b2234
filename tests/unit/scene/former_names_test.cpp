// SPDX-License-Identifier: MIT
#include "solver/scene/catalogue.h"
#include "solver/scene/explain.h"
#include "solver/scene/resolved.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

const std::string k_new = "[oven]\nheat_transfer_coefficient_W_per_m2K = 3\n", k_old = "[oven]\nexchange_W_per_m2K = 3\n";
using Notices = std::vector<std::string>;

TEST(AFormerName, IsReadWithANotice) {
  const Scene scene = parse(k_least + k_old);
  EXPECT_EQ(scene.oven.heat_transfer_coefficient_W_per_m2K(0), 3);
  EXPECT_EQ(scene.notices,
            Notices{"bread.toml:10: oven.exchange_W_per_m2K is now called heat_transfer_coefficient_W_per_m2K; the old name is "
                    "read until 1.0"});
  EXPECT_EQ(parse(k_least + k_new).notices, Notices{});
}

TEST(AFormerName, BesideTheNewOneIsRefused) {
  EXPECT_EQ(error_of(k_least + k_old + "heat_transfer_coefficient_W_per_m2K = 3\n"),
            "bread.toml:10: oven.exchange_W_per_m2K: found beside heat_transfer_coefficient_W_per_m2K, its new name, allowed: one of them");
}

TEST(AFormerName, InAnOverrideWinsOverTheFileAndIsToldAsSuch) {
  const Scene scene = parse(k_least + k_new, {"oven.exchange_W_per_m2K=4"});
  EXPECT_EQ(scene.oven.heat_transfer_coefficient_W_per_m2K(0), 4);
  EXPECT_EQ(scene.notices, Notices{"override 'oven.exchange_W_per_m2K=4': oven.exchange_W_per_m2K is now called "
                                   "heat_transfer_coefficient_W_per_m2K; the old name is read until 1.0"});
}

TEST(AFormerName, InTheFileGivesWayToAnOverrideUnderTheNewOne) {
  const Scene scene = parse(k_least + k_old, {"oven.heat_transfer_coefficient_W_per_m2K=4"});
  EXPECT_EQ(scene.oven.heat_transfer_coefficient_W_per_m2K(0), 4);
  EXPECT_EQ(scene.notices, Notices{});
}

TEST(AFormerName, ThatIsMisspeltLeadsToTheNewOne) {
  EXPECT_EQ(error_of(k_least + "[oven]\nexchange_W_per_mK = 3\n"),
            "bread.toml:10: oven: unknown key 'exchange_W_per_mK', did you mean 'heat_transfer_coefficient_W_per_m2K'?");
}

TEST(AFormerName, IsExplainedByTheNewOne) {
  const std::string text = explain("oven.heat_transfer_coefficient_W_per_m2K");
  EXPECT_EQ(explain("oven.exchange_W_per_m2K"), text);
  EXPECT_NE(text.find("\n  formerly exchange_W_per_m2K, which is read until 1.0\n"), std::string::npos) << text;
  EXPECT_EQ(explain("body.0.spin_rad_per_s"), explain("body.angular_velocity_rad_per_s"));
}

TEST(AFormerName, IsNoPresentNameInTheSameTable) {
  int found = 0;
  for (const CatalogueSection& section : catalogue())
    for (const CatalogueKey& key : section.keys) {
      found += !key.former.empty();
      for (const CatalogueKey& other : section.keys) EXPECT_NE(other.key, key.former) << section.name;
    }
  EXPECT_EQ(found, 4);
}

TEST(AFormerName, IsWhatScenesAreComparedUnder) {
  const nlohmann::json now = resolved(parse(k_full)), before = under_former_names(now);
  EXPECT_EQ(now["oven"].count("exchange_W_per_m2K"), 0u);
  EXPECT_EQ(before["oven"]["exchange_W_per_m2K"], now["oven"]["heat_transfer_coefficient_W_per_m2K"]);
  EXPECT_EQ(before["body"][0]["spin_rad_per_s"], now["body"][0]["angular_velocity_rad_per_s"]);
  EXPECT_EQ(before["heat"]["exchange_form"], "standard");
  EXPECT_EQ(before["oven"].size(), now["oven"].size());
  EXPECT_EQ(under_former_names(before), before);
}

}  // namespace
}  // namespace bake::test

// SPDX-License-Identifier: MIT
#include "solver/scene/explain.h"

#include "solver/boundary/shapes.h"
#include "solver/effects/all_effects.h"
#include "solver/scene/describe.h"
#include "solver/scene/layout.h"
#include "tests/support/page.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string refusal(const std::string& key) {
  return message_of<InputError>([&] { explain(key); });
}

TEST(Explain, AFullKeySaysEverythingAboutIt) {
  EXPECT_EQ(explain("material.conductivity_W_per_mK"),
            "material.conductivity_W_per_mK\n"
            "  kappa: heat conductivity of the mixture\n"
            "  written  [[material]] with heat\n"
            "  unit     W/(m K)\n"
            "  allowed  a number of at least 0\n"
            "  default  required\n"
            "  effect   heat\n");
  EXPECT_TRUE(contains(explain("oven.temperature_C"), "default  20\n"));
  EXPECT_TRUE(contains(explain("time.largest_step_s"), "default  inf\n"));
  EXPECT_TRUE(contains(explain("heat.integrator"), "default  \"forward_euler\"\n"));
  EXPECT_TRUE(contains(explain("effects"), "\"leavening\""));
}

TEST(Explain, ABareKeyListsEveryTableThatHasIt) {
  const std::string text = explain("temperature_C");
  for (const char* key : {"oven.temperature_C\n", "body.temperature_C\n", "collider.temperature_C\n"})
    EXPECT_TRUE(contains(text, key)) << key;
  EXPECT_FALSE(contains(text, "initial_temperature_C"));
}

TEST(Explain, TablesEffectsAndShapesHaveTheirKeysListed) {
  EXPECT_TRUE(contains(explain("oven"), "heat_transfer_coefficient_W_per_m2K"));
  EXPECT_TRUE(contains(explain("heat"), "conductivity_W_per_mK"));
  EXPECT_TRUE(contains(explain("heat"), "integrator"));
  EXPECT_TRUE(contains(explain("leavening"), "needs plasticity and heat"));
  EXPECT_TRUE(contains(explain("sphere"), "radius_m"));
  EXPECT_TRUE(contains(explain("shape"), "rotate_deg"));
}

TEST(Explain, NamesFromErrorMessagesAreUnderstood) {
  EXPECT_EQ(explain("material.dough.young_modulus_Pa"), explain("material.young_modulus_Pa"));
  EXPECT_EQ(explain("body.0.shape.sphere.radius_m"), explain("sphere.radius_m"));
}

TEST(Explain, NothingGivesAnOverviewOfAllTables) {
  const std::string text = explain("");
  for (const std::string& table : table_names()) EXPECT_TRUE(contains(text, "[" + table + "]")) << table;
}

TEST(Explain, UnknownNamesComeWithTheNearestOne) {
  EXPECT_EQ(refusal("oven.temprature_C"),
            "no scene key, table, effect, shape or column is called 'oven.temprature_C', did you mean 'oven.temperature_C'?");
  EXPECT_EQ(refusal("haet"), "no scene key, table, effect, shape or column is called 'haet', did you mean 'heat'?");
  EXPECT_EQ(refusal("density"), "no scene key, table, effect, shape or column is called 'density', did you mean 'density_kg_per_m3'?");
  EXPECT_EQ(refusal("qqqqqqqqqqqqqqqqqqq"),
            "no scene key, table, effect, shape or column is called 'qqqqqqqqqqqqqqqqqqq', allowed: those of `bake explain`");
}

TEST(DocumentationPage, HoldsEveryKey) {
  const std::string page = documentation_page();
  const auto expect_keys = [&]<class T>() {
    for (const std::string& key : keys_of<T>()) EXPECT_TRUE(contains(page, "| `" + key + "` |")) << key;
  };
  for_each_effect([&]<class Effect>() {
    expect_keys.template operator()<typename Effect::Settings>();
    expect_keys.template operator()<typename Effect::Material>();
  });
  [&]<class... S>(std::tuple<S...>*) { (expect_keys.template operator()<S>(), ...); }(static_cast<AllShapes*>(nullptr));
  expect_keys.template operator()<Emitter>();
}

TEST(DocumentationPage, IsCommittedAsItIsGenerated) { expect_page("scene.md", documentation_page()); }

}  // namespace
}  // namespace bake::test

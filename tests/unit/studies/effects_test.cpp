// SPDX-License-Identifier: MIT
#include "experiments/effects/effects.h"

#include <gtest/gtest.h>

#include <set>

#include "analysis/machines/scenes.h"

namespace bake::studies {
namespace {

std::set<std::string> effects_of(const std::string& combination) {
  for (const bench::Combination& c : bench::k_combinations)
    if (c.name == combination) return {c.effects.begin(), c.effects.end()};
  ADD_FAILURE() << "no combination " << combination;
  return {};
}

TEST(Margins, AreBetweenCombinationsThatDifferInTheEffectAlone) {
  for (const Margin& margin : all_margins()) {
    std::set<std::string> with = effects_of(margin.with);
    const std::set<std::string> without = effects_of(margin.without);
    if (margin.effect == "motion, elasticity")
      with.erase("motion"), with.erase("elasticity");
    else
      EXPECT_EQ(with.erase(margin.effect), 1u) << margin.effect << " in " << margin.with;
    EXPECT_EQ(with, without) << margin.with << " less " << margin.without;
  }
}

TEST(LeavingOut, TakesAlongWhatNeedsTheEffect) {
  const std::vector<std::string> all{"motion", "heat", "water", "elasticity", "plasticity", "leavening"};
  EXPECT_EQ(with_dependents("water", all), (std::vector<std::string>{"water"}));
  EXPECT_EQ(with_dependents("heat", all), (std::vector<std::string>{"heat", "leavening"}));
  EXPECT_EQ(with_dependents("elasticity", all), (std::vector<std::string>{"elasticity", "plasticity", "leavening"}));
  EXPECT_EQ(with_dependents("heat", {"heat", "water"}), (std::vector<std::string>{"heat"}));
}

Outcome outcome(double volume, double height) {
  Outcome o;
  o.quantities = {{"volume gain", "1", volume}, {"height", "m", height}};
  return o;
}

TEST(Influence, IsTheChangeInUnitsOfTheDiscretisationsError) {
  const Influence influence{outcome(2, 0.3), outcome(1.9, 0.28), {outcome(1, 0.29)}};
  EXPECT_NEAR(influence.error_of(0), 0.1, 1e-12);
  EXPECT_NEAR(influence.change_of(0, influence.without[0]), -1, 1e-12);
  const auto [most, of] = influence.largest(influence.without[0]);
  EXPECT_NEAR(most, 10, 1e-9);
  EXPECT_EQ(of, "volume gain");
}

TEST(Influence, HasNoYardstickShorterThanRoundOff) {
  const Influence influence{outcome(2, 0.3), outcome(2, 0.3), {}};
  EXPECT_NEAR(influence.error_of(0), 2e-6, 1e-12);
  EXPECT_EQ(influence.largest(outcome(2, 0.3)).first, 0);
}

TEST(Influence, OfSubgridDiffusionIsThatOfASettingAndOfNoEffect) {
  for (const Influence& scene : measure_influence({2, 4, 0.05})) {
    const Outcome& without = scene.without.back();
    EXPECT_EQ(without.left_out, std::vector<std::string>{"subgrid diffusion"});
    EXPECT_EQ(without.combination, scene.whole.combination);
    EXPECT_GT(scene.largest(without).first, 0) << scene.whole.scene;
  }
}

TEST(Costs, AreMeasuredForEveryCombinationInEveryRepeat) {
  const auto costs = measure_costs({200, 1, 1, 3});
  ASSERT_EQ(costs.size(), 13u);  // all without FLIP
  for (const Cost& cost : costs) {
    EXPECT_EQ(cost.cpu_ns.size(), 3u);
    EXPECT_GT(cost.cpu_ns.front(), 0);
    EXPECT_GT(cost.step_limit_s, 0);
    EXPECT_EQ(cost.bytes_per_particle, 4 * cost.columns);
  }
  for (const Margin& margin : all_margins()) EXPECT_EQ(added_ns(costs, margin.with, margin.without).size(), 3u);
}

}  // namespace
}  // namespace bake::studies

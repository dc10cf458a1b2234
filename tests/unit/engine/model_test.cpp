// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "solver/engine/physics.h"
#include "tests/conservation/dough.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// What a composition costs: numbers per particle, and per node before and after the grid update.
struct Cost {
  const char* effects;
  const char* motion;
  int columns, scattered, gathered;
};

// By hand. Particle: position 3, identity, volume, mass = 6; motion J = 1; FLIP velocity 3; heat theta and peak = 2; water m_w and its
// spread = 2
// and, where its solid moves, its last momentum 3; elasticity b_E = 6; plasticity J_P = 1; leavening nu and c = 2. Node, scattered:
// momentum 3 and mass = 4; FLIP 3; volume 1 with heat or water; heat capacity, content, change, lent, conductivity = 5; water mass,
// capacity, change, evaporability, permeability, spread = 6. Gathered: velocity 3; FLIP 3; heat 2; water 3.
constexpr Cost k_costs[] = {
    {"heat", "", 8, 6, 2},
    {"water", "", 8, 7, 3},
    {"heat, water", "", 10, 12, 5},
    {"motion, elasticity", "", 13, 4, 3},
    {"motion, heat, elasticity", "", 15, 10, 5},
    {"motion, water, elasticity", "", 18, 11, 6},
    {"motion, heat, water, elasticity", "", 20, 16, 8},
    {"motion, elasticity, plasticity", "", 14, 4, 3},
    {"motion, heat, elasticity, plasticity", "", 16, 10, 5},
    {"motion, water, elasticity, plasticity", "", 19, 11, 6},
    {"motion, heat, water, elasticity, plasticity", "", 21, 16, 8},
    {"motion, heat, elasticity, plasticity, leavening", "", 18, 10, 5},
    {"motion, heat, water, elasticity, plasticity, leavening", "", 23, 16, 8},
    {"motion, elasticity", k_flip, 16, 7, 6},
    {"motion, elasticity, plasticity", k_flip, 17, 7, 6},
    {"motion, heat, water, elasticity, plasticity, leavening", k_flip, 26, 19, 11},
};

Scene scene_with(const char* effects, const char* motion) {
  Dough dough(effects);
  dough.motion = motion;
  return dough.scene();
}

TEST(AnEffectThatIsNotListed, CostsNothing) {
  for (const Cost& cost : k_costs) {
    const auto physics = make_physics<float>(scene_with(cost.effects, cost.motion));
    EXPECT_EQ(physics->column_count, cost.columns) << cost.effects << " " << cost.motion;
    EXPECT_EQ(physics->scatter_channels, cost.scattered) << cost.effects << " " << cost.motion;
    EXPECT_EQ(physics->gather_channels, cost.gathered) << cost.effects << " " << cost.motion;
    const auto in_double = make_physics<double>(scene_with(cost.effects, cost.motion));
    EXPECT_EQ(in_double->column_count, cost.columns);
    EXPECT_EQ(in_double->scatter_channels, cost.scattered);
  }
}

TEST(AModel, HasOnlyTheColumnsOfItsEffects) {
  const auto physics = make_physics<double>(scene_with("heat", ""));
  std::string names;
  for (const auto& column : physics->columns) names += column.name + " ";
  EXPECT_EQ(names, "position id initial_volume solid_mass temperature peak_temperature ");
  EXPECT_FALSE(physics->moves);
  EXPECT_GE(physics->temperature_channel, 0);
  EXPECT_FALSE(physics->moves_mass);
}

/// The message for a combination that is not compiled.
std::string refusal(const char* effects, const char* motion = "") {
  return message_of<InputError>([&] { make_physics<float>(scene_with(effects, motion)); });
}

TEST(AModel, OfUnknownCombinationIsRefusedInOneLineThatListsAllKnownOnes) {
  for (const char* effects : {"motion", "", "motion, heat", "motion, heat, water"}) {
    const std::string message = refusal(effects);
    EXPECT_EQ(message.find("built.toml:1: effects: found "), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    for (const char* known : {" heat, ", " water, ", " heat+water, ", " motion+elasticity, ", "+plasticity+leavening"})
      EXPECT_NE(message.find(known), std::string::npos) << known << " in " << message;
  }
  EXPECT_NE(refusal("").find("found none, allowed: "), std::string::npos);
  EXPECT_NE(refusal("motion").find("found motion, allowed: "), std::string::npos);
}

TEST(AModel, WithFlipIsRefusedWhereFlipWasNotCompiled) {
  const std::string message = refusal("motion, heat, elasticity", k_flip);
  EXPECT_NE(message.find("with transfer = \"flip\""), std::string::npos) << message;
}

}  // namespace
}  // namespace bake

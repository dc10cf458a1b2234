// SPDX-License-Identifier: MIT
#include "solver/scene/warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

using Edits = std::vector<std::pair<std::string, std::string>>;

/// Of a dough of which every effect has something to do, with some of its text replaced.
std::string warnings(const std::string& effects, const Edits& edits = {}, const std::string& tables = "") {
  std::string text = fmt::format("effects = [{}]\n", effects) + k_least + R"([oven]
heat_transfer_coefficient_W_per_m2K = 25
[motion]
gravity_m_per_s2 = [0, 0, -9.81]
[[material]]
name = "dough"
density_kg_per_m3 = 500
specific_heat_J_per_kgK = 1000
conductivity_W_per_mK = 1
young_modulus_Pa = 1e4
yield_stress_Pa = 20
diffusivity_m2_per_sK = 1e-7
production_mol_per_kgs = 0.01
[[body]]
material = "dough"
shape = { sphere = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.1 } }
)" + tables;
  for (const auto& [from, to] : edits) text = replaced(text, from, to);
  return fmt::format("{}", fmt::join(warnings_about(parse(text)), "; "));
}

const std::string k_all = R"("motion", "elasticity", "plasticity", "heat", "water", "leavening")";
const std::string k_unleavened = R"("motion", "elasticity", "plasticity", "heat", "water")";
const std::pair<std::string, std::string> k_no_leavener{"production_mol_per_kgs = 0.01\n", ""};
const std::pair<std::string, std::string> k_no_exchange{"heat_transfer_coefficient_W_per_m2K = 25\n", ""};
const std::pair<std::string, std::string> k_no_gravity{"[0, 0, -9.81]", "[0, 0, 0]"};

TEST(Doubts, AreNoneWhereEveryEffectHasSomethingToDo) {
  EXPECT_EQ(warnings(k_all), "");
  EXPECT_EQ(warnings(k_all, {k_no_gravity}), "");  // it rises
  EXPECT_EQ(warnings(k_unleavened, {k_no_leavener}), "");
}

TEST(Doubts, NameAListedEffectThatCannotMatter) {
  EXPECT_EQ(
      warnings(k_all, {{"diffusivity_m2_per_sK = 1e-7", ""}}),
      "effects lists water, which cannot matter: diffusivity_m2_per_sK and pressure_Pa are zero: no water comes to the surface, it only "
      "counts as mass and heat capacity");
  EXPECT_EQ(
      warnings(k_all, {k_no_leavener}),
      "effects lists leavening, which cannot matter: production_mol_per_kgs is zero: no gas is made, only the air of the pores pushes");
  EXPECT_EQ(
      warnings(k_all, {{"material = \"dough\"", "material = \"dough\"\nleavener = 0"}}),
      "effects lists leavening, which cannot matter: leavener is zero in every body: no gas is made, only the air of the pores pushes");
  EXPECT_EQ(
      warnings(k_unleavened, {k_no_leavener, k_no_exchange}),
      "effects lists heat, which cannot matter: no heat_transfer_coefficient_W_per_m2K is above zero and everything starts equally warm");
}

TEST(Doubts, DoNotConcernHeatThatLeaveningNeedsOrWhereAnythingIsWarmer) {
  EXPECT_EQ(warnings(k_all, {k_no_exchange}), "");
  EXPECT_EQ(warnings(k_unleavened, {k_no_leavener, {"W_per_m2K = 25", "W_per_m2K = [[0, 0], [9, 3]]"}}), "");
  const std::string body = "[[body]]\nmaterial = \"dough\"\ntemperature_C = 5\nshape = { sphere = { radius_m = 0.1 } }\n";
  EXPECT_EQ(warnings(k_unleavened, {k_no_leavener, k_no_exchange}, body), "");
  const std::string tray =
      "[[collider]]\nname = \"tray\"\nheat_transfer_coefficient_W_per_m2K = 3\nshape = { half_space = { normal = [0, 0, 1] } }\n";
  EXPECT_EQ(warnings(k_unleavened, {k_no_leavener, k_no_exchange}, tray + "temperature_C = 180\n"), "");
  EXPECT_NE(warnings(k_unleavened, {k_no_leavener, k_no_exchange}, tray), "");  // it passes no heat
}

TEST(Doubts, NameATemperatureThatNothingHas) {
  const std::string body = "[[body]]\nmaterial = \"dough\"\ntemperature_C = 5\nshape = { sphere = { radius_m = 0.1 } }\n";
  const std::string said = "body.1.temperature_C is given, but effects does not list heat: it has that of its material";
  EXPECT_NE(warnings(R"("motion", "elasticity", "water")", {k_no_leavener}, body).find(said), std::string::npos);
  EXPECT_EQ(warnings(k_unleavened, {k_no_leavener}, body).find(said), std::string::npos);
}

TEST(Doubts, NameASurfaceThatIsNotKept) {
  const std::string kept = "[surface]\nkeep_dx = 0.02\n", said = "surface.keep_dx is given, but surface.form is published";
  EXPECT_EQ(warnings(k_all, {}, kept + "form = 'published'\n").find(said), 0U);
  EXPECT_EQ(warnings(k_all, {}, kept), "");
}

TEST(Doubts, NameMotionOfWhatNothingMoves) {
  const std::string still = "effects lists motion, which cannot matter: there is no gravity, nothing else moves and nothing swells";
  const std::string press = "[[collider]]\nname = \"press\"\nshape = { half_space = { normal = [0, 0, 1] } }\n";
  const auto is_still = [&](const Edits& edits, const std::string& tables = "") {
    return warnings(R"("motion", "elasticity")", edits, tables).find(still) != std::string::npos;
  };
  EXPECT_TRUE(is_still({k_no_gravity}));
  EXPECT_TRUE(is_still({k_no_gravity}, press));
  EXPECT_FALSE(is_still({}));
  EXPECT_FALSE(is_still({k_no_gravity}, press + "motion = [ { time_s = 0 }, { time_s = 1, position_m = [0, 0, 0.1] } ]\n"));
  EXPECT_FALSE(is_still({k_no_gravity, {"radius_m = 0.1 } }", "radius_m = 0.1 } }\nangular_velocity_rad_per_s = [0, 0, 1]"}}));
}

TEST(Doubts, NameAnEffectThatIsMissing) {
  EXPECT_EQ(warnings(R"("heat", "water")"),
            "material.dough.young_modulus_Pa is given, but effects does not list elasticity; material.dough.yield_stress_Pa is given, but "
            "effects does not list plasticity; material.dough.production_mol_per_kgs is given, but effects does not list leavening");
  EXPECT_EQ(warnings(R"("motion", "elasticity", "plasticity", "heat", "leavening")"),
            "material.dough.diffusivity_m2_per_sK is given, but effects does not list water");
  EXPECT_EQ(warnings(R"("motion", "elasticity", "plasticity", "water")", {k_no_leavener}),
            "material.dough.specific_heat_J_per_kgK is given, but effects does not list heat");
}

TEST(Doubts, DoNotConcernAMaterialThatNothingIsMadeOf) {
  const std::string chip =
      "[[material]]\nname = \"chip\"\ndensity_kg_per_m3 = 9\nyoung_modulus_Pa = 1\nyield_stress_Pa = 1\n"
      "specific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\nproduction_mol_per_kgs = 1\n";
  EXPECT_EQ(warnings(k_unleavened, {k_no_leavener}, chip), "");
  EXPECT_NE(warnings(k_unleavened, {k_no_leavener, {"material = \"dough\"", "material = \"chip\""}}, chip), "");
}

}  // namespace
}  // namespace bake::test

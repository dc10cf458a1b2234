// SPDX-License-Identifier: MIT
// Dough whose properties or deformation are far outside what anybody bakes. Each case must end with finite numbers, closed books and no
// energy from nowhere (energy.h).
#include "solver/effects/fields.h"
#include "tests/stability/cruel.h"

namespace bake {
namespace {

/// The material of a baking dough with some keys given other values.
std::string changed(std::initializer_list<std::pair<const char*, const char*>> keys) { return Dough::changed(keys, Dough::moving_water()); }

/// Dropped on a floor below in a hot oven, for 0.3 s: it falls for 0.2 s, lands and is baked.
Dough dropped(const std::string& material, const std::string& precision = "double") {
  Dough dough = small(k_everything);
  dough.precision = precision;
  dough.material = material;
  dough.shape = "sphere = { centre_m = [0.01, 0.02, -0.5], radius_m = 0.3 }";
  dough.tables = R"([oven]
temperature_C = 200
heat_transfer_coefficient_W_per_m2K = 500
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.9], normal = [0, 0, 1] } }
friction = 0.3
temperature_C = 200
heat_transfer_coefficient_W_per_m2K = 500
)";
  return dough;
}

void expect_endured(const Dough& dough) {
  Watched dropped(dough);
  ASSERT_NO_FATAL_FAILURE(dropped.run(0.3));
  EXPECT_EQ(dropped.now().limited, 0) << "a node owed water";
}

class CruelDough : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(In, CruelDough, testing::Values("double", "single"), [](const auto& info) { return std::string(info.param); });

TEST_P(CruelDough, AHundredTimesStiffer) { expect_endured(dropped(changed({{"young_modulus_Pa", "2e6"}}), GetParam())); }
TEST_P(CruelDough, WithoutYieldStress) { expect_endured(dropped(changed({{"yield_stress_Pa", "0"}}), GetParam())); }
TEST_P(CruelDough, WithoutViscosity) { expect_endured(dropped(changed({{"viscosity_Pa_s", "0"}}), GetParam())); }
TEST_P(CruelDough, WithNeither) { expect_endured(dropped(changed({{"yield_stress_Pa", "0"}, {"viscosity_Pa_s", "0"}}), GetParam())); }
TEST_P(CruelDough, TooViscousToFlow) { expect_endured(dropped(changed({{"viscosity_Pa_s", "1e15"}}), GetParam())); }
TEST_P(CruelDough, AlmostWithoutPores) {
  expect_endured(dropped(changed({{"initial_porosity", "1e-4"}, {"production_mol_per_kgs", "0"}}), GetParam()));
}
TEST_P(CruelDough, AlmostAllPores) {
  expect_endured(dropped(changed({{"initial_porosity", "0.999"}, {"initial_saturation", "0"}}), GetParam()));
}
TEST_P(CruelDough, WithAHundredTimesTheLeavener) { expect_endured(dropped(changed({{"production_mol_per_kgs", "30"}}), GetParam())); }
TEST_P(CruelDough, ThatHoldsMoreWaterThanItShould) {
  Dough dough = dropped(changed({}), GetParam());
  dough.body = "saturation = 0.8";  // the material's own is 0.2, and all else is pore
  expect_endured(dough);
}
TEST_P(CruelDough, AThousandTimesLessDenseThanItsNeighbour) {
  Dough dough = dropped(changed({}), GetParam());
  dough.shape = "sphere = { centre_m = [0.01, 0.02, -0.6], radius_m = 0.25 }";
  dough.tables += "[[material]]\nname = \"foam\"\n" + changed({{"density_kg_per_m3", "0.5"}, {"initial_saturation", "0"}}) +
                  "[[body]]\nmaterial = \"foam\"\nparticles_per_cell = 8\n"
                  "shape = { sphere = { centre_m = [0.01, 0.02, -0.1], radius_m = 0.25 } }\n";
  expect_endured(dough);
}

class Conduction : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(By, Conduction, testing::Values("forward_euler", "backward_euler"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(Conduction, AThousandTimesFaster) {
  Dough dough = dropped(changed({{"conductivity_W_per_mK", "1e5"}}));
  dough.heat += std::string("\ntolerance = 1e-12\nintegrator = \"") + GetParam() + "\"";
  Watched dropped(dough);
  ASSERT_NO_FATAL_FAILURE(dropped.run(0.05));
  const double cold = -dropped->highest(highest::coldness), hot = dropped->highest(highest::temperature);
  EXPECT_LE(hot - cold, 5) << "it conducts so well that it is of one temperature";
  EXPECT_LE(hot, 200);
  EXPECT_GE(cold, 20);
}

/// Pulled or pressed between two grips to `ratio` of its length, each at 1 m/s.
void expect_deformed(double ratio, const char* precision) {
  Dough dough("motion, elasticity, plasticity");
  dough.precision = precision;
  dough.dx = 0.03125;
  dough.frame_s = 0.02;
  dough.material = changed({});
  const double length = ratio < 1 ? 1.2 : 0.18, travel = length * (ratio - 1) / 2, time = std::abs(travel);
  dough.shape = fmt::format("box = {{ half_extents_m = [{}, 0.08, 0.08] }}", length / 2);
  for (const int side : {-1, 1})
    dough.tables += fmt::format(
        "[[grip]]\nshape = {{ box = {{ centre_m = [{}, 0, 0], half_extents_m = [0.02, 0.3, 0.3] }} }}\n"
        "motion = [{{ time_s = 0 }}, {{ time_s = {}, position_m = [{}, 0, 0] }}]\n",
        side * (length / 2 - 0.02), time, side * travel);
  Watched bar(dough);
  ASSERT_NO_FATAL_FAILURE(bar.run(time, 1));
  const Snapshot end = bar.particles();
  const auto along = [](const Vector3& a, const Vector3& b) { return a[0] < b[0]; };
  const auto [first, last] = std::minmax_element(end.position.begin(), end.position.end(), along);
  EXPECT_NEAR((*last)[0] - (*first)[0], ratio * length, 2 * dough.dx);
}
TEST_P(CruelDough, PulledToTenTimesItsLength) { expect_deformed(10, GetParam()); }
TEST_P(CruelDough, PressedToATenthOfItsLength) { expect_deformed(0.1, GetParam()); }

/// The ball flows as v = rate r until its J is `ratio`; then it is left to itself.
void expect_let_go(double ratio, const char* precision) {
  Dough dough(k_everything);
  dough.precision = precision;
  dough.dx = 0.125;
  dough.frame_s = 0.02;
  dough.shape = "sphere = { radius_m = 0.3 }";
  dough.material = changed({});
  dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 100\n";
  const double rate = ratio > 1 ? 2 : -2, time = std::log(ratio) / (3 * rate);
  Watched ball(dough);
  ball->set_force([=](const Point& x, const Vector3&, double, double) { return rate * x; });
  ASSERT_TRUE(ball->advance(time, time + 0.02));
  const Snapshot held = ball.particles();
  for (const double J : held[field::VolumeRatio::name]) ASSERT_NEAR(std::log(J), std::log(ratio), 0.05);
  ball->set_force([](const Point&, const Vector3& v, double, double) { return v; });
  ball.watch_from_now();
  ASSERT_NO_FATAL_FAILURE(ball.run(time + 0.2));
}
TEST_P(CruelDough, StretchedToTenTimesItsVolume) { expect_let_go(10, GetParam()); }
TEST_P(CruelDough, SqueezedToATenthOfItsVolume) { expect_let_go(0.1, GetParam()); }

/// Walls close from six sides upon what is nearly all pore.
TEST_P(CruelDough, BetweenClosingWalls) {
  Dough dough("motion, elasticity, plasticity");
  dough.precision = GetParam();
  dough.material = changed({{"initial_porosity", "0.92"}});
  dough.frame_s = 0.02;
  dough.shape = "box = { half_extents_m = [0.4, 0.4, 0.4] }";
  const double travel = 0.42 - 0.4 * std::cbrt(0.1), time = 0.5;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      const auto along = [&](double by) {
        Vector3 v{0, 0, 0};
        v[axis] = by;
        return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
      };
      dough.tables += fmt::format(
          "[[collider]]\nshape = {{ half_space = {{ point_m = {}, normal = {} }} }}\n"
          "motion = [{{ time_s = 0 }}, {{ time_s = {}, position_m = {} }}]\n",
          along(side * 0.42), along(-side), time, along(-side * travel));
    }
  Watched block(dough);
  ASSERT_NO_FATAL_FAILURE(block.run(time, travel / time));
  EXPECT_LT(block.now().volume, 0.25 * block.start().volume) << "else it was not squeezed; a layer of a cell at the walls stays looser";
}

// A particle whose stencil just touches a node gives it next to no mass; what it takes back must not be noise.
TEST(ANodeOfAlmostNoMass, GivesNobodyASpeed) {
  for (const double at : {0.5, 0.5 + 1e-9, 0.5 - 1e-9, 0.5 + 1e-15}) {  // in cells: where a node joins the stencil
    Dough dough(k_everything);
    dough.dx = 0.125;
    dough.frame_s = 1e-3;
    dough.material = Dough::properties(Dough::moving_water());
    dough.body = "jitter = 0\nvelocity_m_per_s = [1, 0, 0]";
    dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 100\n";
    dough.shape = fmt::format("box = {{ centre_m = [{:.17g}, 0.01, 0.02], half_extents_m = [0.2, 0.2, 0.2] }}", at * dough.dx);
    Watched block(dough);
    ASSERT_NO_FATAL_FAILURE(block.run(0.05));
    for (const Vector3& v : block.particles().velocity) EXPECT_LT(length(v - Vector3{1, 0, 0}), 1);
  }
}

TEST_P(CruelDough, AsAFilmUnderAKnife) {
  Dough dough = small();
  dough.dx = 0.0625;
  dough.effects = "motion, elasticity, plasticity";
  dough.precision = GetParam();
  dough.material = changed({});
  dough.shape = "box = { centre_m = [0, 0, -0.87], half_extents_m = [0.4, 0.4, 0.03] }";  // one cell thick, on a floor
  dough.tables = R"([[collider]]
shape = { half_space = { point_m = [0, 0, -0.9], normal = [0, 0, 1] } }
contact = "sticky"
[[collider]]
shape = { box = { centre_m = [0, 0, -0.5], half_extents_m = [0.01, 0.6, 0.3] } }
expels = true
motion = [{ time_s = 0 }, { time_s = 0.1, position_m = [0, 0, -0.1] }, { time_s = 0.2 }]
)";
  Watched film(dough);
  ASSERT_NO_FATAL_FAILURE(film.run(0.3, 1));
}

}  // namespace
}  // namespace bake

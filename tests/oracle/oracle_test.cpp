// SPDX-License-Identifier: MIT
// The solver against the textbook baker, which is plain loops over a dense grid and shares no code with it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "reference/compare/side_by_side.h"
#include "solver/effects/common.h"
#include "solver/scene/scene_builder.h"
#include "tests/oracle/scenes.h"

namespace bake {

namespace {

std::string table(const std::vector<FieldDifference>& differences) {
  std::string text;
  for (const FieldDifference& d : differences)
    text += fmt::format("{:<12} {:.2e} of {:.3g}, relative {:.1e}\n", d.field, d.largest, d.scale, d.relative());
  return text;
}

void expect_agreement(SideBySide& both, int steps, double bound) {
  while (both.solver().counters().steps < steps) ASSERT_TRUE(both.step());
  const auto differences = both.differences();
  EXPECT_LE(worst(differences), bound) << "after " << steps << " steps:\n" << table(differences);
}

/// Double: the sums of both run in different orders; the worst of these scenes is 5e-14 after one step and 1e-12 after a hundred.
constexpr double k_agreement = 1e-11;

/// Single: in each pass a number goes through about 64 roundings (weights, at most 64 terms of a gather, as many of a scatter, the
/// quotient), each of half an epsilon, all taken with the same sign. A run of n steps has n + 1 passes.
constexpr double single_agreement(int steps) { return (steps + 1) * 32 * 1.19e-7; }

class Oracle : public testing::TestWithParam<RandomScene> {
  void SetUp() override { omp_set_num_threads(1); }  // a few hundred particles: more would wait for each other
};
class OracleInSingle : public Oracle {};
class OracleAtRest : public Oracle {};
class OracleInMotion : public Oracle {};

TEST_P(Oracle, AgreesWithTheTextbook) {
  SideBySide both(GetParam().scene());
  for (const int steps : {1, 100}) expect_agreement(both, steps, k_agreement);
}

TEST_P(OracleInSingle, AgreesWithTheTextbookForAStep) {
  RandomScene single = GetParam();
  single.precision = "single";
  SideBySide both(single.scene());
  expect_agreement(both, 1, single_agreement(1));
}

/// One particle of hot gas with open pores, which its own memory opens until it fills the room of its nodes.
TEST(ACrumb, AgreesWithTheTextbookWhenItFillsTheRoomOfItsNodes) {
  omp_set_num_threads(1);
  SceneBuilder builder;
  builder.effects = "motion, heat, elasticity, plasticity, leavening";
  builder.low = {0, 0, 0};
  builder.frame_s = 1000;
  builder.motion = "inertia_scale = 4";
  builder.leavening = "reference_pressure_Pa = 4000\npores = \"open\"";
  builder.material =
      "density_kg_per_m3 = 500\nyoung_modulus_Pa = 4e4\ninitial_porosity = 0.5\ninitial_temperature_C = 20\nspecific_heat_J_per_kgK = 20\n"
      "conductivity_W_per_mK = 100\nyield_stress_Pa = 1\n";
  builder.shape = "box = { centre_m = [0.52, 0.52, 0.52], half_extents_m = [0.02, 0.02, 0.02] }";
  builder.body = "temperature_C = 95";
  SideBySide both(builder.scene());
  const double room = std::pow(0.1 * 20 / 11, 3);
  while (both.solver().total(total::volume) < room * (1 - 1e-9)) {
    ASSERT_LT(both.solver().counters().steps, 5000) << "it opens no more";
    ASSERT_TRUE(both.step());
  }
  const auto differences = both.differences();
  // round-off grows with the strain of the solid, which is a ten-thousandth
  EXPECT_LE(worst(differences), 1e-9) << table(differences);
  EXPECT_EQ(both.solver().particles(), 1U);
}

/// Diffusion forgets round-off.
TEST_P(OracleAtRest, AgreesWithTheTextbookForAHundredSteps) {
  RandomScene single = GetParam();
  single.precision = "single";
  SideBySide both(single.scene());
  expect_agreement(both, 100, single_agreement(100));
}

/// Motion does not: yielding and touching make it grow, a hundredfold in some of these scenes. How much it grows is measured on a twin of
/// the textbook whose particles are rounded to single before every step, once where the solver rounds about 64 times (see above): as long
/// as errors grow in proportion, the solver in single comes no further from the textbook than 64 times as far as its twin. (Measured over
/// all scenes of this file: 0.2 to 43 times as far, and never further than 4e-4.)
TEST_P(OracleInMotion, InSingleStaysWithinRoundOffAsTheTextbookAmplifiesIt) {
  RandomScene single = GetParam();
  single.precision = "single";
  SideBySide both(single.scene(), true);
  while (both.solver().counters().steps < 100) ASSERT_TRUE(both.step());
  const auto twin = both.differences_of_twin(), solver = both.differences();
  EXPECT_LE(worst(solver), 64 * worst(twin)) << "solver:\n" << table(solver) << "twin:\n" << table(twin);
}

std::string name(const testing::TestParamInfo<RandomScene>& info) { return info.param.name; }

std::string words_of(std::string effects) {
  std::string words;
  for (const char c : effects)
    if (c != ' ') words += c == ',' ? '_' : c;
  return words;
}

/// Every combination of effects that is compiled (solver/engine/model_list.h), with both kernels.
std::vector<RandomScene> every_model() {
  const std::vector<std::string> effects = {"heat",
                                            "water",
                                            "heat, water",
                                            "motion, elasticity",
                                            "motion, heat, elasticity",
                                            "motion, water, elasticity",
                                            "motion, heat, water, elasticity",
                                            "motion, elasticity, plasticity",
                                            "motion, heat, elasticity, plasticity",
                                            "motion, water, elasticity, plasticity",
                                            "motion, heat, water, elasticity, plasticity",
                                            "motion, heat, elasticity, plasticity, leavening",
                                            k_everything};
  const std::vector<std::string> with_flip = {"motion, elasticity", "motion, elasticity, plasticity", k_everything};
  std::vector<RandomScene> all;
  for (const std::string kernel : {"quadratic", "cubic"}) {
    for (const std::string& e : effects)
      all.push_back({.name = words_of(e) + "_" + kernel, .effects = e, .kernel = kernel, .seed = static_cast<int>(all.size())});
    for (const std::string& e : with_flip)
      all.push_back({.name = words_of(e) + "_flip_" + kernel,
                     .effects = e,
                     .kernel = kernel,
                     .motion = "transfer = \"flip\"",
                     .seed = static_cast<int>(all.size())});
  }
  return all;
}

constexpr const char* k_knife = R"(
[[collider]]
shape = { box = { centre_m = [0.023, 0.011, 0.317], half_extents_m = [0.031, 0.3, 0.3] } }
expels = true
friction = 0.2
motion = [{ time_s = 0 }, { time_s = 0.1, position_m = [0, 0, -0.3] }]
)";

/// Whatever comes and goes, holds and is held; in the model of everything. No node lies as deep below one side of a box as below
/// another: which normal it gets would be round-off's choice.
std::vector<RandomScene> every_boundary() {
  const std::string held = R"(
[[grip]]
shape = { sphere = { centre_m = [-0.07, 0.03, 0.12], radius_m = 0.11 } }
motion = [{ time_s = 0 }, { time_s = 0.5, position_m = [0.1, 0, 0.2], rotation_deg = [20, 0, 0] }]
temperature_C = 50
)";
  const std::string poured = R"(
[[emitter]]
material = "dough"
shape = { sphere = { centre_m = [0.31, 0.33, 0.32], radius_m = 0.09 } }
velocity_m_per_s = [-1, -9, -1]
temperature_C = 40
saturation = 0.1
)";
  const std::string gone = R"(
[[collider]]
shape = { box = { centre_m = [0.0213, 0.0127, 0.1931], half_extents_m = [0.3, 0.3, 0.11] } }
contact = "slip"
friction = 0.3
until_s = 0.01
[[collider]]
shape = { box = { centre_m = [0.0213, 0.0127, -0.1831], half_extents_m = [0.3, 0.3, 0.09] } }
contact = "slip"
covers = false
from_s = 0.02
)";
  const std::string hot_faces = R"(
[[face]]
at = "x_max"
temperature_C = [[0, 90], [1, 300]]
heat_transfer_coefficient_W_per_m2K = 400
[[face]]
at = "y_min"
temperature_C = 150
[[face]]
at = "z_max"
heat_flux_W_per_m2 = 3e3
)";
  const std::string between_plates = R"(
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.2131], normal = [0, 0, 1] } }
contact = "sticky"
temperature_C = 180
heat_transfer_coefficient_W_per_m2K = 200
[[collider]]
shape = { half_space = { point_m = [0, 0, 0.3571], normal = [0, 0, -1] } }
friction = 0.5
motion = [{ time_s = 0 }, { time_s = 1, position_m = [3, 0, -1] }]
[[face]]
at = "z_min"
temperature_C = 150
)";
  const std::string ring = "x_min = \"periodic\"\nx_max = \"periodic\"\ny_min = \"periodic\"\ny_max = \"periodic\"";
  std::vector<RandomScene> all;
  for (const std::string kernel : {"quadratic", "cubic"})
    for (RandomScene r : std::vector<RandomScene>{
             {.name = "hot_faces", .tables = hot_faces, .gravity = "[150, -100, 50]"},
             {.name = "hot_faces_backward_euler",
             .heat = "integrator = \"backward_euler\"",
             .tables = hot_faces,
             .gravity = "[150, -100, 50]"},
             {.name = "periodic", .tables = between_plates, .gravity = "[150, -100, -20]", .faces = ring, .colliders = false},
             {.name = "periodic_backward_euler",
             .heat = "integrator = \"backward_euler\"",
             .tables = between_plates,
             .gravity = "[150, -100, -20]",
             .faces = ring,
             .colliders = false},
             {.name = "periodic_published_surface",
             .surface = "form = \"published\"",
             .gravity = "[150, -100, -20]",
             .faces = ring,
             .colliders = false},
             {.name = "cut", .tables = k_knife},
             {.name = "held", .tables = held},
             {.name = "held_backward_euler", .heat = "integrator = \"backward_euler\"", .tables = held},
             {.name = "poured", .tables = poured},
             {.name = "gone", .tables = gone},
             {.name = "thirteen_cells", .gravity = "[150, 150, 150]", .far_corner = {0.7, 0.7, 0.7}},
             {.name = "fourteen_cells", .gravity = "[150, 150, 150]", .far_corner = {0.8, 0.8, 0.8}},
             {.name = "fifteen_cells", .gravity = "[150, 150, 150]", .far_corner = {0.9, 0.9, 0.9}},
             {.name = "ramped_gravity", .gravity = "[[0.001, [0, 50, 0]], [0.012, [150, -100, 50]], [0.02, [-100, 0, -50]]]"},
             {.name = "hurled_at_walls", .gravity = "[150, -100, 50]"},
             {.name = "hurled_through_open_faces", .gravity = "[150, -100, 50]", .faces = "x_max = \"open\"\nz_max = \"open\""},
         }) {
      r.name += "_" + kernel;
      r.kernel = kernel;
      r.effects = k_everything;
      r.seed = static_cast<int>(200 + all.size());
      all.push_back(r);
    }
  return all;
}

/// Skins on bodies, in every combination of effects in which something moves, and with what moves into them.
std::vector<RandomScene> every_skin() {
  const std::string skins = R"(
[[skin]]
body = 0
young_modulus_Pa = 2e5
thickness_m = 0.03
density_kg_per_m3 = 300
permeance = 0.3
[[skin]]
body = [1, 2]
only = { half_space = { point_m = [0, 0, 0.08], normal = [0.2, 0.1, 1] } }
young_modulus_Pa = 1e5
poisson_ratio = 0.1
thickness_m = 0.02
density_kg_per_m3 = 2000
)";
  std::vector<RandomScene> all;
  for (RandomScene r : every_model())
    if (r.effects.find("motion") != std::string::npos && r.motion.empty()) {
      r.tables = skins;
      all.push_back(r);
    }
  for (RandomScene r : std::vector<RandomScene>{{.name = "pic", .motion = "transfer = \"pic\""},
                                                {.name = "heavy", .motion = "inertia_scale = 50"},
                                                {.name = "backward_euler", .heat = "integrator = \"backward_euler\""},
                                                // A knife presses vertices onto its face. Where a triangle is folded flat over the next
                                                // one, the angle of the hinge is pi or -pi: round-off's choice. With this seed none is.
                                                {.name = "cut", .tables = k_knife},
                                                {.name = "ramped_gravity", .gravity = "[[0.001, [0, 50, 0]], [0.012, [150, -100, 50]]]"}}) {
    r.effects = k_everything;
    r.tables += skins;
    all.push_back(r);
  }
  // From 300 on one of them parts from the textbook within one step (the 38th, velocities by 1 %), in single precision only: that is no
  // growth of round-off, but a decision that hangs on a last digit.
  for (RandomScene& r : all) r.name += "_in_a_skin", r.seed = static_cast<int>(400 + (&r - all.data()));
  return all;
}

/// Every form of every equation, in the model of everything, with both kernels.
std::vector<RandomScene> every_form() {
  const std::vector<RandomScene> forms = {
      {.name = "pic", .motion = "transfer = \"pic\""},
      {.name = "little_flip", .motion = "transfer = \"flip\"\nflip_blend = 0.3"},
      {.name = "heavy", .motion = "inertia_scale = 50"},
      {.name = "backward_euler", .heat = "integrator = \"backward_euler\""},
      {.name = "published_exchange", .heat = "heat_transfer_form = \"published\""},
      {.name = "published_exchange_backward_euler", .heat = "heat_transfer_form = \"published\"\nintegrator = \"backward_euler\""},
      {.name = "published_expansion", .heat = "expansion_form = \"published\""},
      {.name = "latent_heat", .water = "latent_heat_J_per_kg = 2e3"},
      {.name = "published_water", .water = "form = \"published\""},
      {.name = "published_water_heavy", .motion = "inertia_scale = 3", .water = "form = \"published\""},
      {.name = "quadratic_norm",
       .plasticity = "norm = \"quadratic\"",
       .material = "yield_stress_Pa = [200, 200, 150, 400]\nviscosity_Pa_s = [1e6, 1e6, 5e5, 5e5]"},
      {.name = "without_viscosity", .material = "yield_stress_Pa = [200, 200, 150, 400]"},
      {.name = "published_porosity", .plasticity = "porosity_form = \"published\""},
      {.name = "published_leavening", .leavening = "form = \"published\""},
      {.name = "soft_pores", .leavening = "reference_pressure_Pa = 4000"},
      {.name = "open_pores", .leavening = "reference_pressure_Pa = 4000\npores = \"open\""},
      {.name = "finite_leavener", .material = "leavener_mol_per_m3 = 3"},
      {.name = "published_surface", .surface = "form = \"published\""},
  };
  std::vector<RandomScene> all;
  for (const std::string kernel : {"quadratic", "cubic"})
    for (RandomScene r : forms) {
      r.name += "_" + kernel;
      r.kernel = kernel;
      r.effects = k_everything;
      r.seed = static_cast<int>(100 + all.size());
      all.push_back(r);
    }
  return all;
}

/// What the paper does not have: latent heat of melting, dough without pores, and vapour in pores.
std::vector<RandomScene> every_addition() {
  const std::string melts = "transition_heat_J_per_kg = 500\ntransition_from_C = 20\ntransition_to_C = 22";
  const std::string vapour = "vapour_diffusivity_m2_per_s = 5\nvapour_transfer_m_per_s = 10\nhygroscopic_water_kg_per_kg = 0.3";
  const std::string latent = "latent_heat_J_per_kg = 2e3";
  return {{.name = "melting", .effects = k_everything, .material = melts, .seed = 300},
          {.name = "vapour_at_rest", .effects = "heat, water", .water = latent, .material = vapour, .seed = 303},
          {.name = "vapour_at_rest_cubic", .effects = "heat, water", .kernel = "cubic", .water = latent, .material = vapour, .seed = 304},
          {.name = "vapour", .effects = k_everything, .water = latent, .material = vapour, .seed = 305},
          {.name = "vapour_published_surface",
           .effects = k_everything,
           .kernel = "cubic",
           .water = latent,
           .surface = "form = \"published\"",
           .material = vapour,
           .seed = 306},
          {.name = "melting_backward_euler",
           .effects = k_everything,
           .heat = "integrator = \"backward_euler\"",
           .material = melts,
           .seed = 301},
          {.name = "never_porous",
           .effects = "motion, heat, elasticity, plasticity",
           .material = "yield_stress_Pa = [200, 50, 50, 400]",
           .overrides = {"material.0.initial_porosity=1e-7", "material.1.initial_porosity=1e-7"},
           .seed = 302}};
}

std::vector<RandomScene> every_scene() {
  std::vector<RandomScene> all = every_model();
  for (const auto& more : {every_form(), every_boundary(), every_skin(), every_addition()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<RandomScene> at_rest() {
  std::vector<RandomScene> all;
  for (const RandomScene& r : every_model())
    if (r.effects.find("motion") == std::string::npos) all.push_back(r);
  return all;
}

/// Whatever moves; at the boundaries with cubic kernels, which amplify most.
std::vector<RandomScene> in_motion() {
  std::vector<RandomScene> all;
  for (const auto& scenes : {every_model(), every_boundary(), every_skin()})
    for (const RandomScene& r : scenes)
      if (r.effects.find("motion") != std::string::npos && (r.effects != k_everything || r.kernel == "cubic")) all.push_back(r);
  return all;
}

INSTANTIATE_TEST_SUITE_P(, Oracle, testing::ValuesIn(every_scene()), name);
INSTANTIATE_TEST_SUITE_P(, OracleInSingle, testing::ValuesIn(every_scene()), name);
INSTANTIATE_TEST_SUITE_P(, OracleAtRest, testing::ValuesIn(at_rest()), name);
INSTANTIATE_TEST_SUITE_P(, OracleInMotion, testing::ValuesIn(in_motion()), name);

}  // namespace

}  // namespace bake

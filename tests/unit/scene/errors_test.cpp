// SPDX-License-Identifier: MIT
// One line for each class of mistake.
#include <fmt/format.h>

#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

const std::string k_dough = "[[material]]\nname = \"dough\"\ndensity_kg_per_m3 = 500\n";  // lines 9 to 11 after k_least
const std::string k_ball = "shape = { sphere = { radius_m = 0.1 } }\n";

TEST(SceneError, WrongTypeNamesWhatWasFoundAndWhatIsAllowed) {
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = \"soon\"")),
            "bread.toml:2: run.end_s: found \"soon\", allowed: a number above 0");
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = true")), "bread.toml:2: run.end_s: found true, allowed: a number above 0");
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = 1979-05-27")),
            "bread.toml:2: run.end_s: found a date or time, allowed: a number above 0");
  EXPECT_EQ(error_of("title = 3\n" + k_least), "bread.toml:1: title: found 3, allowed: text in quotes");
  EXPECT_EQ(error_of(replaced(k_least, "[0, 0, 0]", "[0, 0]")),
            "bread.toml:6: domain.min_m: found a list of 2, allowed: [x, y, z], each any finite number");
  EXPECT_EQ(error_of(replaced(k_least, "[0, 0, 0]", "[0, \"a\", 0]")),
            "bread.toml:6: domain.min_m.1: found \"a\", allowed: any finite number");
  EXPECT_EQ(error_of("run = 3\n"), "bread.toml:1: run: found 3, allowed: a table");
  EXPECT_EQ(error_of(k_least + "[material]\nname = \"a\"\n"), "bread.toml:9: material: found a table, allowed: tables under [[material]]");
  EXPECT_EQ(error_of("material = [3]\n" + k_least), "bread.toml:1: material.0: found 3, allowed: a table");
}

TEST(SceneError, WholeNumbersMustBeWhole) {
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = 2\nseed = 1.5")),
            "bread.toml:3: run.seed: found 1.5, allowed: a whole number of at least 0");
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = 2\nseed = 3000000000")),
            "bread.toml:3: run.seed: found 3000000000, allowed: a whole number of at least 0, up to 2147483647");
}

TEST(SceneError, OutOfRangeIsRefusedAndSoIsNan) {
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = -5")), "bread.toml:2: run.end_s: found -5, allowed: a number above 0");
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = nan")), "bread.toml:2: run.end_s: found nan, allowed: a number above 0");
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2", "end_s = inf")), "bread.toml:2: run.end_s: found inf, allowed: a number above 0");
  EXPECT_EQ(error_of(k_least + "[oven]\ntemperature_C = -300\n"),
            "bread.toml:10: oven.temperature_C: found -300, allowed: a temperature above -273.15 degrees Celsius, "
            "or [[time_s, value], ...] with rising times");
}

TEST(SceneError, MissingRequiredKeyPointsAtItsTable) {
  EXPECT_EQ(error_of(replaced(k_least, "end_s = 2\n", "")), "bread.toml:1: run.end_s: missing, allowed: a number above 0");
  EXPECT_EQ(error_of("title = \"x\"\n"), "bread.toml:1: run.end_s: missing, allowed: a number above 0");
  EXPECT_EQ(error_of(""), "bread.toml:1: run.end_s: missing, allowed: a number above 0");
  EXPECT_EQ(error_of(k_least + "[[material]]\nname = \"dough\"\n"),
            "bread.toml:9: material.dough.density_kg_per_m3: missing, allowed: a number above 0");
  EXPECT_EQ(error_of("effects = [\"motion\", \"elasticity\"]\n" + k_least + k_dough),
            "bread.toml:10: material.dough.young_modulus_Pa: missing, allowed: a number above 0");
}

TEST(SceneError, UnknownKeyComesWithTheNearestOne) {
  EXPECT_EQ(error_of(k_least + k_dough + "yuong_modulus_Pa = 1\n"),
            "bread.toml:12: material.dough: unknown key 'yuong_modulus_Pa', did you mean 'young_modulus_Pa'?");
  EXPECT_EQ(error_of(k_least + "[ovn]\n"), "bread.toml:9: unknown key 'ovn', did you mean 'oven'?");
  EXPECT_EQ(error_of(replaced(k_least, "dx_m", "dx")), "bread.toml:4: grid: unknown key 'dx', did you mean 'dx_m'?");
  EXPECT_EQ(error_of(k_least + "[surface]\ncolour = 1\n"), "bread.toml:10: surface: unknown key 'colour', allowed: form, keep_dx");
  EXPECT_EQ(error_of(k_least + "[elasticity]\na = 1\n"), "bread.toml:10: elasticity: unknown key 'a', allowed: none");
}

TEST(SceneError, UnknownChoiceComesWithTheNearestOne) {
  EXPECT_EQ(error_of(replaced(k_least, "dx_m = 0.01", "dx_m = 0.01\nkernel = \"qadratic\"")),
            "bread.toml:5: grid.kernel: unknown name 'qadratic', did you mean 'quadratic'?");
  EXPECT_EQ(error_of(replaced(k_least, "dx_m = 0.01", "dx_m = 0.01\nkernel = 3")),
            "bread.toml:5: grid.kernel: found 3, allowed: \"quadratic\", \"cubic\"");
}

TEST(SceneError, MalformedTomlNamesLineAndColumn) {
  const std::string message = error_of("[run]\nend_s = = 2\n");
  EXPECT_EQ(message.rfind("bread.toml:2:9: no valid TOML: ", 0), 0u) << message;
  const std::string twice = error_of("[run]\nend_s = 2\nend_s = 3\n");
  EXPECT_EQ(twice.rfind("bread.toml:3:", 0), 0u) << twice;
}

TEST(SceneError, EffectsMustBeKnownSingleAndComplete) {
  EXPECT_EQ(error_of("effects = [\"motoin\"]\n" + k_least), "bread.toml:1: effects.0: unknown name 'motoin', did you mean 'motion'?");
  EXPECT_EQ(error_of("effects = [\"heat\", \"heat\"]\n" + k_least),
            "bread.toml:1: effects.1: found 'heat' again, allowed: each effect once");
  EXPECT_EQ(error_of("effects = \"heat\"\n" + k_least), "bread.toml:1: effects: found \"heat\", allowed: a list of effects in quotes");
  EXPECT_EQ(error_of("effects = [\"elasticity\"]\n" + k_least), "bread.toml:1: effects: 'elasticity' needs 'motion'");
  EXPECT_EQ(error_of("effects = [\"motion\", \"plasticity\"]\n" + k_least), "bread.toml:1: effects: 'plasticity' needs 'elasticity'");
  EXPECT_EQ(error_of("effects = [\"motion\", \"heat\", \"leavening\"]\n" + k_least),
            "bread.toml:1: effects: 'leavening' needs 'plasticity'");
  EXPECT_EQ(error_of("effects = [\"motion\", \"elasticity\", \"plasticity\", \"leavening\"]\n" + k_least),
            "bread.toml:1: effects: 'leavening' needs 'heat'");
}

TEST(SceneError, GravityIsAVectorOrACurveOfVectors) {
  const auto error = [](const std::string& gravity) { return error_of(k_least + "[motion]\ngravity_m_per_s2 = " + gravity + "\n"); };
  const std::string place = "bread.toml:10: motion.gravity_m_per_s2";
  const std::string allowed = "allowed: [x, y, z], each any finite number, or [[time_s, [x, y, z]], ...] with rising times";
  EXPECT_EQ(error("-9.81"), place + ": found -9.81, " + allowed);
  EXPECT_EQ(error("[0, -9.81]"), place + ": found a list of 2, " + allowed);
  EXPECT_EQ(error("[]"), place + ": found a list of 0, " + allowed);
  EXPECT_EQ(error("[0, 0, \"down\"]"), place + ".2: found \"down\", allowed: any finite number");
  EXPECT_EQ(error("[[0, 0, -9.81]]"), place + ".0: found a list of 3, allowed: a pair [time_s, [x, y, z]]");
  EXPECT_EQ(error("[[0, -9.81]]"), place + ".0.1: found -9.81, allowed: [x, y, z], each any finite number");
  EXPECT_EQ(error("[[1, [0, 0, 0]], [0.5, [0, 0, -9.81]]]"), place + ".1: found time 0.5 after time 1, allowed: rising times");
}

TEST(SceneError, DoughThatFallsMustNotCountAsStill) {
  const auto error = [](const std::string& keys) { return error_of(k_least + "[motion]\n" + keys + "\n"); };
  EXPECT_EQ(error("settle_damping_per_s = 20\nsettle_still_m_per_s = 0.3"),
            "bread.toml:11: motion.settle_still_m_per_s: found 0.3, allowed: at most 0.245 (gravity over twice settle_damping_per_s), or "
            "dough that falls counts as still");
  for (const char* right : {"settle_damping_per_s = 20\nsettle_still_m_per_s = 0.2", "settle_still_m_per_s = 3",
                            "settle_damping_per_s = 20\nsettle_still_m_per_s = 0.3\ngravity_m_per_s2 = [0, 0, 0]"})
    EXPECT_NO_THROW(parse(k_least + "[motion]\n" + right + "\n")) << right;
  EXPECT_EQ(error("settle_damping = 20"), "bread.toml:10: motion: unknown key 'settle_damping', did you mean 'settle_damping_per_s'?");
}

TEST(SceneError, CurvesMustRiseInTime) {
  EXPECT_EQ(error_of(k_least + "[oven]\ntemperature_C = [[0, 20],\n [0, 30]]\n"),
            "bread.toml:11: oven.temperature_C.1: found time 0 after time 0, allowed: rising times");
  EXPECT_EQ(error_of(k_least + "[oven]\ntemperature_C = [[0, 20, 3]]\n"),
            "bread.toml:10: oven.temperature_C.0: found a list of 3, allowed: a pair [time_s, value]");
  EXPECT_EQ(error_of(k_least + "[oven]\nheat_transfer_coefficient_W_per_m2K = [[0, -1]]\n"),
            "bread.toml:10: oven.heat_transfer_coefficient_W_per_m2K.0.1: found -1, allowed: a number of at least 0");
  EXPECT_NE(error_of(k_least + "[oven]\ntemperature_C = []\n").find("found a list of 0"), std::string::npos);
}

TEST(SceneError, DomainMustHaveVolume) {
  EXPECT_EQ(error_of(replaced(k_least, "[1, 1, 1]", "[1, 0, 1]")),
            "bread.toml:7: domain.max_m: found y = 0, allowed: a number above 0 (min_m)");
}

TEST(SceneError, DomainMustHaveCellsThatCanBeCounted) {
  EXPECT_EQ(error_of(replaced(k_least, "[1, 1, 1]", "[1, 1e10, 1]")),
            "bread.toml:7: domain.max_m: found 1e+12 cells along y, allowed: 1e-06 to 1e+09");
  EXPECT_NE(error_of(replaced(k_least, "dx_m = 0.01", "dx_m = 1e300")).find("found 1e-300 cells along x"), std::string::npos);
  EXPECT_NE(error_of(replaced(replaced(k_least, "[0, 0, 0]", "[0, 0, -1e308]"), "[1, 1, 1]", "[1, 1, 1e308]")).find("cells along z"),
            std::string::npos);
}

TEST(SceneError, StepBoundsMustNotCross) {
  EXPECT_EQ(error_of(k_least + "[time]\nlargest_step_s = 1e-3\nsmallest_step_s = 1\n"),
            "bread.toml:11: time.smallest_step_s: found 1, allowed: at most largest_step_s = 0.001");
}

TEST(SceneError, MaterialTemperaturesMustRise) {
  EXPECT_EQ(error_of(k_least + k_dough + "temperatures_C = [4, 20, 20, 85]\n"),
            "bread.toml:12: material.dough.temperatures_C.2: found 20 after 20, allowed: rising numbers");
}

TEST(SceneError, ATransitionNeedsARangeOfTemperatures) {
  EXPECT_EQ(error_of(k_least + k_dough + "transition_heat_J_per_kg = 5\ntransition_from_C = 30\ntransition_to_C = 30\n"),
            "bread.toml:14: material.dough.transition_to_C: found 30 after 30, allowed: rising numbers");
}

TEST(SceneError, OneNumberCannotBeFourRisingTemperatures) {
  EXPECT_EQ(error_of(k_least + k_dough + "temperatures_C = 20\n"),
            "bread.toml:12: material.dough.temperatures_C: found 20 after 20, allowed: rising numbers");
}

TEST(SceneError, MaterialsMustHaveNamesOfTheirOwn) {
  EXPECT_EQ(error_of(k_least + k_dough + k_dough), "bread.toml:13: material.dough.name: found 'dough' again, allowed: a name of its own");
  EXPECT_EQ(error_of(k_least + replaced(k_dough, "\"dough\"", "\"\"")), "bread.toml:10: material.0.name: found \"\", allowed: a name");
}

TEST(SceneError, MaterialsMustHoldMoreThanTheirWater) {
  EXPECT_EQ(error_of("effects = [\"water\"]\n" + k_least + k_dough + "initial_saturation = 0.5\n"),
            "bread.toml:13: material.dough.initial_saturation: found 500 kg/m^3 of water in a mixture of 500 kg/m^3, "
            "allowed: less water than mixture");
}

TEST(SceneError, VapourNeedsTheHeatThatItCarries) {
  const std::string water = "effects = [\"water\", \"heat\"]\n" + k_least;
  const std::string latent = "[water]\nlatent_heat_J_per_kg = 2e6\n";
  const std::string dough = k_dough + "specific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  const std::string vapour = "vapour_diffusivity_m2_per_s = 2e-5\n", pores = "initial_porosity = 0.5\n";
  const std::string place = "material.dough.vapour_diffusivity_m2_per_s: found ";
  EXPECT_NO_THROW(parse(water + latent + dough + pores + vapour));
  EXPECT_EQ(error_of(water + dough + pores + vapour),
            "bread.toml:16: " + place + "beside water.latent_heat_J_per_kg = 0, allowed: above 0 (water: 2.3e6)");
  EXPECT_EQ(error_of(water + latent + "form = \"published\"\n" + dough + pores + vapour),
            "bread.toml:19: " + place + "beside water.form = 'published', allowed: beside the standard form");
  EXPECT_EQ(error_of(water + latent + "[heat]\nintegrator = \"backward_euler\"\n" + dough + pores + vapour),
            "bread.toml:20: " + place + "beside heat.integrator = 'backward_euler', allowed: beside 'forward_euler'");
  EXPECT_EQ(error_of("effects = [\"water\"]\n" + k_least + latent + k_dough + pores + vapour),
            "bread.toml:16: " + place + "without the effect heat, allowed: with it, since vapour carries heat");
  EXPECT_EQ(error_of(water + latent + dough + pores + "vapour_transfer_m_per_s = 1\n"),
            "bread.toml:18: material.dough.vapour_transfer_m_per_s: found without vapour_diffusivity_m2_per_s, allowed: with it, above 0");
}

TEST(SceneError, WaterAndGasMustNotFillMoreThanTheVolume) {
  EXPECT_EQ(error_of("effects = [\"water\"]\n" + k_least + k_dough + "initial_porosity = 0.7\ninitial_saturation = 0.4\n"),
            "bread.toml:14: material.dough.initial_saturation: found 0.4 of the volume water and 0.7 gas (initial_porosity), "
            "allowed: together at most 1");
  EXPECT_EQ(error_of(k_least + k_dough + "initial_porosity = 0.7\n[[body]]\nmaterial = \"dough\"\nsaturation = 0.5\n" + k_ball),
            "bread.toml:15: body.0.saturation: found 0.5 of the volume water and 0.7 gas (the material's initial_porosity), "
            "allowed: together at most 1");
}

TEST(SceneError, BodyNeedsAKnownMaterial) {
  EXPECT_EQ(error_of(k_least + k_dough + "[[body]]\nmaterial = \"duogh\"\n" + k_ball),
            "bread.toml:13: body.0.material: unknown material 'duogh', did you mean 'dough'?");
  EXPECT_EQ(error_of(k_least + "[[body]]\nmaterial = \"dough\"\n" + k_ball),
            "bread.toml:10: body.0.material: unknown material 'dough', allowed: none");
}

TEST(SceneError, BodyIsEitherAShapeOrAFile) {
  const std::string body = k_least + k_dough + "[[body]]\nmaterial = \"dough\"\n";
  EXPECT_EQ(error_of(body), "bread.toml:12: body.0: found neither shape nor particles_file, allowed: one of them");
  EXPECT_EQ(error_of(body + k_ball + "particles_file = \"a.h5\"\n"),
            "bread.toml:12: body.0: found both shape and particles_file, allowed: one of them");
}

TEST(SceneError, BodyMustEndSomewhere) {
  EXPECT_EQ(error_of(k_least + k_dough + "[[body]]\nmaterial = \"dough\"\nshape = { half_space = {} }\n"),
            "bread.toml:14: body.0.shape: found a shape without end, allowed: a bounded one (cut it with an intersection)");
  const std::string body = k_least + k_dough + "[[body]]\nmaterial = \"dough\"\nshape = ";
  for (const std::string shape :
       {"{ union = [{ half_space = {} }, { sphere = { radius_m = 1 } }] }",
        "{ difference = [{ half_space = {} }, { sphere = { radius_m = 1 } }] }",
        "{ intersection = [{ half_space = {} }, { half_space = { normal = [0, 0, -1] } }] }",
        "{ box = { half_extents_m = [1, 1e308, 1] } }", "{ sphere = { radius_m = 1 }, rotate_deg = [1e300, 0, 0] }",
        "{ sphere = { radius_m = 1e200 }, scale = 1e200 }"})
    EXPECT_NE(error_of(body + shape + "\n").find("body.0.shape: found a shape without end"), std::string::npos) << shape;
}

TEST(SceneError, KeyframesMustRiseInTime) {
  EXPECT_EQ(error_of(k_least + "[[collider]]\nname = \"pin\"\n" + k_ball + "motion = [{time_s = 1},\n{time_s = 0.5}]\n"),
            "bread.toml:13: collider.pin.motion.1: found 0.5 after 1, allowed: rising numbers");
  EXPECT_EQ(error_of(k_least + "[[grip]]\n" + k_ball + "motion = [{time_s = 1}, {time_s = 1}]\n"),
            "bread.toml:11: grip.0.motion.1: found 1 after 1, allowed: rising numbers");
  EXPECT_EQ(error_of(k_least + "[[grip]]\n" + k_ball + "motion = [{}]\n"),
            "bread.toml:11: grip.0.motion.0.time_s: missing, allowed: any finite number");
}

TEST(SceneError, ScenesSoFarAwayThatPositionsAreRoundedAreRefused) {
  const auto at = [](const char* low, const char* high) {
    return fmt::format("effects = [\"motion\"]\n[run]\nend_s = 1\n[grid]\ndx_m = 0.001\n[domain]\nmin_m = [{}, 0, 0]\nmax_m = [{}, 1, 1]\n",
                       low, high);
  };
  EXPECT_NE(error_of(at("1e10", "10000000001.0"))
                .find("bread.toml:8: domain.max_m: found x from 1e+10 to 1e+10 m in cells of 0.001 m, allowed: up to 4.5e+08 m"),
            std::string::npos)
      << error_of(at("1e10", "10000000001.0"));
  EXPECT_EQ(parse(at("1e8", "100000001.0")).domain.min_m[0], 1e8);
}

TEST(SceneError, AHotColliderCovers) {
  EXPECT_EQ(
      error_of(k_least + "[[collider]]\n" + k_ball + "temperature_C = 180\nheat_transfer_coefficient_W_per_m2K = 10\ncovers = false\n"),
      "bread.toml:13: collider.0.covers: found false with temperature_C, allowed: true, since heat passes where it covers");
}

TEST(SceneError, TimesOfPresenceMustNotCross) {
  EXPECT_EQ(error_of(k_least + "[[grip]]\n" + k_ball + "from_s = 2\nuntil_s = 2\n"),
            "bread.toml:12: grip.0.until_s: found from_s = 2 and until_s = 2, allowed: from_s before until_s");
  EXPECT_NE(error_of(k_least + "[[collider]]\n" + k_ball + "from_s = inf\n").find("bread.toml:11: collider.0.from_s: found"),
            std::string::npos);
}

TEST(SceneError, EmitterMustPour) {
  const std::string emitter = k_least + k_dough + "[[emitter]]\nmaterial = \"dough\"\n" + k_ball;
  EXPECT_EQ(error_of(emitter + "velocity_m_per_s = [0, 0.0, 0]\n"),
            "bread.toml:15: emitter.0.velocity_m_per_s: found [0, 0, 0], allowed: a velocity that is not zero");
  EXPECT_EQ(error_of(emitter), "bread.toml:12: emitter.0.velocity_m_per_s: missing, allowed: [x, y, z], each any finite number");
  EXPECT_NE(error_of(emitter + "velocity_m_per_s = [0, 0, 1]\nfrom_s = -1\n").find("emitter.0.from_s: found -1, allowed: 0 or later"),
            std::string::npos);
  EXPECT_NE(error_of(emitter + "velocity_m_per_s = [0, 0, 1]\nuntil_s = -1\n").find("emitter.0.until_s: found from_s = 0"),
            std::string::npos);
  EXPECT_EQ(error_of("effects = []\n" + emitter + "velocity_m_per_s = [0, 0, 1]\n"),
            "bread.toml:13: emitter.0: found an emitter without the effect 'motion', allowed: with it");
}

TEST(SceneError, DotsOfNumbersAreNoStepsOfAKey) {
  std::string curve = "[[-0.0, 20.5]";
  for (int i = 1; i < 4000; ++i) curve += fmt::format(", [{}.0, +2.0e-1]", i);
  EXPECT_EQ(parse(k_least + "[oven]\ntemperature_C = " + curve + "]\n").oven.temperature_C.points.size(), 4000u);
  std::string key = "1.2";
  for (int i = 0; i < 4000; ++i) key += " .3.4";
  EXPECT_NE(error_of("\n" + key + " = 1\n").find("found more than 1500 dots outside of numbers"), std::string::npos);
}

TEST(SceneError, EndlessKeysAndNestingDoNotExhaustTheStack) {
  std::string key, tables, lists(100000, '[');
  for (int i = 0; i < 100000; ++i) key += "a.", tables += "{a=";
  EXPECT_EQ(error_of("\n" + key + "b = 1\n"),
            "bread.toml:2: found more than 1500 dots outside of numbers in one line, allowed: shorter lines");
  EXPECT_EQ(error_of("\n[" + key + "b]\n"),
            "bread.toml:2: found more than 1500 dots outside of numbers in one line, allowed: shorter lines");
  EXPECT_NE(error_of("a = " + lists).find("no valid TOML"), std::string::npos);
  EXPECT_NE(error_of("a = " + tables).find("no valid TOML"), std::string::npos);
  EXPECT_NE(error_of(k_least, {key + "b=1"}).find("found 100001 names, allowed: at most 100"), std::string::npos);
  EXPECT_NE(error_of(k_least, {"a={" + key + "b=1}"}).find("allowed: a TOML value or one word"), std::string::npos);

  const std::string legal_key = key.substr(0, 3000);
  EXPECT_NE(error_of("[" + legal_key + "b]\n" + legal_key + "b = 1\n").find("unknown key 'a'"), std::string::npos);
}

TEST(SceneError, OpenPoresNeedAnAtmosphere) {
  const std::string open = k_least + "[leavening]\npores = \"open\"\n";
  EXPECT_EQ(error_of(open + "form = \"published\"\n"),
            "bread.toml:10: leavening.pores: found \"open\", allowed: \"closed\" with form = \"published\", which knows no atmosphere");
  EXPECT_EQ(error_of(replaced(open, "open", "opne")), "bread.toml:10: leavening.pores: unknown name 'opne', did you mean 'open'?");
}

TEST(SceneError, TextOfTheUserStaysOnOneLineAndShort) {
  const std::string message = error_of(replaced(k_least, "end_s = 2", "end_s = \"a\\nb" + std::string(1000, 'x') + "\""));
  EXPECT_LT(message.size(), 200u);
  error_of("\"a\\nb\" = 1\n" + k_least);
  error_of(k_least + replaced(k_dough, "dough", "a\\nb") + "[[body]]\nmaterial = \"a b\"\n" + k_ball);
}

}  // namespace
}  // namespace bake::test

// SPDX-License-Identifier: MIT
// Cruel scenes end with finite numbers and closed books, or with an error that names particle, quantity and step.
#include <gtest/gtest.h>

#include "tests/stability/cruel.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

TEST(AStepAskedForFarTooLarge, IsCutToWhatIsStable) {
  Dough dough = small();
  dough.effects = k_everything;
  dough.dt = 10;
  dough.tables = "[time]\nlargest_step_s = 1e3\n[oven]\ntemperature_C = 100\nexchange_W_per_m2K = 100\n";
  const auto s = dough.begin();
  const Sums start(*s);
  ASSERT_TRUE(s->advance(0.3, 10));
  EXPECT_LT(s->dt(), 0.02);
  expect_finite(*s);
  expect_closed_books(*s, start);
}

TEST(AStepBelowTheSmallestAllowed, EndsTheRunWithTheReason) {
  Dough dough = small();
  dough.tables = "[time]\nsmallest_step_s = 0.5\n";
  dough.dt = 10;
  try {
    dough.begin();
    FAIL() << "nothing was thrown";
  } catch (const RunError& error) {
    const std::string message = error.what();
    for (const char* part : {"stiffness", "time.smallest_step_s", "step 0"}) EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

/// Writes the checkpoint of a run again with one number of one particle replaced.
template <class Real>
void poison(const std::filesystem::path& from, const std::filesystem::path& to, Precision precision, std::size_t index, Real value) {
  const CheckpointReader in(from);
  CheckpointWriter out(to, "poisoned", precision);
  for (const char* name : {"blocks", "tiles"}) {
    const auto values = in.array<std::int32_t>(name);
    out.add(name, std::span<const std::int32_t>(values));
  }
  auto particles = in.array<Real>("particles");
  particles.at(index) = value;
  out.add("particles", std::span<const Real>(particles));
  const auto grid = in.array<Real>("grid");
  out.add("grid", std::span<const Real>(grid));
  for (const char* name : {"numbers", "booked", "totals", "retired", "emitted"}) {
    const auto values = in.array<double>(name);
    out.add(name, std::span<const double>(values));
  }
  for (const char* name : {"counts", "poured"}) {
    const auto values = in.array<std::int64_t>(name);
    out.add(name, std::span<const std::int64_t>(values));
  }
  out.commit();
}

/// The checkpoint of a scene's first 0.02 s.
void save_one_frame(const Scene& scene, const std::filesystem::path& file) {
  const auto s = Simulation::begin(scene);
  ASSERT_TRUE(s->advance(0.02, 0.04));
  CheckpointWriter out(file, "good", scene.run.precision);
  s->write(out);
  out.commit();
}

template <class Real>
void expect_named(const char* precision, int column, const char* name) {
  Dough dough = small();
  dough.effects = k_everything;
  dough.precision = precision;
  const Scene scene = dough.scene();
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(save_one_frame(scene, folder / "good.h5"));
  constexpr int W = k_width<Real>;
  const auto columns = static_cast<std::size_t>(make_physics<Real>(scene)->column_count);
  // lane 0 of the third tile
  poison<Real>(folder / "good.h5", folder / "bad.h5", scene.run.precision, (2 * columns + static_cast<std::size_t>(column)) * W,
               std::numeric_limits<Real>::quiet_NaN());
  const auto sick = Simulation::resume(scene, CheckpointReader(folder / "bad.h5"));
  const auto steps = sick->counters().steps;
  try {
    sick->advance(0.04, 0.06);
    FAIL() << "nothing was thrown";
  } catch (const RunError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("particle "), 0u) << message;
    EXPECT_NE(message.find(std::string(name) + " is not finite in step " + std::to_string(steps)), std::string::npos) << message;
  }
}

TEST(ANumberThatIsNone, IsFoundInTheSameStepAndItsParticleAndQuantityAreNamed) {
  const auto physics = make_physics<double>([] {
    Dough dough;
    dough.effects = k_everything;
    return dough.scene();
  }());
  for (const char* name : {"volume_ratio", "temperature", "water_mass", "elastic_strain", "produced_gas"})
    for (const auto& column : physics->columns)
      if (column.name == name) {
        expect_named<float>("single", column.first, name);
        expect_named<double>("double", column.first, name);
      }
}

TEST(ACheckpoint, WithAParticleNowhereIsRefused) {
  Dough dough = small();
  const Scene scene = dough.scene();
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(save_one_frame(scene, folder / "good.h5"));
  for (const double nowhere : {std::numeric_limits<double>::quiet_NaN(), -3.0, 1e9}) {
    poison<double>(folder / "good.h5", folder / "bad.h5", scene.run.precision, k_position_column * k_width<double>, nowhere);
    EXPECT_THROW(Simulation::resume(scene, CheckpointReader(folder / "bad.h5")), InputError);
  }
}

TEST(StiffPores, AreStableAndFreeOfStressAtTheStart) {
  Dough dough = small();
  dough.effects = k_everything;
  dough.gravity = "[0, 0, 0]";
  dough.material = Dough::properties();
  const auto change = [&](const std::string& from, const char* to) { dough.material.replace(dough.material.find(from), from.size(), to); };
  change("initial_porosity = 0.2", "initial_porosity = 0.01");
  change("production_mol_per_kgs = 0.3", "");
  dough.tables = "[leavening]\nreference_pressure_Pa = 101325\n";
  dough.dt = 1;
  const auto s = dough.begin();
  EXPECT_TRUE(s->advance(0.01, 1));
  EXPECT_GT(s->counters().steps, 20);  // 1e5 Pa over 1 % of pores: 1e7 Pa
  expect_finite(*s);
  EXPECT_LT(Sums(*s).kinetic, 1e-6 * Sums(*s).mass());
}

TEST(DoughThrownAtAClosedFaceAtAThousandMetresPerSecond, StaysInsideAndItsBooksAreClosed) {
  for (const char* precision : {"double", "single"}) {
    Dough dough = small();
    dough.precision = precision;
    dough.body = "velocity_m_per_s = [1000, 0, 0]";
    dough.dt = 1e-3;
    const auto s = dough.begin();
    const Sums start(*s);
    const std::size_t particles = s->particles();
    try {
      s->advance(2e-3, 3e-3);
      expect_finite(*s);
      EXPECT_EQ(s->particles(), particles);
      const Sums now(*s);
      const double tolerance = static_cast<double>(s->counters().steps) * round_off(precision) * start.mass() * 1000;
      EXPECT_NEAR(now.momentum[0], start.momentum[0] + now.impulse[0], tolerance);
      EXPECT_LE(now.kinetic + now.elastic, 1.05 * start.kinetic) << "energy came from nowhere";
    } catch (const RunError& error) {
      EXPECT_EQ(std::string(error.what()).find("particle "), 0u) << error.what();
    }
  }
}

TEST(AnEmptyScene, GoesOnDoingNothing) {
  const Scene scene = parse_scene(R"(
effects = ["motion", "heat", "water", "elasticity", "plasticity", "leavening"]
[run]
end_s = 1
[grid]
dx_m = 0.1
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 1]
)",
                                  "empty.toml", {});
  const auto s = Simulation::begin(scene);
  EXPECT_TRUE(s->advance(0.5, 1));
  EXPECT_EQ(s->particles(), 0u);
  for (const double x : s->ledger_row()) EXPECT_TRUE(std::isfinite(x));
  EXPECT_TRUE(s->snapshot().id.empty());
}

TEST(DoughPouredIntoAnEmptyScene, DoesNotFallThroughAFloorCloseBy) {
  Dough dough = small();
  dough.ball = "sphere = { centre_m = [0, 0, 0], radius_m = 1e-6 }";  // nobody
  dough.tables = R"([[emitter]]
material = "dough"
shape = { box = { half_extents_m = [0.3, 0.3, 0.2] } }
velocity_m_per_s = [0, 0, -6]
from_s = 0.1
until_s = 0.11
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.35], normal = [0, 0, 1] } }
)";
  dough.dt = 10;
  const auto s = dough.begin();
  ASSERT_TRUE(s->advance(0.5, 10));
  EXPECT_GT(s->particles(), 0u);
  expect_finite(*s);
  // a stop in the floor within a cell or so: travel per step is bounded by 0.3 dx
  for (const Vector3& x : s->snapshot().position) EXPECT_GT(x[2], -0.35 - 0.125);
}

TEST(BodiesThatOverlap, PushEachOtherApartAndKeepTheirBooks) {
  Dough dough = small();
  dough.effects = k_everything;
  dough.tables =
      "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\nshape = { sphere = { centre_m = [0.2, 0, 0], radius_m = 0.3 } }\n";
  const auto s = dough.begin();
  const Sums start(*s);
  EXPECT_TRUE(s->advance(0.2, 0.3));
  expect_finite(*s);
  expect_closed_books(*s, start);
}

Dough lonely(const std::string& effects) {
  Dough dough = small();
  dough.effects = effects;
  dough.material = Dough::properties(Dough::moving_water());
  dough.tables = "[oven]\ntemperature_C = 100\nexchange_W_per_m2K = 100\n";
  // one point of the lattice, spacing dx / 2, lies in the middle of a box no larger than a spacing
  dough.ball = "box = { centre_m = [0.01, 0.02, 0.03], half_extents_m = [0.03, 0.03, 0.03] }";
  return dough;
}

TEST(ALonelyParticle, FallsAndBakesAndIsKept) {
  for (const char* effects : {"motion, elasticity", k_everything}) {
    const auto s = lonely(effects).begin();
    ASSERT_EQ(s->particles(), 1u);
    const Sums start(*s);
    EXPECT_TRUE(s->advance(0.3, 0.4));
    expect_finite(*s);
    expect_closed_books(*s, start);
    EXPECT_NEAR(s->snapshot().velocity[0][2], -9.81 * 0.3, 1e-9);
  }
}

TEST(TwoParticlesAtOnePlace, MoveAsOne) {
  for (const char* effects : {"motion, elasticity", k_everything}) {
    Dough dough = lonely(effects);
    dough.body = "jitter = 0";
    dough.tables += "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\njitter = 0\nshape = { " + dough.ball + " }\n";
    const auto s = dough.begin();
    ASSERT_EQ(s->particles(), 2u);
    const Sums start(*s);
    EXPECT_TRUE(s->advance(0.3, 0.4));
    expect_finite(*s);
    expect_closed_books(*s, start);
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(s->snapshot().position[0][d], s->snapshot().position[1][d], 1e-12);
  }
}

TEST(OneOrSixtyFourParticlesPerCell, AreNoSpecialCase) {
  for (const char* many : {"1", "64"}) {
    Dough dough = small();
    dough.effects = k_everything;
    dough.ball = "sphere = { centre_m = [0, 0, -0.6], radius_m = 0.3 }";
    std::string text = dough.text();
    text.replace(text.find("particles_per_cell = 8"), 22, std::string("particles_per_cell = ") + many);
    const auto s = Simulation::begin(parse_scene(text, "dough.toml", {}));
    const Sums start(*s);
    EXPECT_TRUE(s->advance(0.2, 0.3));
    expect_finite(*s);
    expect_closed_books(*s, start);
    EXPECT_NEAR(start.solid, 300 * 4 / 3. * M_PI * 0.027, 0.2 * start.solid);  // 1 per cell: about 58 particles
  }
}

TEST(AllWater, CanEvaporateAndNoneIsOwed) {
  for (const char* effects : {"heat, water", k_everything}) {
    Dough dough = small();
    dough.effects = effects;
    dough.gravity = "[0, 0, 0]";
    dough.material = Dough::properties("diffusivity_m2_per_sK = 2e-3\nevaporation_kg_per_m2sK = 50");
    dough.tables = "[oven]\ntemperature_C = 100\nexchange_W_per_m2K = 100\n";
    const auto s = dough.begin();
    const Sums start(*s);
    EXPECT_TRUE(s->advance(1, 2));
    expect_finite(*s);
    expect_closed_books(*s, start);
    EXPECT_LT(Sums(*s).water, 0.2 * start.water);
    const Snapshot now = s->snapshot();
    for (const double m : now["water_mass"]) ASSERT_GE(m, 0);
  }
}

TEST(ABodyOutsideTheDomain, IsRefusedBeforeTheRun) {
  Dough dough = small();
  dough.ball = "sphere = { centre_m = [0.9, 0, 0], radius_m = 0.3 }";
  try {
    dough.begin();
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("lies outside the domain, allowed: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(ADoughHeatedFromTheFreezerTo400DegreesInOneFrame, StaysFinite) {
  Dough dough = small();
  dough.effects = k_everything;
  dough.body = "temperature_C = -20";
  dough.tables = "[oven]\ntemperature_C = 400\nexchange_W_per_m2K = 1e5\n";
  const auto s = dough.begin();
  const Sums start(*s);
  EXPECT_TRUE(s->advance(0.04, 0.08));
  expect_finite(*s);
  expect_closed_books(*s, start);
  EXPECT_LE(s->temperatures().second, 400 + 1e-6);
}

TEST(APressThatClosesFasterThanSound, EndsInAnErrorOrInFiniteNumbers) {
  Dough dough = small();
  dough.effects = "motion, elasticity, plasticity";
  dough.tables = R"([[collider]]
shape = { box = { centre_m = [0, 0, 0.5], half_extents_m = [0.5, 0.5, 0.1] } }
motion = [{ time_s = 0 }, { time_s = 0.02, position_m = [0, 0, -1.1] }]
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.4], normal = [0, 0, 1] } }
)";
  const auto s = dough.begin();
  const std::size_t particles = s->particles();
  try {
    s->advance(0.03, 0.04);
    expect_finite(*s);
    EXPECT_EQ(s->particles(), particles);
  } catch (const RunError& error) {
    EXPECT_EQ(std::string(error.what()).find("particle "), 0u) << error.what();
  }
}

}  // namespace
}  // namespace bake

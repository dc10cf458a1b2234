// SPDX-License-Identifier: MIT
// Cruel scenes end with finite numbers and closed books, or with an error that names particle, quantity and step.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <regex>

#include "solver/effects/elasticity.h"
#include "solver/engine/engine.h"
#include "solver/run/fill_scene.h"
#include "tests/stability/cruel.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

TEST(AStepAskedForFarTooLarge, IsCutToWhatIsStable) {
  Dough dough = small(k_everything);
  dough.frame_s = 10;
  dough.tables = "[time]\nlargest_step_s = 1e3\n[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 100\n";
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.3));
  EXPECT_LT(ball->dt(), 0.02);
}

TEST(AStepBelowTheSmallestAllowed, EndsTheRunWithTheReason) {
  Dough dough = small();
  dough.tables = "[time]\nsmallest_step_s = 0.5\n";
  dough.frame_s = 10;
  const std::string message = message_of<RunError>([&] { dough.begin(); });
  for (const char* part : {"stiffness", "time.smallest_step_s", "step 0"}) EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(AStepOfAbsurdlyStiffDough, EndsTheRunInsteadOfCrawling) {
  Dough dough = small();
  dough.material = Dough::changed({{"young_modulus_Pa", "1e30"}});
  const std::string message = message_of<RunError>([&] { Watched(dough).run(0.01); });
  for (const char* part : {"stiffness", "below time.smallest_step_s = "}) EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(AStepByWhichTimeDoesNotAdvance, EndsTheRunWithTheReason) {
  Dough dough = small();
  dough.tables =
      "[[collider]]\nshape = { half_space = { point_m = [0, 0, -0.9] } }\n"
      "motion = [{ time_s = 0 }, { time_s = 1e-5, position_m = [1e300, 0, 0] }]\n";
  const std::string message = message_of<RunError>([&] { Watched(dough).run(0.01); });
  for (const char* part : {"particle travel", "time does not advance"}) EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(AColliderWithoutEndThatTurns, LimitsTheStepByItsSpeedInTheDomain) {
  Dough dough = small();
  dough.tables =
      "[[collider]]\nshape = { half_space = { point_m = [0, 0, -0.9] } }\n"
      "motion = [{ time_s = 0 }, { time_s = 0.1, rotation_deg = [0, 0, 1] }]\n";
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.01));
  EXPECT_GT(ball->dt(), 1e-5);
}

/// Writes the checkpoint of a run again, with checksums that match. `spoil(name, values)` may change each array.
template <class Real, class Spoil>
void rewrite(const std::filesystem::path& from, const std::filesystem::path& to, Precision precision, Spoil spoil) {
  const CheckpointReader in(from);
  CheckpointWriter out(to, "poisoned", precision);
  const auto copy = [&]<class T>(const char* name, T) {
    auto values = in.array<T>(name);
    spoil(std::string(name), values);
    out.add(name, std::span<const T>(values));
  };
  for (const char* name : {"blocks", "tiles"}) copy(name, std::int32_t{});
  for (const char* name : {"particles", "grid"}) copy(name, Real{});
  for (const char* name : {"numbers", "bounds", "highest", "booked", "totals", "retired", "emitted"}) copy(name, double{});
  for (const char* name : {"counts", "poured"}) copy(name, std::int64_t{});
  out.commit();
}

/// ... with one number of one particle replaced.
template <class Real>
void poison(const std::filesystem::path& from, const std::filesystem::path& to, Precision precision, std::size_t index, Real value) {
  rewrite<Real>(from, to, precision, [&]<class T>(const std::string& name, std::vector<T>& values) {
    if (name == "particles") values.at(index) = static_cast<T>(value);
  });
}

/// The checkpoint of a scene's first 0.02 s.
void save_one_frame(const Scene& scene, const std::filesystem::path& file) {
  const auto s = Simulation::begin(scene);
  ASSERT_TRUE(s->advance(0.02, 0.04));
  CheckpointWriter out(file, "good", scene.run.precision);
  s->write(out);
  out.commit();
}

/// Calls visit(column, c) for each component c of every column that a particle keeps, but for its identity: any bits will do.
template <class Real, class Visit>
void for_each_number(const Scene& scene, Visit visit) {
  const auto physics = make_physics<Real>(scene);
  for (const auto& column : physics->columns)
    for (int c = column.first; c < column.first + column.width; ++c)
      if (c != k_identity_column) visit(column, c);
}

template <class Real>
constexpr std::array k_no_numbers{std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()};

/// With FLIP particles keep their velocity as well.
Dough of_everything(const char* precision) {
  Dough dough = small(k_everything);
  dough.precision = precision;
  dough.motion = k_flip;
  return dough;
}

/// Puts what is no number into one particle between two steps: the next one must end with it and name it.
template <class Real>
void expect_named(const char* precision) {
  const Scene scene = of_everything(precision).scene();
  constexpr std::size_t k_tile = 2;
  for_each_number<Real>(scene, [&](const auto& column, int c) {
    if (c < k_position_column + 3) return;  // its nodes would be nowhere: no step begins with such a particle, see below
    for (const Real none : k_no_numbers<Real>) {
      Engine<Real> engine(scene);
      engine.add(fill_bodies(scene));
      engine.start(0.02);
      for (int i = 0; i < 3; ++i) engine.step(0.02, 0.04);
      auto* columns = const_cast<Lanes<Real>*>(engine.store().tile(k_tile));  // the engine lets nobody do that
      columns[c][0] = none;
      const auto id = identity_of<Real>(columns, 0);
      std::string message;
      try {
        for (int i = 0; i < 2; ++i) engine.step(0.02, 0.04);
      } catch (const RunError& error) {
        message = error.what();
      }
      std::string name = column.name;
      if (name == field::PeakTemperature::name && std::isnan(none)) {  // the greater of that and the temperature: is a number again
        EXPECT_EQ(message, "");
        continue;
      }
      if (name == field::Leavener::name) name = field::ProducedGas::name;  // it makes it in the same step, and is named first
      if (name != field::ScatteredWaterMomentum::name)                     // goes to nodes and is forgotten; see below
        EXPECT_TRUE(std::regex_search(message, std::regex(fmt::format("^particle {}: (.*, )?{}(, .*)? not finite in step 3 ", id, name))))
            << name << ": " << message;
      else
        EXPECT_TRUE(std::regex_search(message, std::regex(": position, .* not finite in step 4 "))) << message;
    }
  });
}

TEST(ANumberThatIsNone, IsFoundInTheSameStepAndItsParticleAndQuantityAreNamed) {
  expect_named<float>("single");
  expect_named<double>("double");
}

template <class Real>
void expect_refused(const char* precision) {
  const Scene scene = of_everything(precision).scene();
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(save_one_frame(scene, folder / "good.h5"));
  EXPECT_NO_THROW(Simulation::resume(scene, CheckpointReader(folder / "good.h5")));
  const int columns = make_physics<Real>(scene)->column_count;
  for_each_number<Real>(scene, [&](const auto& column, int c) {
    for (const Real none : k_no_numbers<Real>) {
      const auto at = static_cast<std::size_t>((2 * columns + c) * k_width<Real>);  // lane 0 of the third tile
      poison<Real>(folder / "good.h5", folder / "bad.h5", scene.run.precision, at, none);
      try {
        Simulation::resume(scene, CheckpointReader(folder / "bad.h5"));
        ADD_FAILURE() << column.name << ": nothing was thrown";
      } catch (const InputError& error) {
        if (c >= k_position_column + 3) {  // a particle that is nowhere is refused for that
          EXPECT_NE(std::string(error.what()).find(column.name), std::string::npos) << error.what();
          EXPECT_NE(std::string(error.what()).find("'s particle "), std::string::npos) << error.what();
        }
      }
    }
  });
}

// No step leaves such a particle, so that none of the two numbers that a step forgets can ever be one.
TEST(ACheckpoint, WithANumberThatIsNoneIsRefusedAndItsParticleAndQuantityAreNamed) {
  expect_refused<float>("single");
  expect_refused<double>("double");
}

TEST(ACheckpoint, WithAParticleNowhereIsRefused) {
  Dough dough = small();
  const Scene scene = dough.scene();
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(save_one_frame(scene, folder / "good.h5"));
  for (const double nowhere : {-3.0, 1e9}) {
    poison<double>(folder / "good.h5", folder / "bad.h5", scene.run.precision, k_position_column * k_width<double>, nowhere);
    EXPECT_THROW(Simulation::resume(scene, CheckpointReader(folder / "bad.h5")), InputError);
  }
}

/// Something that is wrong in an array: a number, two numbers in each other's place, or the array's length.
template <class T>
void spoil_at_random(std::vector<T>& values, std::mt19937& random) {
  const auto any = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
  using Limits = std::numeric_limits<T>;
  if (values.empty()) return values.push_back(T(1));
  T& value = values[any(values.size())];
  switch (any(10)) {
    case 0:
      return values.pop_back();
    case 1:
      values.resize(values.size() + (values.size() + 1) / 2);
      return;
    case 2:
      return std::swap(value, values[any(values.size())]);
    case 3:
      value = Limits::max();
      return;
    case 4:
      value = Limits::lowest();
      return;
    case 5:
      value = Limits::has_infinity ? Limits::infinity() : static_cast<T>(1 << 20);
      return;
    case 6:
      value = Limits::has_quiet_NaN ? Limits::quiet_NaN() : static_cast<T>(-1);
      return;
    case 7:
      value = static_cast<T>(value + 1);
      return;
    case 8:
      value = static_cast<T>(value - 1);
      return;
    default:
      value = static_cast<T>(-3 * value + 7);
  }
}

// What is refused is refused as input; what a run could have written, if not this one, is gone on with or ends as a run does.
TEST(ACheckpoint, ThatIsWrongInAnyWayIsRefusedOrAtLeastDoesNoHarm) {
  Dough dough = small();
  dough.faces = "x_max = \"open\"";
  const Scene scene = dough.scene();
  const TemporaryFolder folder;
  ASSERT_NO_FATAL_FAILURE(save_one_frame(scene, folder / "good.h5"));
  std::mt19937 random(2019);
  std::map<std::string, int> refused;
  for (const char* chosen : {"blocks", "tiles", "particles", "grid", "numbers", "bounds", "highest", "booked", "totals", "retired",
                             "emitted", "counts", "poured"})
    for (int i = 0; i < 40; ++i) {
      rewrite<double>(folder / "good.h5", folder / "bad.h5", scene.run.precision,
                      [&]<class T>(const std::string& name, std::vector<T>& values) {
                        if (name == chosen) spoil_at_random(values, random);
                      });
      try {
        const auto s = Simulation::resume(scene, CheckpointReader(folder / "bad.h5"));
        int steps = 0;
        s->advance(s->time() + 0.02, s->time() + 0.04, [&] { return ++steps < 3; });
        s->frame();
      } catch (const InputError&) {
        ++refused[chosen];
      } catch (const RunError&) {
      }
    }
  EXPECT_GT(refused["blocks"], 25);
  EXPECT_GT(refused["tiles"], 20);
  EXPECT_GT(refused["counts"], 20);
  for (const auto& [name, times] : refused) EXPECT_GT(times, 4) << name;
}

TEST(StiffPores, AreStableAndFreeOfStressAtTheStart) {
  Dough dough = small(k_everything);
  dough.gravity = "[0, 0, 0]";
  dough.material = Dough::changed({{"initial_porosity", "0.01"}, {"production_mol_per_kgs", "0"}});
  dough.leavening = "reference_pressure_Pa = 101325";
  dough.frame_s = 1;
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.01));
  EXPECT_GT(ball->counters().steps, 20);  // 1e5 Pa over 1 % of pores: 1e7 Pa
  EXPECT_LT(ball.now().kinetic, 1e-6 * ball.start().mass());
}

TEST(DoughThrownAtAClosedFaceAtAThousandMetresPerSecond, StaysInsideAndItsBooksAreClosed) {
  for (const char* precision : {"double", "single"}) {
    Dough dough = small();
    dough.precision = precision;
    dough.body = "velocity_m_per_s = [1000, 0, 0]";
    dough.frame_s = 1e-3;
    Watched ball(dough);
    const std::size_t particles = ball->particles();
    try {
      ASSERT_NO_FATAL_FAILURE(ball.run(2e-3));
      EXPECT_EQ(ball->particles(), particles);
      EXPECT_LT(ball.now().momentum[0], 0.5 * ball.start().momentum[0]) << "it never met the face";
    } catch (const RunError& error) {
      EXPECT_EQ(std::string(error.what()).find("particle "), 0u) << error.what();
    }
  }
}

TEST(AnEmptyScene, GoesOnDoingNothing) {
  Dough dough(k_everything);
  dough.shape = "";
  const auto s = dough.begin();
  EXPECT_TRUE(s->advance(0.5, 1));
  EXPECT_EQ(s->particles(), 0u);
  for (const double x : ledger_row(*s)) EXPECT_TRUE(std::isfinite(x));
  EXPECT_TRUE(s->snapshot().id.empty());
}

TEST(DoughPouredIntoAnEmptyScene, DoesNotFallThroughAFloorCloseBy) {
  Dough dough = small();
  dough.shape = "";
  dough.tables = R"([[emitter]]
material = "dough"
shape = { box = { half_extents_m = [0.3, 0.3, 0.2] } }
velocity_m_per_s = [0, 0, -6]
from_s = 0.1
until_s = 0.11
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.35], normal = [0, 0, 1] } }
)";
  dough.frame_s = 10;
  const auto s = dough.begin();
  ASSERT_TRUE(s->advance(0.5, 10));
  EXPECT_GT(s->particles(), 0u);
  expect_finite(*s);
  // a stop in the floor within a cell or so: travel per step is bounded by 0.3 dx
  for (const Vector3& x : s->snapshot().position) EXPECT_GT(x[2], -0.35 - 0.125);
}

TEST(BodiesThatOverlap, PushEachOtherApartAndKeepTheirBooks) {
  Dough dough = small(k_everything);
  dough.tables =
      "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\nshape = { sphere = { centre_m = [0.2, 0, 0], radius_m = 0.3 } }\n";
  ASSERT_NO_FATAL_FAILURE(Watched(dough).run(0.2));
}

Dough lonely(const std::string& effects) {
  Dough dough = small(effects);
  dough.material = Dough::properties(Dough::moving_water());
  dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 100\n";
  // one point of the lattice, spacing dx / 2, lies in the middle of a box no larger than a spacing
  dough.shape = "box = { centre_m = [0.01, 0.02, 0.03], half_extents_m = [0.03, 0.03, 0.03] }";
  return dough;
}

TEST(ALonelyParticle, FallsAndBakesAndIsKept) {
  for (const char* effects : {"motion, elasticity", k_everything}) {
    Watched one(lonely(effects));
    ASSERT_EQ(one->particles(), 1u);
    ASSERT_NO_FATAL_FAILURE(one.run(0.3));
    EXPECT_NEAR(one.particles().velocity[0][2], -9.81 * 0.3, 1e-9);
  }
}

/// How far a spinning particle's volume comes from what it was, in two seconds without gravity.
double swelling(const std::string& time) {
  Dough dough = lonely("motion, elasticity");
  dough.material = Dough::changed({{"poisson_ratio", "0.49"}, {"initial_porosity", "1e-6"}});
  dough.gravity = "[0, 0, 0]";
  dough.body = "angular_velocity_rad_per_s = [0.3, 0.2, 0.1]";
  dough.tables = "[time]\n" + time;
  const Scene scene = dough.scene();
  const auto one = Simulation::begin(scene);
  EXPECT_EQ(one->particles(), 1u);
  double most = 0;
  one->advance(2, 3, [&] {
    for (const auto& [name, values] : one->snapshot().columns)
      if (name == field::VolumeRatio::name) most = std::max(most, std::abs(values[0] - 1));
    return most < 0.5;
  });
  return most;
}

/// It vibrates faster than a cell's waves, by sqrt(12 K / rho) / dx, which is stable for a safety below 1 / sqrt(3) only where K is nearly
/// all of its stiffness: the step has a limit of its own for it.
TEST(ALonelyParticle, VibratesWithoutGrowingUpToASafetyOfNineTenths) {
  for (const char* safety : {"safety = 0.5\n", "safety = 0.75\n", "safety = 0.9\n"}) EXPECT_LT(swelling(safety), 1e-3);
}

TEST(TwoParticlesAtOnePlace, MoveAsOne) {
  for (const char* effects : {"motion, elasticity", k_everything}) {
    Dough dough = lonely(effects);
    dough.body = "jitter = 0";
    dough.tables += "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\njitter = 0\nshape = { " + dough.shape + " }\n";
    Watched two(dough);
    ASSERT_EQ(two->particles(), 2u);
    ASSERT_NO_FATAL_FAILURE(two.run(0.3));
    const Snapshot end = two.particles();
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(end.position[0][d], end.position[1][d], 1e-12);
  }
}

TEST(OneOrSixtyFourParticlesPerCell, AreNoSpecialCase) {
  for (const double many : {1, 64}) {
    Dough dough = small();
    dough.effects = k_everything;
    dough.shape = "sphere = { centre_m = [0, 0, -0.6], radius_m = 0.3 }";
    dough.particles_per_cell = many;
    Watched ball(dough);
    ASSERT_NO_FATAL_FAILURE(ball.run(0.2));
    const double solid = ball.start().solid;
    EXPECT_NEAR(solid, 300 * 4 / 3. * M_PI * 0.027, 0.2 * solid);  // 1 per cell: about 58 particles
  }
}

// A film of one cell, all of it surface, and a ball whose middle dries through its crust. The drier it is the slower water comes to the
// surface, K theta s grad s: what is left falls as 1/t.
TEST(AllWater, CanEvaporateAndNoneIsOwed) {
  const char* shapes[] = {"box = { half_extents_m = [0.375, 0.375, 0.0625] }", "sphere = { radius_m = 0.2 }"};
  for (const char* precision : {"double", "single"})
    for (const char* effects : {"heat, water", k_everything})
      for (const char* shape : shapes) {
        Dough dough = small();
        dough.effects = effects;
        dough.precision = precision;
        dough.gravity = "[0, 0, 0]";
        dough.shape = shape;
        dough.material = Dough::properties("diffusivity_m2_per_sK = 2e-2\nevaporation_kg_per_m2sK = 50");
        dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 100\n";
        Watched drying(dough);
        ASSERT_NO_FATAL_FAILURE(drying.run(effects == k_everything ? 5 : 15));
        EXPECT_LT(drying.now().water, 0.2 * drying.start().water) << effects << ", " << shape;
        const Snapshot dry = drying.particles();
        for (const double m : dry["water_mass"]) ASSERT_GE(m, 0);
      }
}

TEST(ABodyOutsideTheDomain, IsRefusedBeforeTheRun) {
  Dough dough = small();
  dough.shape = "sphere = { centre_m = [0.9, 0, 0], radius_m = 0.3 }";
  const std::string message = message_of<InputError>([&] { dough.begin(); });
  EXPECT_NE(message.find("outside the domain, allowed: "), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(ADoughHeatedFromTheFreezerTo400DegreesInOneFrame, StaysFinite) {
  Dough dough = small(k_everything);
  dough.body = "temperature_C = -20";
  dough.material = Dough::changed({{"conductivity_W_per_mK", "1e5"}});
  dough.tables = "[oven]\ntemperature_C = 400\nheat_transfer_coefficient_W_per_m2K = 1e5\n";
  Watched ball(dough);
  ASSERT_NO_FATAL_FAILURE(ball.run(0.04));
  EXPECT_GT(ball->highest(highest::temperature), 350);
  EXPECT_LE(ball->highest(highest::temperature), 400 + 1e-6);
}

TEST(APressThatClosesFasterThanSound, EndsInAnErrorOrInFiniteNumbers) {
  const double speed = 1.1 / 0.02;
  for (const char* precision : {"double", "single"}) {
    Dough dough = small();
    dough.effects = "motion, elasticity, plasticity";
    dough.precision = precision;
    dough.tables = R"([[collider]]
shape = { box = { centre_m = [0, 0, 0.5], half_extents_m = [0.5, 0.5, 0.1] } }
motion = [{ time_s = 0 }, { time_s = 0.02, position_m = [0, 0, -1.1] }]
[[collider]]
shape = { half_space = { point_m = [0, 0, -0.4], normal = [0, 0, 1] } }
)";
    const Material material = dough.scene().materials[0];
    const auto& elastic = of<Elasticity>(material);
    const double nu = elastic.poisson_ratio, modulus = elastic.young_modulus_Pa * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    ASSERT_GT(speed, std::sqrt(modulus / material.density_kg_per_m3)) << "c = sqrt((lambda + 2 mu) / rho)";
    Watched ball(dough);
    const std::size_t particles = ball->particles();
    try {
      ASSERT_NO_FATAL_FAILURE(ball.run(0.03, speed));
      EXPECT_EQ(ball->particles(), particles);
    } catch (const RunError& error) {
      EXPECT_EQ(std::string(error.what()).find("particle "), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace bake

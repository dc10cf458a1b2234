// SPDX-License-Identifier: MIT
// Whatever pushes the dough is booked: momentum = start + impulses, angular momentum = start + angular impulses.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "tests/conservation/dough.h"

namespace bake {
namespace {

struct Push {
  const char* name;
  const char* gravity;
  const char* body;
  const char* domain;
  const char* tables;
};

std::string name_of(const testing::TestParamInfo<std::tuple<Push, const char*, const char*>>& info) {
  const auto& [push, effects, precision] = info.param;
  return std::string(push.name) + (std::string_view(effects) == k_everything ? "Everything_" : "Elastic_") + precision;
}

class EveryPush : public testing::TestWithParam<std::tuple<Push, const char*, const char*>> {};

TEST_P(EveryPush, IsBooked) {
  const auto& push = std::get<0>(GetParam());
  const std::string effects = std::get<1>(GetParam()), precision = std::get<2>(GetParam());
  Dough dough(effects);
  dough.precision = precision;
  dough.gravity = push.gravity;
  dough.body = push.body;
  dough.faces = push.domain;
  dough.tables = push.tables;
  if (effects == k_everything) dough.frame_s = 2.5e-4;  // pores that are pressed shut are stiff
  if (std::string_view(push.name).ends_with("Floor")) dough.shape = "sphere = { centre_m = [0, 0, -0.7], radius_m = 0.25 }";
  const auto s = dough.begin();
  const Sums start(*s);
  constexpr double k_fastest = 4, k_reach = 2;  // [m/s], [m]
  double pushed = 0;
  take_steps(*s, static_cast<int>(std::lround(0.06 / dough.frame_s)), dough.frame_s, [&](int step, const Sums& now) {
    // impulses of floors and walls go back and forth: what was booked in all bounds what round-off can be
    const double scale = start.mass() * k_fastest;
    for (std::size_t d = 0; d < 3; ++d) {
      ASSERT_NEAR(now.momentum[d], start.momentum[d] + now.impulse[d] - start.impulse[d], step * round_off(precision) * scale) << d;
      ASSERT_NEAR(now.angular[d], start.angular[d] + now.angular_impulse[d] - start.angular_impulse[d],
                  step * round_off(precision) * scale * k_reach)
          << d;
    }
    pushed = larger(pushed, length(now.impulse));
  });
  EXPECT_GT(pushed, 0.01 * start.mass()) << "else nothing was tested";
}

INSTANTIATE_TEST_SUITE_P(
    Of, EveryPush,
    testing::Combine(testing::Values(Push{"Gravity", "[1, -2, -9.81]", "", "", ""},
                                     Push{"RampedGravityFloor", "[[0, [0, 0, 0]], [0.03, [1, -2, -60]], [0.05, [0, 0, -20]]]",
                                          "velocity_m_per_s = [1, 0, -2]", "friction = 0.3", ""},
                                     Push{"SeparatingFloor", "[0, 0, -9.81]", "velocity_m_per_s = [1, 0, -2]", "friction = 0.3", ""},
                                     Push{"StickyFloor", "[0, 0, -9.81]", "velocity_m_per_s = [1, 0, -2]", "z_min = \"sticky\"", ""},
                                     Push{"MovingCollider", "[0, 0, 0]", "", "",
                                          R"([[collider]]
shape = { box = { centre_m = [-0.6, 0, 0.1], half_extents_m = [0.3, 0.5, 0.2] } }
contact = "separating"
friction = 0.5
motion = [{ time_s = 0 }, { time_s = 1, position_m = [2, 0, 0] }]
)"},
                                     Push{"StickyCollider", "[0, 0, 0]", "velocity_m_per_s = [0, 2, 0]", "",
                                          R"([[collider]]
shape = { half_space = { point_m = [0, 0.2, 0], normal = [0, -1, 0] } }
contact = "sticky"
)"},
                                     Push{"TurningGrip", "[0, 0, 0]", "velocity_m_per_s = [1, 0, 0]", "",
                                          R"([[grip]]
shape = { box = { centre_m = [0, 0, 0.25], half_extents_m = [0.3, 0.3, 0.1] } }
motion = [{ time_s = 0 }, { time_s = 1, rotation_deg = [0, 0, 180] }]
)"}),
                     testing::Values("motion, elasticity", k_everything), testing::Values("double", "single")),
    name_of);

// Impulses act on the inertial mass, and so the ledger's momentum is that of the inertial mass.
TEST(DoughOfScaledInertia, FallsSlowerAndKeepsItsBooks) {
  Dough dough;
  dough.motion = "inertia_scale = 4";
  dough.gravity = "[0, 0, -9.81]";
  dough.body = "velocity_m_per_s = [1, 0, 0]";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 60, dough.frame_s);
  const Sums now(*s);
  for (std::size_t d = 0; d < 3; ++d)
    EXPECT_NEAR(now.momentum[d], start.momentum[d] + now.impulse[d] - start.impulse[d], 60e-12 * 4 * start.mass());
  EXPECT_NEAR(now.impulse[2], -start.mass() * 9.81 * 0.06, 1e-9 * start.mass());
  for (const Vector3& v : s->snapshot().velocity) ASSERT_NEAR(v[2], -9.81 * 0.06 / 4, 1e-9);
}

/// A ball thrown at the far face.
Dough thrown(const char* face, const std::string& effects = "motion, elasticity") {
  Dough dough(effects);
  dough.body = "velocity_m_per_s = [5, 0, 0]";
  dough.faces = std::string("x_max = \"") + face + "\"";
  return dough;
}

TEST(AnOpenFace, RetiresAndBooksWhatPassesIt) {
  const auto s = thrown("open", k_everything).begin();
  const Sums start(*s);
  const auto particles = static_cast<std::int64_t>(s->particles());
  take_steps(*s, 200, 1e-3, [&](int step, const Sums& now) {
    const Sums retired(Sums::retired(*s));
    const double tolerance = step * 1e-12, speed = 6, reach = 2;
    ASSERT_NEAR(now.solid + retired.solid, start.solid, tolerance * start.solid) << "at t = " << s->time();
    ASSERT_NEAR(now.water + retired.water, start.water, tolerance * start.water);
    ASSERT_NEAR(now.heat + retired.heat, start.heat + now.heat_gained() - start.heat_gained(), tolerance * start.heat);
    for (std::size_t d = 0; d < 3; ++d) {
      ASSERT_NEAR(now.momentum[d] + retired.momentum[d], start.momentum[d] + now.impulse[d], tolerance * start.mass() * speed);
      ASSERT_NEAR(now.angular[d] + retired.angular[d], start.angular[d] + now.angular_impulse[d], tolerance * start.mass() * speed * reach);
    }
    ASSERT_EQ(static_cast<std::int64_t>(s->particles()) + s->counters().retired, particles);
    ASSERT_EQ(s->counters().clamped, 0);
  });
  EXPECT_GT(s->counters().retired, particles / 4) << "else nothing was tested";
}

TEST(AnOpenFace, LetsEverybodyOutInTheEnd) {
  const auto s = thrown("open").begin();
  const auto particles = static_cast<std::int64_t>(s->particles());
  EXPECT_TRUE(s->advance(1, 2));
  EXPECT_EQ(s->particles(), 0u);
  EXPECT_EQ(s->counters().retired, particles);
  EXPECT_TRUE(s->snapshot().id.empty());
}

TEST(AClosedFace, LosesNobody) {
  const auto s = thrown("separating").begin();
  const std::size_t particles = s->particles();
  EXPECT_TRUE(s->advance(0.4, 0.5));
  EXPECT_EQ(s->particles(), particles);
  EXPECT_EQ(s->counters().retired, 0);
  for (const Vector3& x : s->snapshot().position) ASSERT_LE(x[0], 1);
}

TEST(AClosedFace, HoldsAndCountsWhoeverWouldPassIt) {
  Dough dough = thrown("separating");
  // a node inside the face is not stopped: particles less than a step away from it can reach it
  dough.shape = "box = { centre_m = [0.74, 0, 0], half_extents_m = [0.26, 0.3, 0.3] }";
  dough.body = "velocity_m_per_s = [5, 0, 0]\njitter = 1";
  const auto s = dough.begin();
  EXPECT_TRUE(s->advance(0.1, 0.2));
  EXPECT_GT(s->counters().clamped, 0);
  for (const Vector3& x : s->snapshot().position) ASSERT_LE(x[0], 1);
}

TEST(AnEmitter, PoursTheMassThatItBooks) {
  for (const char* precision : {"double", "single"}) {
    Dough dough;
    dough.precision = precision;
    dough.shape = "sphere = { centre_m = [0, 0, -0.7], radius_m = 0.2 }";
    dough.tables = R"([[emitter]]
material = "dough"
shape = { cylinder = { from_m = [0, 0, 0.5], to_m = [0, 0, 0.6], radius_m = 0.2 } }
velocity_m_per_s = [0, 0, -2]
particles_per_cell = 8
until_s = 0.3
)";
    const auto s = dough.begin();
    const std::size_t before = s->particles();
    EXPECT_TRUE(s->advance(0.32, 0.4));
    const double M = Sums(*s).mass();
    const Snapshot now = s->snapshot();
    double of_particles = 0;
    for (const double V : now["initial_volume"]) of_particles += 500 * V;
    EXPECT_NEAR(M, of_particles, 1e-6 * M);
    EXPECT_GT(s->particles(), before + 3 * 8 * 8);
    const double length = 2 * 0.3, area = M_PI * 0.04;
    const Sums now_all(*s), emitted(Sums::emitted(*s));
    EXPECT_NEAR(emitted.mass(), 500 * length * area, 0.01 * 500 * length * area);
    EXPECT_NEAR(M, 500 * 4 / 3. * M_PI * 0.008 + emitted.mass(), 0.05 * M);
    EXPECT_NEAR(emitted.momentum[2], -2 * emitted.mass(), 1e-5 * emitted.mass());
    const double tolerance = static_cast<double>(s->counters().steps) * round_off(precision) * M * 4;
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(now_all.momentum[d], emitted.momentum[d] + now_all.impulse[d], tolerance) << "the ball lies still, without gravity";
  }
}

TEST(AnEmitter, OverAnOpenFaceBooksWhatComesAndWhatGoes) {
  Dough dough(k_everything);
  dough.material = Dough::properties(Dough::moving_water());
  dough.gravity = "[0, 0, -9.81]";
  dough.faces = "z_min = \"open\"";
  dough.shape = "sphere = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2 }";
  dough.tables = R"([[emitter]]
material = "dough"
shape = { cylinder = { from_m = [0, 0, -0.6], to_m = [0, 0, -0.5], radius_m = 0.2 } }
velocity_m_per_s = [0, 0, -3]
temperature_C = 50
particles_per_cell = 8
until_s = 0.15
)";
  const auto s = dough.begin();
  EXPECT_TRUE(s->advance(0.25, 0.3));
  const Sums now(*s), emitted(Sums::emitted(*s)), retired(Sums::retired(*s));
  EXPECT_GT(retired.mass(), 0.3 * emitted.mass()) << "else nothing was tested";
  EXPECT_GT(emitted.heat / emitted.mass(), 1.5 * (now.heat + retired.heat - emitted.heat) / now.mass()) << "what is poured is warmer";
  // The ball at the start is what there was but for what was poured, left, evaporated or pushed.
  const auto at_start = dough.begin();
  const Sums ball(*at_start), first(Sums::emitted(*at_start));
  const double steps = static_cast<double>(s->counters().steps) * 1e-12;
  EXPECT_NEAR(now.solid + retired.solid, ball.solid + emitted.solid - first.solid, steps * now.solid);
  EXPECT_NEAR(now.water + retired.water + now.evaporated, ball.water + emitted.water - first.water, steps * now.water);
  EXPECT_NEAR(now.heat + retired.heat, ball.heat + emitted.heat - first.heat + now.heat_gained(), steps * now.heat);
  for (std::size_t d = 0; d < 3; ++d)
    EXPECT_NEAR(now.momentum[d] + retired.momentum[d],
                ball.momentum[d] + emitted.momentum[d] - first.momentum[d] + now.impulse[d] + now.remapped[d], steps * now.mass() * 10);
}

constexpr const char* k_knife = R"([[collider]]
shape = { box = { centre_m = [0, 0, 0.4], half_extents_m = [0.03, 0.3, 0.3] } }
contact = "separating"
expels = true
motion = [{ time_s = 0 }, { time_s = 0.2, position_m = [0, 0, -0.4] }]
)";

TEST(AKnife, GivesWhatItBooksToDoughWhoseWaterMoves) {
  Dough dough("motion, water, elasticity");
  dough.material = Dough::properties(Dough::moving_water());
  dough.body = "temperature_C = 60";
  dough.tables = k_knife;
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 100, dough.frame_s, [&](int step, const Sums& now) {
    for (std::size_t d = 0; d < 3; ++d)
      ASSERT_NEAR(now.momentum[d] - start.momentum[d], now.impulse[d] - start.impulse[d] + now.remapped[d] - start.remapped[d],
                  step * 1e-12 * start.mass() * 4);
  });
  EXPECT_LT(Sums(*s).impulse[2], -0.05 * start.mass()) << "else nothing was tested";
}

TEST(AKnife, GivesWhatItBooks) {
  Dough dough;
  dough.tables = k_knife;
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 100, dough.frame_s, [&](int step, const Sums& now) {
    const double scale = step * 1e-12 * start.mass() * 4;
    for (std::size_t d = 0; d < 3; ++d) {
      ASSERT_NEAR(now.momentum[d], start.momentum[d] + now.impulse[d] - start.impulse[d], scale);
      ASSERT_NEAR(now.angular[d], start.angular[d] + now.angular_impulse[d] - start.angular_impulse[d], scale);
    }
  });
  EXPECT_LT(Sums(*s).impulse[2], -0.05 * start.mass()) << "else nothing was tested";
  for (const Vector3& x : s->snapshot().position) {  // the blade's lower edge is now at -0.1: nobody is deep in it
    const double depth = std::min({0.03 - std::abs(x[0]), 0.3 - std::abs(x[1]), x[2] + 0.1});
    EXPECT_LT(depth, 0.01) << x[0] << " " << x[1] << " " << x[2];
  }
}

}  // namespace
}  // namespace bake

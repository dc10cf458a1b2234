// SPDX-License-Identifier: MIT
// Gravity that changes with time: the fall has its closed form, and what gravity gives is booked.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "solver/core/curve.h"
#include "tests/conservation/dough.h"

namespace bake {
namespace {

constexpr double k_g = 9.81, k_ramp = 0.05;  ///< [m/s^2], reached after [s]

/// An elastic ball that falls while gravity rises from zero to k_g within k_ramp, and then stays.
Dough falling(double dt) {
  Dough dough;
  dough.frame_s = dt;
  dough.gravity = fmt::format("[[0, [0, 0, 0]], [{}, [0, 0, {}]]]", k_ramp, -k_g);
  dough.shape = "sphere = { centre_m = [0.01, 0, 0.6], radius_m = 0.25 }";
  return dough;
}

double speed_of_fall(double t) { return t < k_ramp ? k_g * t * t / (2 * k_ramp) : k_g * (t - k_ramp / 2); }
double depth_of_fall(double t) {
  const double after = t - k_ramp;
  return t < k_ramp ? k_g * t * t * t / (6 * k_ramp) : k_g * (k_ramp * k_ramp / 6 + k_ramp / 2 * after + after * after / 2);
}

/// `dt`: 3e-3 s does not divide the ramp, so that a step goes over its end.
TEST(RampedGravity, MakesTheFallOfTheClosedForm) {
  for (const double dt : {1e-3, 3e-3}) {
    const auto s = falling(dt).begin();
    const Snapshot first = s->snapshot();
    take_steps(*s, static_cast<int>(std::lround(0.12 / dt)), dt, [&] {
      const double t = s->time(), v = speed_of_fall(t), z = depth_of_fall(t);
      const Snapshot now = s->snapshot();
      double of_speed = 0, of_depth = 0;
      for (std::size_t i = 0; i < now.id.size(); ++i) {
        of_speed = larger(of_speed, std::abs(-now.velocity[i][2] - v));
        // the velocity after a step moves the particles: they are v dt / 2 ahead, but for what the ramp's bend adds
        of_depth = larger(of_depth, std::abs(first.position[i][2] - now.position[i][2] - z - v * dt / 2));
      }
      ASSERT_LE(of_speed, 1e-11) << "at t = " << t;
      ASSERT_LE(of_depth, k_g * dt * dt) << "at t = " << t;
    });
    EXPECT_GT(depth_of_fall(s->time()), 0.02) << "else nothing was tested";
  }
}

TEST(RampedGravity, IsBookedAndItsWorkIsTheMotion) {
  const Dough dough = falling(1e-3);
  const auto s = dough.begin();
  const Sums start(*s);
  const VectorCurve gravity = dough.scene().of<Motion>().gravity_m_per_s2;
  double work = 0;
  int steps = 0;
  take_steps(*s, 120, dough.frame_s, [&] {
    const double t = s->time(), before = t - dough.frame_s;
    const Sums now(*s);
    ++steps;
    ASSERT_NEAR(now.impulse[2], -now.mass() * speed_of_fall(t), steps * round_off("double") * now.mass());
    ASSERT_NEAR(now.momentum[2], now.impulse[2], steps * round_off("double") * now.mass());
    work += now.mass() * gravity.mean(before, t)[2] * -(speed_of_fall(before) + speed_of_fall(t)) / 2 * dough.frame_s;
    ASSERT_NEAR(now.kinetic + now.elastic, work, 1e-10 * now.mass()) << "at t = " << t;
  });
  EXPECT_GT(work, 0.1 * start.mass()) << "else nothing was tested";
}

/// A light skin has more inertia than mass: what gravity would give the difference is taken back, from grid and books alike.
TEST(RampedGravity, PullsASkinByItsMass) {
  Dough dough = falling(1e-3);
  dough.tables = "[[skin]]\nyoung_modulus_Pa = 1e6\nthickness_m = 0.02\ndensity_kg_per_m3 = 50\n";
  dough.body = "angular_velocity_rad_per_s = [0, 0, 5]";
  const auto s = dough.begin();
  const Sums start(*s);
  take_steps(*s, 80, dough.frame_s);
  const Sums now(*s);
  EXPECT_NEAR(now.impulse[2], -now.solid * speed_of_fall(s->time()), 1e-9 * now.solid);
  EXPECT_LE(length(now.momentum - start.momentum - now.impulse), 80 * 1e-12 * now.solid);
  EXPECT_LE(length(now.angular - start.angular - now.angular_impulse), 80 * 1e-12 * length(start.angular));
}

}  // namespace
}  // namespace bake

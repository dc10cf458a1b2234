// SPDX-License-Identifier: MIT
// Before the scene's time begins the dough may settle: only motion goes on, and what damping takes is booked.
#include <gtest/gtest.h>

#include "analysis/claims/finite.h"
#include "tests/conservation/bits_of_run.h"

namespace bake {
namespace {

/// One step, of settling or not. Returns its length.
double take_step(Simulation& s, double frame_s) {
  const double dt = s.dt();
  s.advance(frame_s, 2 * frame_s, [] { return false; });
  return dt;
}

/// Everything, so light that its yield stress bears it, on the floor, beside a plate that has begun to move and to warm, held by a warm
/// grip.
Dough put_on_a_tray(const std::string& precision = "double") {
  Dough dough;
  dough.effects = k_everything;
  dough.precision = precision;
  dough.frame_s = 0.01;
  dough.gravity = "[0, 0, -0.5]";
  dough.motion = "settle_damping_per_s = 40\nsettle_still_m_per_s = 0.005";
  dough.shape = "sphere = { centre_m = [0.02, 0.01, -0.73], radius_m = 0.27 }";
  dough.body = "temperature_C = 30\njitter = 1";
  dough.material = Dough::properties(Dough::moving_water());
  dough.tables = R"([surface]
keep_dx = 0.05
[oven]
temperature_C = 200
heat_transfer_coefficient_W_per_m2K = 200
[[collider]]
shape = { box = { centre_m = [-0.55, 0, -0.6], half_extents_m = [0.3, 0.4, 0.3] } }
motion = [{ time_s = 0 }, { time_s = 0.5, position_m = [0.6, 0, 0] }]
temperature_C = [[0, 90], [1, 120]]
heat_transfer_coefficient_W_per_m2K = 300
[[grip]]
shape = { sphere = { centre_m = [0, 0, -0.97], radius_m = 0.12 } }
temperature_C = 70
)";
  return dough;
}

TEST(Settling, MovesTheDoughAndLeavesEveryClockAndAllHeatWaterAndGasAlone) {
  const Dough dough = put_on_a_tray();
  const auto s = dough.begin();
  const Snapshot start = s->snapshot();
  int steps = 0;
  while (s->settling().now) {
    take_step(*s, dough.frame_s);
    ++steps;
    if (!s->settling().now) break;
    ASSERT_EQ(s->time(), 0);
  }
  ASSERT_GT(steps, 20) << "else nothing was tested";
  EXPECT_TRUE(s->settling().is_still);
  EXPECT_LT(s->settling().time, 1);
  EXPECT_EQ(s->time(), 0) << "the last step of settling is none of the scene's";
  const Snapshot now = s->snapshot();
  for (const char* column : {"temperature", "peak_temperature", "water_mass", "produced_gas", "leavener"})
    EXPECT_EQ(now[column], start[column]) << column;
  double moved = 0;
  for (std::size_t i = 0; i < now.id.size(); ++i) moved = larger(moved, length(start.position[i] - now.position[i]));
  EXPECT_GT(moved, 5e-4);
  const double exchanged = s->booked(booked::heat_exchanged);
  EXPECT_NEAR(exchanged, 0, 1e-12 * s->total(total::heat_content)) << "but for round-off";
  EXPECT_EQ(s->booked(booked::evaporated), 0);
  s->advance(5 * dough.frame_s, 6 * dough.frame_s);
  EXPECT_GT(s->booked(booked::heat_exchanged), 1) << "then baking begins";
  EXPECT_GT(s->total(total::gas), 0);
}

TEST(Settling, IsBookedAsAnImpulse) {
  for (const char* effects : {"motion, elasticity", k_everything})
    for (const char* precision : {"double", "single"}) {
      Dough dough = put_on_a_tray(precision);
      dough.effects = effects;
      dough.body = "velocity_m_per_s = [0.5, 0, -0.5]\nangular_velocity_rad_per_s = [0, 3, 0]";
      const auto s = dough.begin();
      const Sums start(*s);
      s->advance(dough.frame_s, 2 * dough.frame_s);
      const Sums now(*s);
      const double scale = static_cast<double>(s->counters().steps) * round_off(precision) * start.mass() * 4;
      for (std::size_t d = 0; d < 3; ++d) {
        const double water = now.remapped[d];  // what it moves between particles counts from the start of baking on
        EXPECT_NEAR(now.momentum[d], start.momentum[d] + now.impulse[d] - start.impulse[d] + water - start.remapped[d], scale)
            << effects << precision << d;
      }
      EXPECT_GT(length(now.impulse - start.impulse), 0.1 * start.mass()) << "else nothing was tested";
    }
}

/// A ball without weight that flies: speed falls as exp(-t c), until it was slow for 1 / c.
TEST(Settling, TakesTheSpeedThatItsRateSaysAndBooksTheEnergy) {
  Dough dough;
  dough.body = "velocity_m_per_s = [0.3, -0.4, 0]";
  dough.motion = "settle_damping_per_s = 20\nsettle_still_m_per_s = 0.005";
  const auto s = dough.begin();
  const Sums start(*s);
  s->advance(dough.frame_s, 2 * dough.frame_s);
  const Sums now(*s);
  const double took = s->settling().time, step = took / static_cast<double>(s->counters().steps - 1);
  EXPECT_TRUE(s->settling().is_still);
  EXPECT_NEAR(took, (std::log(0.5 / 0.005) + 1) / 20, 2.5 * step);
  EXPECT_NEAR(length(now.momentum), length(start.momentum) * std::exp(-20 * took), 1e-9 * length(start.momentum));
  EXPECT_NEAR(now.kinetic + s->booked(booked::damped), start.kinetic, 1e-10 * start.kinetic);
  EXPECT_LT(now.elastic, 1e-12 * start.kinetic);
}

/// Dough that falls all the while comes no nearer to rest than gravity / damping; work of gravity = motion + what was damped.
TEST(Settling, OfDoughThatFallsEndsInTimeAndIsNotCalledStill) {
  Dough dough;
  dough.gravity = "[[0, [0, 0, -9.81]], [0.1, [0, 0, 0]]]";  // that of the start, since time stands still
  dough.motion = "settle_damping_per_s = 20\nsettle_longest_s = 0.2";
  const auto s = dough.begin();
  const Sums start(*s);
  double v = 0, work = 0;  // per mass
  while (s->settling().now) {
    const double dt = take_step(*s, dough.frame_s), fallen = v + 9.81 * dt;
    work += 9.81 * dt * (v + fallen) / 2;
    v = fallen * std::exp(-20 * dt);
  }
  EXPECT_NEAR(s->settling().time, 0.2, 1e-12);
  EXPECT_FALSE(s->settling().is_still);
  EXPECT_NEAR(v, 9.81 / 20 * (1 - std::exp(-4)), 0.03);
  const double damped = s->booked(booked::damped);
  s->advance(dough.frame_s, 2 * dough.frame_s);
  const Sums now(*s);
  EXPECT_EQ(s->booked(booked::damped), damped) << "the scene's own steps are not damped";
  const double g = 9.81 * (1 - dough.frame_s / 0.2), after = v + g * dough.frame_s;
  EXPECT_NEAR(now.momentum[2], -now.mass() * after, 1e-9 * now.mass());
  EXPECT_NEAR(now.kinetic + damped, now.mass() * (work + (after * after - v * v) / 2), 1e-9 * now.mass());
}

TEST(Settling, LeavesABallAtRestThatWouldBounceWithoutIt) {
  const auto bounce = [](const std::string& motion) {
    Dough dough;
    dough.gravity = "[0, 0, -9.81]";
    dough.motion = motion;
    dough.shape = "sphere = { centre_m = [0, 0, -0.74], radius_m = 0.25 }";
    const auto s = dough.begin();
    double most = 0;
    for (int f = 1; f <= 100; ++f) {
      s->advance(f * 2e-3, (f + 1) * 2e-3);
      most = larger(most, s->total(total::kinetic) / s->total(total::solid_mass));
    }
    return most;
  };
  const double free = bounce(""), settled = bounce("settle_damping_per_s = 30\nsettle_still_m_per_s = 2e-3\nsettle_longest_s = 3");
  EXPECT_GT(free, 1e-2);
  EXPECT_LT(settled, 1e-3 * free);
}

class BitsOfSettling : public BitsOfRun, public testing::WithParamInterface<const char*> {
 protected:
  BitsOfSettling() : BitsOfRun(put_on_a_tray(GetParam()).scene(), 3) {}
};

TEST_P(BitsOfSettling, AreTheSameForAnyNumberOfThreadsAndAfterAStopInTheMiddleOfIt) {
  std::string one;
  std::int64_t settling_steps = 0;
  for (const int n : {1, 3}) {
    omp_set_num_threads(n);
    const auto s = Simulation::begin(scene);
    while (s->settling().now) advance(*s, frames, 1);
    settling_steps = s->counters().steps;
    advance(*s, frames);
    if (n == 1)
      one = saved(*s);
    else
      EXPECT_TRUE(saved(*s) == one) << n << " threads";
  }
  ASSERT_GT(settling_steps, 20);
  for (const std::int64_t steps : {std::int64_t{1}, settling_steps / 2, settling_steps - 1, settling_steps, settling_steps + 1}) {
    const auto first = Simulation::begin(scene);
    advance(*first, frames, static_cast<int>(steps));
    ASSERT_EQ(first->settling().now, steps < settling_steps);
    saved(*first);
    const auto second = read_again();
    EXPECT_EQ(second->settling().time, first->settling().time);
    advance(*second, frames);
    EXPECT_TRUE(saved(*second) == one) << "stopped after " << steps << " of " << settling_steps << " steps";
  }
}
INSTANTIATE_TEST_SUITE_P(In, BitsOfSettling, testing::Values("single", "double"), [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// What the tests of hard cases share: a small lump of dough, and what must hold of it whatever is done to it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/conservation/dough.h"
#include "tests/stability/energy.h"

namespace bake {

inline void expect_finite(const Simulation& s) {
  for (const double x : ledger_row(s)) ASSERT_TRUE(std::isfinite(x));
  const Snapshot now = s.snapshot();
  for (const auto& [name, values] : now.columns)
    for (const double x : values) ASSERT_TRUE(std::isfinite(x) && (x > 0 || name != field::VolumeRatio::name)) << name << ": " << x;
  for (const Vector3& x : now.position)
    for (const double c : x) ASSERT_TRUE(c >= -1 && c <= 1) << c;
}

/// Steps have been taken, so round-off adds up.
inline void expect_closed_books(const Simulation& s, const Sums& start, const std::string& precision = "double") {
  const double tolerance = static_cast<double>(s.counters().steps + 1) * round_off(precision);
  const Sums now(s);
  EXPECT_NEAR(now.solid, start.solid, 1e-12 * start.solid);
  EXPECT_NEAR(now.water + now.evaporated - start.evaporated, start.water, tolerance * start.water);
  const double heat = std::abs(start.heat) + std::abs(now.heat) + std::abs(now.exchanged - start.exchanged);
  EXPECT_NEAR(now.heat, start.heat + now.heat_gained() - start.heat_gained(), tolerance * heat);
  const Vector3 given = now.impulse + now.remapped - start.impulse - start.remapped;
  // what was pushed back and forth on the way bounds the round-off: at most the fastest speed for the whole mass
  const double scale = start.mass() * (10 + std::sqrt(2 * std::max(now.kinetic, start.kinetic) / start.mass()));
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(now.momentum[d], start.momentum[d] + given[d], tolerance * scale);
  EXPECT_EQ(s.counters().retired, 0);
}

/// A dough that is watched from its first step on.
class Watched {
 public:
  explicit Watched(const Scene& scene) : scene_(scene), s_(Simulation::begin(scene_)), start_(*s_), work_(scene_, *s_) {}
  explicit Watched(const Dough& dough) : Watched(dough.scene()) {}

  Simulation* operator->() const { return s_.get(); }
  const Sums& start() const { return start_; }
  Sums now() const { return Sums(*s_); }
  Snapshot particles() const { return s_->snapshot(); }

  /// Steps until `time`. At frames on the way everything must be finite, the books closed and the energy bounded; `scripted` [m/s] is
  /// the fastest speed of what moves by script.
  void run(double time, double scripted = 0) {
    constexpr int k_frames = 5;
    const double from = s_->time(), frame = (time - from) / k_frames;
    for (int i = 1; i <= k_frames; ++i) {
      ASSERT_TRUE(s_->advance(from + i * frame, from + (i + 1) * frame, [&] {
        work_.add(*s_);
        return true;
      }));
      ASSERT_NO_FATAL_FAILURE(expect_finite(*s_));
      expect_closed_books(*s_, start_, scene_.run.precision == Precision::single_precision ? "single" : "double");
      expect_bounded_energy(start_, now(), work_, scripted);
    }
  }
  /// Forgets what was before.
  void watch_from_now() { start_ = now(), work_ = Work(scene_, *s_); }

 private:
  const Scene scene_;
  std::unique_ptr<Simulation> s_;
  Sums start_;
  Work work_;
};

inline Dough small(const std::string& effects = Dough().effects) {
  Dough dough(effects);
  dough.dx = 0.125;
  dough.frame_s = 0.02;
  dough.shape = "sphere = { centre_m = [0.01, 0.02, 0.03], radius_m = 0.3 }";
  dough.gravity = "[0, 0, -9.81]";
  return dough;
}

}  // namespace bake

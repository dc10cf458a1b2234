// SPDX-License-Identifier: MIT
// What the tests of hard cases share: a small lump of dough, and what must hold of it whatever is done to it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/conservation/dough.h"

namespace bake {

inline void expect_finite(const Simulation& s) {
  for (const double x : s.ledger_row()) ASSERT_TRUE(std::isfinite(x));
  const Snapshot now = s.snapshot();
  for (const auto& [name, values] : now.columns)
    for (const double x : values) ASSERT_TRUE(std::isfinite(x)) << name;
  for (const Vector3& x : now.position)
    for (const double c : x) ASSERT_TRUE(c >= -1 && c <= 1) << c;
}

/// Steps have been taken, so round-off adds up.
inline void expect_closed_books(const Simulation& s, const Sums& start) {
  const double tolerance = static_cast<double>(s.counters().steps + 1) * 1e-12;
  const Sums now(s);
  EXPECT_NEAR(now.solid, start.solid, 1e-12 * start.solid);
  EXPECT_NEAR(now.water + now.evaporated, start.water, tolerance * start.water);
  const double heat = std::abs(start.heat) + std::abs(now.heat) + std::abs(now.exchanged - start.exchanged);
  EXPECT_NEAR(now.heat, start.heat + now.heat_gained() - start.heat_gained(), tolerance * heat);
  const Vector3 given = now.impulse + now.remapped - start.impulse - start.remapped;
  // what was pushed back and forth on the way bounds the round-off: at most the fastest speed for the whole mass
  const double scale = start.mass() * (10 + std::sqrt(2 * std::max(now.kinetic, start.kinetic) / start.mass()));
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(now.momentum[d], start.momentum[d] + given[d], tolerance * scale);
  EXPECT_EQ(s.counters().retired, 0);
}

inline Dough small() {
  Dough dough;
  dough.dx = 0.125;
  dough.dt = 0.02;
  dough.ball = "sphere = { centre_m = [0.01, 0.02, 0.03], radius_m = 0.3 }";
  dough.gravity = "[0, 0, -9.81]";
  return dough;
}

}  // namespace bake

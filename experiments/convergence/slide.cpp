// SPDX-License-Identifier: MIT
// A block on a slope: down the slope it gains g (sin a - mu cos a) each second, or stays where mu > tan a.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "experiments/common/study_scene.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

constexpr double k_sliding_s = 1, k_angle = 30 * std::numbers::pi / 180;  // [s], [rad]; g = 1 m/s^2

/// A stiff block on the domain's floor, half a metre long; gravity is tilted instead of the floor.
std::unique_ptr<Simulation> block(double cells, double friction, double speed, const char* transfer = "apic") {
  StudyScene setting("motion, elasticity");
  setting.dx = 0.5 / cells;
  setting.frame_s = k_sliding_s;
  setting.low = {-0.5, -0.5, 0};
  setting.high = {1.5, 0.5, 1};
  setting.faces = fmt::format("friction = {}\n", friction);
  setting.time = "safety = 0.5";
  setting.gravity = fmt::format("[{:.17g}, 0, {:.17g}]", std::sin(k_angle), -std::cos(k_angle));
  setting.motion = fmt::format("transfer = \"{}\"", transfer);
  setting.material += "young_modulus_Pa = 100\npoisson_ratio = 0.3\n";
  setting.shape = "box = { centre_m = [0, 0, 0.125], half_extents_m = [0.25, 0.25, 0.125] }";
  setting.body = fmt::format("jitter = 0\nvelocity_m_per_s = [{}, 0, 0]", speed);
  return setting.begin();
}

/// Velocity of the centre along and off the slope.
std::array<double, 2> velocity(const Simulation& s) {
  const double m = s.total(total::solid_mass);
  return {s.total(total::momentum, 0) / m, s.total(total::momentum, 2) / m};
}

/// How far the centre has come with mu = 0.8, relative to sliding without friction from rest.
double creep(double cells, const char* transfer) {
  const auto s = block(cells, 0.8, 0, transfer);
  const Snapshot first = s->snapshot();
  run_to(*s, k_sliding_s);
  const Snapshot now = s->snapshot();
  double path = 0;
  for (std::size_t i = 0; i < now.id.size(); ++i) path += now.position[i][0] - first.position[i][0];
  return std::abs(path) / static_cast<double>(now.id.size()) / (std::sin(k_angle) * k_sliding_s * k_sliding_s / 2);
}

}  // namespace

std::vector<Errors> slope(bool quick) {
  constexpr double friction = 0.3, start = 0.5;
  Errors law, speed, stuck, chatter;
  law.quantity = "sliding, mu = 0.3 at 30 degrees: momentum along the slope against mu times the impulse of the floor";
  law.high = 1e-3;
  law.why =
      "exact for every node that slides: it loses mu times what the floor takes of its normal speed; nodes of little mass at the block's "
      "edges "
      "are thrown about and stop for single steps";
  speed.quantity = "sliding: velocity gained by the centre, against g (sin a - mu cos a) t";
  speed.high = 0.03;
  speed.why =
      "mu v_z, and no order: the block is dropped into its own weight and swings on its elasticity, with v_z below 2 h g / c = 5 % of what "
      "is "
      "gained";
  stuck.quantity = "sticking, mu = 0.8, swinging damped by PIC: path relative to that without friction";
  stuck.high = 0.02;
  stuck.why = "the block shears under its own weight by some 1e-3 m, of 0.25 m";
  chatter.quantity = "sticking, mu = 0.8, swinging freely with APIC: path relative to that without friction";
  chatter.high = 0.5;
  chatter.why =
      "Coulomb: none, since mu > tan a = 0.58. Does not hold: dropped into its weight, the elastic block swings and slips forward whenever "
      "it "
      "is light, and more so on finer grids, which damp less. The bound says only that it is held back";
  for (Errors* e : {&law, &speed, &stuck, &chatter}) {
    e->figure = Errors::Figure::largest_error;
    e->refined = "cells in the length";
    e->refinements = quick ? std::vector<double>{4, 8} : std::vector<double>{4, 8, 16, 24};
  }
  const double gain = (std::sin(k_angle) - friction * std::cos(k_angle)) * k_sliding_s;
  for (const double n : law.refinements) {
    const auto s = block(n, friction, start);
    run_to(*s, k_sliding_s);
    const auto [along, off] = velocity(*s);
    law.errors.push_back(std::abs(along - start - std::sin(k_angle) * k_sliding_s + friction * (std::cos(k_angle) * k_sliding_s + off)) /
                         gain);
    speed.errors.push_back(std::abs((along - start) / gain - 1));
    stuck.errors.push_back(creep(n, "pic"));
    chatter.errors.push_back(creep(n, "apic"));
  }
  return {law, speed, stuck, chatter};
}

}  // namespace bake::studies

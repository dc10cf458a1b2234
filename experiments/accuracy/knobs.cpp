// SPDX-License-Identifier: MIT
#include <algorithm>

#include "experiments/accuracy/case.h"

namespace bake::studies::accuracy {

namespace {

/// A value of a knob; `knob` is what cases ask for.
struct Knob {
  const char* knob;
  const char* label;
  std::vector<std::string> overrides;
  int per_cell = 0;
  By by = By::solver;
};

// What all cases start from, unless their scene says otherwise: a safety of 0.5 (half the step that the rule would still allow),
// quadratic kernel, APIC, single precision, forward Euler, standard surface. To add a value, add a line.
const std::vector<Knob>& all_settings() {
  static const std::vector<Knob> settings{
      {"step", "safety 1", {"time.safety=1"}},
      {"step", "safety 0.25", {"time.safety=0.25"}},
      {"step", "safety 0.125", {"time.safety=0.125"}},
      {"kernel", "cubic kernel", {"grid.kernel=cubic"}},
      {"transfer", "PIC", {"motion.transfer=pic"}},
      {"transfer", "FLIP", {"motion.transfer=flip"}},
      {"particles", "1 a cell", {}, 1},
      {"particles", "27 a cell", {}, 27},
      {"precision", "double", {"run.precision=double"}},
      {"euler", "backward Euler", {"heat.integrator=backward_euler", "heat.implicit_step_factor=1"}},
      {"euler", "backward Euler, step x 16", {"heat.integrator=backward_euler", "heat.implicit_step_factor=16"}},
      {"p_ref", "p_ref 1 kPa", {"leavening.reference_pressure_Pa=1000"}},
      {"p_ref", "p_ref 16 kPa", {"leavening.reference_pressure_Pa=16000"}},
      {"p_ref", "p_ref 101 kPa", {"leavening.reference_pressure_Pa=101325"}},
      {"inertia", "inertia x 1", {"motion.inertia_scale=1"}},
      {"inertia", "inertia x 8", {"motion.inertia_scale=8"}},
      {"inertia", "inertia x 64", {"motion.inertia_scale=64"}},
      {"surface", "published surface", {"surface.form=published"}},
      {"surface", "surface kept for 0.02 dx", {"surface.keep_dx=0.02"}},
      {"surface", "surface kept for 0.1 dx", {"surface.keep_dx=0.1"}},
      {"keep", "surface measured in every step", {"surface.keep_dx=0"}},
      {"textbook", "textbook (staged, double)", {"run.precision=double"}, 0, By::textbook},
      // together
      {"particles", "1 a cell, safety 1", {"time.safety=1"}, 1},
      {"kernel", "cubic kernel, safety 1", {"grid.kernel=cubic", "time.safety=1"}},
      {"inertia", "inertia x 8, p_ref 1 kPa", {"motion.inertia_scale=8", "leavening.reference_pressure_Pa=1000"}},
  };
  return settings;
}

std::vector<int> sorted(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::vector<int> cells_of_every_curve(const Case& c, Effort effort) {
  std::vector<int> cells = c.cells;
  if (effort == Effort::quick) cells.resize(std::min<std::size_t>(cells.size(), 3));
  if (effort == Effort::full) cells.insert(cells.end(), c.full_cells.begin(), c.full_cells.end());
  return sorted(cells);
}

std::vector<int> cells_of_default(const Case& c, Effort effort) {
  std::vector<int> cells = cells_of_every_curve(c, effort);
  // paper quality is for the night
  const std::size_t qualities = effort == Effort::quick ? 0 : effort == Effort::usual ? 2 : 3;
  for (std::size_t q = 0; q < std::min(qualities, c.quality.size()); ++q) cells.push_back(c.quality[q]);
  return sorted(cells);
}

std::vector<int> cells_of(const Case& c, const Knob& s, Effort effort) {
  if (s.by == By::solver) return cells_of_every_curve(c, effort);
  std::vector<int> coarsest = c.cells;  // the textbook is slow
  coarsest.resize(std::min<std::size_t>(coarsest.size(), effort == Effort::full ? 3 : 2));
  return coarsest;
}

bool turns(const Case& c, const std::string& knob) { return std::find(c.knobs.begin(), c.knobs.end(), knob) != c.knobs.end(); }

}  // namespace

std::vector<Variant> variants_of(const Case& c, Effort effort) {
  std::vector<Variant> variants;
  for (const int n : cells_of_default(c, effort)) variants.push_back({"default", n, 0, {}, By::solver});
  for (const Knob& s : all_settings())
    if (turns(c, s.knob))
      for (const int n : cells_of(c, s, effort)) variants.push_back({s.label, n, s.per_cell, s.overrides, s.by});
  return variants;
}

}  // namespace bake::studies::accuracy

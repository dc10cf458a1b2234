// SPDX-License-Identifier: MIT
// How far the time-step rule is from where the method breaks.
//
// Each effect states a limit of its own; the rule takes time.safety of the smallest. A probe sharpens one limit, excites its fastest
// modes by a jump, and looks by bisection for the largest safety with which nothing grows. The rule must be safe everywhere, and no
// more than three times too careful.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace bake::studies {

/// One point of a map.
struct Probe {
  std::string map;   ///< what limits the step and how it is integrated: "elastic waves, quadratic, APIC"
  std::string knob;  ///< what is varied: "young_modulus_Pa"
  double value;      ///< of the knob
  bool has_limit;    ///< false: stable with any step (backward Euler)
  /// Does it stay bounded with this safety?
  std::function<bool(double safety)> holds;
  std::function<double(double safety)> step;  ///< the first that the rule takes with it [s]
};

/// What was found.
struct Edge {
  Probe probe;
  double largest_safety;  ///< with which it holds; the search ends at k_most_safety
  double factor;          ///< largest stable step over the step that the rule takes
  bool safe() const;
  bool sharp() const;  ///< at most three times too careful
};

inline constexpr double k_most_safety = 64;

std::vector<Probe> all_probes(bool quick);
Edge find_edge(const Probe& probe);

}  // namespace bake::studies

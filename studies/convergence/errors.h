// SPDX-License-Identifier: MIT
// Errors of one quantity at several refinements, and what theory expects of them.
#pragma once

#include <string>
#include <vector>

namespace bake::studies {

struct Errors {
  /// What is judged: the fitted order, or, where the discrete solution should be the exact one, the largest error.
  enum class Figure { order, largest_error };

  std::string quantity;  ///< what is compared with the exact solution, and in which norm
  std::string refined;   ///< what `refinements` counts: "cells", "steps"
  Figure figure = Figure::order;
  double low = 0, high = 0;         ///< band of the figure
  std::string why;                  ///< where the band comes from
  std::vector<double> refinements;  ///< rising
  std::vector<double> errors;       ///< relative, one for each refinement

  double value() const;
  bool holds() const { return value() >= low && value() <= high; }
};

/// An exact solution that the solver is run against.
struct Case {
  const char* name;
  const char* solution;  ///< one line for the table
  std::vector<Errors> (*measure)(bool quick);
};

/// All cases. To add one, add a line.
const std::vector<Case>& all_cases();

}  // namespace bake::studies

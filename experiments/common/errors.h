// SPDX-License-Identifier: MIT
// The errors of one quantity at several refinements, and what theory expects of them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bake::studies {

struct Errors {
  /// The number that is judged: the fitted order of convergence or, if the discrete solution should be exact, the largest error.
  enum class Figure { order, largest_error };

  std::string quantity;  ///< what is compared with the exact solution, and in which norm
  std::string refined;   ///< what `refinements` counts: "cells", "steps"
  Figure figure = Figure::order;
  double low = 0, high = 0;         ///< the band in which that number must lie
  std::string why;                  ///< where the band comes from
  std::vector<double> refinements;  ///< rising
  std::vector<double> errors;       ///< relative, one for each refinement

  double value() const;
  bool holds() const { return value() >= low && value() <= high; }
};

/// One line: the quantity, its errors, figure, band and verdict.
std::string in_words(const Errors& errors);

/// "0.8 to 1.2" or "at most 1e-12".
std::string band_in_words(const Errors& errors);

/// The errors with three significant digits each.
std::vector<std::string> short_numbers(const std::vector<double>& values);

/// All members as JSON.
nlohmann::json as_json(const Errors& errors);

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// The order of convergence: how fast errors fall.
#pragma once

#include <span>

namespace bake::studies {

/// Least-squares slope of -ln(error) against ln(refinement): 2 if twice as many cells or steps leave a quarter of the error.
/// `refinements` and `errors` are above 0 and equally many, at least two.
double fitted_order(std::span<const double> refinements, std::span<const double> errors);

}  // namespace bake::studies

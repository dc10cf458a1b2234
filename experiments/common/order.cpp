// SPDX-License-Identifier: MIT
#include "experiments/common/order.h"

#include <cmath>

namespace bake::studies {

double fitted_order(std::span<const double> refinements, std::span<const double> errors) {
  const auto n = static_cast<double>(errors.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double a = std::log(refinements[i]), b = -std::log(errors[i]);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace bake::studies

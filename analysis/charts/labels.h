// SPDX-License-Identifier: MIT
// Places the texts of marks so that they can be read.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/charts/chart.h"

namespace bake::charts {

/// Least and largest number on an axis.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(const std::vector<double>& column) {
    for (const double value : column)
      if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
  }
};

/// The side of each mark of a panel. A mark with Side::free gets the side of right, left, above and below on which its text covers least of
/// what is drawn and of other texts; the size of letters is estimated. `across`, `up`: extents of the axes; `width` and `height` of the
/// area between them and the height of `letters` are in one unit.
std::vector<Side> label_sides(const Panel& panel, const Extent& across, const Extent& up, double width, double height, double letters);

}  // namespace bake::charts

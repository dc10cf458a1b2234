// SPDX-License-Identifier: MIT
// Writes a chart as a gnuplot script.
#pragma once

#include <string>

#include "analysis/charts/chart.h"

namespace bake::charts {

/// A script that draws the chart twice, as chart.svg and chart.pdf in the folder in which gnuplot runs.
std::string gnuplot_script(const Chart& chart);

}  // namespace bake::charts

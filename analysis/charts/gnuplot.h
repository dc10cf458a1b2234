// SPDX-License-Identifier: MIT
// A chart in the words of gnuplot.
#pragma once

#include <string>

#include "analysis/charts/chart.h"

namespace bake::charts {

/// A script that draws the chart twice: into chart.svg and chart.pdf of the folder in which gnuplot is started.
std::string gnuplot_script(const Chart& chart);

}  // namespace bake::charts

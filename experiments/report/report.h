// SPDX-License-Identifier: MIT
// The report: one page that holds everything that was claimed and measured, with pictures, to be opened without a network.
#pragma once

#include <filesystem>

#include "experiments/make/items.h"
#include "solver/scene/settings.h"

namespace bake::report {

/// What came of the items at one quality: the page, and how many of each verdict.
struct Report {
  std::string page;
  int reproduced = 0, not_reproduced = 0, not_run = 0, not_there_yet = 0;
};

/// From results/items/<item>-<quality>/ in the working folder and the tables of studies in <root>/paper. Throws InputError for a damaged
/// file.
Report make_report(const Items& items, Quality quality);

}  // namespace bake::report

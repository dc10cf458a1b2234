// SPDX-License-Identifier: MIT
// The report: one page with all claims, measurements and pictures. It can be opened without a network.
#pragma once

#include "experiments/make/items.h"
#include "solver/scene/settings.h"

namespace bake::report {

/// The page for one quality, and how many items have each verdict.
struct ReportPage {
  std::string page;
  int reproduced = 0, not_reproduced = 0, not_run = 0, not_there_yet = 0;
};

/// Makes the page from results/items/<item>-<quality>/ in the working folder and from the tables of studies in <root>/paper. Throws
/// InputError if a file is damaged.
ReportPage make_report(const Items& items, Quality quality);

}  // namespace bake::report

// SPDX-License-Identifier: MIT
// Makes the checked figure of an item of the paper.
#pragma once

#include "experiments/make/computed.h"
#include "experiments/make/figure_paths.h"

namespace bake {

/// The result of making an item.
struct MadeFigure {
  std::vector<ClaimVerdict> verdicts;  ///< empty if only one run was asked for
  std::vector<ComputedTable> tables;
  std::filesystem::path folder;  ///< results/items/<item>-<quality>

  bool holds() const;  ///< whether there are claims and every one holds
};

/// The item's figure.toml, and the names of what its function computes.
struct ReadFigure {
  Figure figure;
  Computed computed;
};
/// Throws InputError for an item that is not done.
ReadFigure read_figure(const Items& items, const Item& item);

/// Makes what is missing: runs, surfaces, pictures, charts; checks the claims and writes claims.json. Throws as experiments/make/pipeline.h
/// says.
MadeFigure make_figure(const Items& items, const Item& item, const MakeOptions& options);

}  // namespace bake

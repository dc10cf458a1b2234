// SPDX-License-Identifier: MIT
// From an item of the paper to its checked figure.
#pragma once

#include "experiments/make/computed.h"
#include "experiments/make/figure_paths.h"

namespace bake {

/// What came of an item.
struct MadeFigure {
  std::vector<ClaimVerdict> verdicts;  ///< empty if only one run was asked for
  std::vector<ComputedTable> tables;
  std::filesystem::path folder;  ///< results/items/<item>-<quality>

  bool holds() const;  ///< every claim
};

/// The item's figure.toml, and what its own function computes.
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

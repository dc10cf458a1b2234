// SPDX-License-Identifier: MIT
// The steps from a figure.toml to a checked figure, in their order. Each makes only what is missing or out of date.
// All throw InputError (bad input, a program is missing), RunError (a run or program failed or was interrupted) and OutputError.
#pragma once

#include "experiments/make/computed.h"
#include "experiments/make/figure_paths.h"

namespace bake {

/// Simulates the runs, with meshes of tetrahedra where they are asked for.
void make_runs(const FigurePaths& paths);
/// Fracture surfaces, into <item>/<surface>/.
void make_surfaces(const FigurePaths& paths);
/// Pictures, into <item>/<picture>.png.
void make_pictures(const FigurePaths& paths);
/// Charts, into <item>/<chart>.svg, .pdf and .csv.
void make_charts(const FigurePaths& paths, const Computed& computed);
/// Tables that the item's own function computes, into <item>/<table>.csv and .md.
void write_tables(const FigurePaths& paths, const Computed& computed);
/// Measures every claim.
std::vector<ClaimVerdict> check_claims(const FigurePaths& paths, const Computed& computed);
/// <item>/claims.json: verdicts, and what the report needs to know of runs, pictures and charts.
void write_claims(const FigurePaths& paths, const Computed& computed, const std::vector<ClaimVerdict>& verdicts);

}  // namespace bake

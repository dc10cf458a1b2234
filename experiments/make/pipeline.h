// SPDX-License-Identifier: MIT
// The stages from a figure.toml to a checked figure, in their order. Each stage makes only what is missing or out of date.
// All throw InputError (bad input, or a program is missing), RunError (a run or program failed or was interrupted) and OutputError.
#pragma once

#include "experiments/make/computed.h"
#include "experiments/make/figure_paths.h"

namespace bake {

/// Simulates the runs, also those of other figures that pictures show, from meshes of tetrahedra where the figure asks for them.
void make_runs(const FigurePaths& paths);
/// Makes fracture surfaces in <item>/<surface>/.
void make_surfaces(const FigurePaths& paths);
/// Makes pictures and montages of them: <item>/<picture>.png, and .jpg for the report.
void make_pictures(const FigurePaths& paths);
/// Makes what the report turns: surfaces and particles of a few frames in <item>/<object>/<run>/.
void make_objects(const FigurePaths& paths);
/// Makes charts: <item>/<chart>.svg, .pdf and .csv.
void make_charts(const FigurePaths& paths, const Computed& computed);
/// Writes the tables that the item's function computes: <item>/<table>.csv and .md.
void write_tables(const FigurePaths& paths, const Computed& computed);
/// Adds what is known of the parts of other figures that pictures show: of each the share of its claims that hold, and a table.
void add_parts(const FigurePaths& paths, Computed& computed);
/// Measures every claim.
std::vector<ClaimVerdict> check_claims(const FigurePaths& paths, const Computed& computed);
/// Writes <item>/claims.json: the verdicts, and what the report needs of runs, pictures and charts.
void write_claims(const FigurePaths& paths, const Computed& computed, const std::vector<ClaimVerdict>& verdicts);

}  // namespace bake

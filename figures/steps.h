// SPDX-License-Identifier: MIT
// The steps from a figure.toml to a checked figure, in their order. Each makes only what is missing or out of date.
// All throw InputError (bad input, a program is missing), RunError (a run or program failed or was interrupted) and OutputError.
#pragma once

#include "figures/computed.h"
#include "figures/place.h"

namespace bake {

/// Simulates the runs, with meshes of tetrahedra where they are asked for.
void make_runs(const Place& place);
/// Fracture surfaces, into <item>/<surface>/.
void make_surfaces(const Place& place);
/// Pictures, into <item>/<picture>.png.
void make_pictures(const Place& place);
/// Charts, into <item>/<chart>.svg, .pdf and .csv.
void make_charts(const Place& place, const Computed& computed);
/// Tables that the item's own function computes, into <item>/<table>.csv and .md.
void write_tables(const Place& place, const Computed& computed);
/// Measures every claim.
std::vector<ClaimVerdict> check_claims(const Place& place, const Computed& computed);
/// <item>/claims.json: verdicts, and what the report needs to know of runs, pictures and charts.
void write_claims(const Place& place, const Computed& computed, const std::vector<ClaimVerdict>& verdicts);

}  // namespace bake

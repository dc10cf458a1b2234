// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the `bake-mesh` program. Each function adds a command to the command line. The command that the user requests sets
// `action`, which does the work.
#pragma once

#include "solver/program/program.h"

namespace bake::cli {

void add_tets_command(CLI::App& app, Action& action);
void add_skin_command(CLI::App& app, Action& action);
void add_fracture_command(CLI::App& app, Action& action);

}  // namespace bake::cli

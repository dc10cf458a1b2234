// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the `bake-mesh` program. Each adds itself to the command line and, if it is the one that was asked for, leaves in
// `action` what is to be done.
#pragma once

#include "solver/program/program.h"

namespace bake::cli {

void add_tets_command(CLI::App& app, Action& action);
void add_skin_command(CLI::App& app, Action& action);
void add_fracture_command(CLI::App& app, Action& action);

}  // namespace bake::cli

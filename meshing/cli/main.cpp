// SPDX-License-Identifier: GPL-3.0-or-later
// The `bake-mesh` program.
#include "meshing/cli/commands.h"

int main(int count, char** words) {
  using namespace bake::cli;
  CLI::App app("Makes meshes for Bake: tetrahedra whose vertices are particles, skins, and the surfaces of broken pieces.", "bake-mesh");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  Action action;
  add_tets_command(app, action);
  add_skin_command(app, action);
  add_fracture_command(app, action);
  return run_program(app, action, count, words);
}

// SPDX-License-Identifier: MIT
// The `bake` program.
#include "cli/commands.h"

int main(int count, char** words) {
  using namespace bake::cli;
  CLI::App app("Bake simulates baking: dough as a mixture of solid, water and gas, by the material point method.", "bake");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.set_version_flag("--version", version_line, "Print the version and exit");
  app.require_subcommand(1);
  Action action;
  add_run_command(app, action);
  add_scene_commands(app, action);
  add_compare_textbook_command(app, action);
  add_check_commands(app, action);
  add_figure_commands(app, action);
  add_report_command(app, action);
  add_study_command(app, action);
  add_compare_command(app, action);
  add_help_commands(app, action);
  app.footer("Through the script ./bake there are also the commands test, bench, mesh, render and paper, and --no-install.");
  return run_program(app, action, count, words);
}

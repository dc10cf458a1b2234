// SPDX-License-Identifier: MIT
// The `bake-render` program.
#include "analysis/cli/commands.h"

int main(int count, char** words) {
  using namespace bake::render;
  CLI::App app("Makes pictures of the results of bake run. Needs no display.", "bake-render");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  Action action;
  add_picture_command(app, action);
  add_slice_command(app, action);
  add_movie_command(app, action);
  add_montage_command(app, action);
  add_surface_command(app, action);
  add_model_command(app, action);
  add_jpeg_command(app, action);
  add_explain_command(app, action);
  return bake::cli::run_program(app, action, count, words);
}

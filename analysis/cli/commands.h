// SPDX-License-Identifier: MIT
// The commands of the `bake-render` program. Each adds itself to the command line and, if it is the one that was asked for, leaves in
// `action` what is to be done.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/pictures/view.h"
#include "solver/program/program.h"

namespace bake::render {

using cli::Action, cli::k_success;

void add_picture_command(CLI::App& app, Action& action);
void add_slice_command(CLI::App& app, Action& action);
void add_movie_command(CLI::App& app, Action& action);
void add_montage_command(CLI::App& app, Action& action);
void add_surface_command(CLI::App& app, Action& action);
void add_explain_command(CLI::App& app, Action& action);

/// Options that a picture and a movie share: size, samples, threads, runs, single values of the view.
struct PictureOptions {
  std::filesystem::path view;
  std::vector<std::filesystem::path> results;
  std::vector<std::string> overrides;
  std::string size;
  int samples = 0;
  int threads = 0;

  void add_to(CLI::App& command);
  /// The view with the options put in. Throws InputError.
  View read() const;
  /// The folder of the run of each of `files`: one given for each, one for all, or none.
  std::vector<std::filesystem::path> results_of(std::size_t files) const;
};

/// `threads`, or as many as the machine runs at once if it is 0.
int thread_count(int threads);
void add_threads_option(CLI::App& command, int& threads);

/// Throws InputError unless the file's name ends in `ending`.
void check_ending(const std::filesystem::path& file, const char* ending);

}  // namespace bake::render

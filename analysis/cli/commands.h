// SPDX-License-Identifier: MIT
// The commands of the `bake-render` program. Each function adds a command to the command line. The command that the user requests sets
// `action`, which does the work.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/pictures/view.h"
#include "solver/program/program.h"

namespace bake::render {

using cli::Action, cli::add_threads_option, cli::number, cli::on_request, cli::whole_number;

void add_picture_command(CLI::App& app, Action& action);
void add_slice_command(CLI::App& app, Action& action);
void add_movie_command(CLI::App& app, Action& action);
void add_montage_command(CLI::App& app, Action& action);
void add_surface_command(CLI::App& app, Action& action);
void add_model_command(CLI::App& app, Action& action);
void add_jpeg_command(CLI::App& app, Action& action);
void add_explain_command(CLI::App& app, Action& action);

/// The options that pictures and movies share: size, samples, threads, folders of runs, single values of the view.
struct PictureOptions {
  std::filesystem::path view;
  std::vector<std::filesystem::path> results;
  std::vector<std::string> overrides;
  std::string size;
  int samples = 0;
  int threads = 0;

  void add_to(CLI::App& command);
  /// Reads the view and applies the options. Throws InputError.
  View read() const;
  /// The folder of the run of each file: the user gives one for each file, one for all, or none.
  std::vector<std::filesystem::path> results_of(std::size_t files) const;
};

/// `threads`, or the number of the machine's threads if it is 0.
int thread_count(int threads);

/// Width and height of "640x480", given by that option. Throws InputError.
std::pair<int, int> size_in_pixels(const std::string& option, const std::string& size);

/// Throws InputError unless the file's name ends in `ending`.
void check_ending(const std::filesystem::path& file, const char* ending);

}  // namespace bake::render

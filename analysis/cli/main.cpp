// SPDX-License-Identifier: MIT
// The `bake-render` program: reads the command line, runs one command, and turns every error into one line and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <new>

#include "analysis/cli/commands.h"
#include "solver/io/atomic_file.h"
#include "solver/scene/input_error.h"
#include "solver/scene/nearest.h"

namespace bake::render {
namespace {

int fail(ExitCode code, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "bake-render: {}\n", message);
  return code;
}

/// CLI11 alone would call a misspelt command an unexpected argument.
void check_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(command->get_name());
  if (arguments.empty()) throw InputError(fmt::format("no command given; commands: {} (see bake-render --help)", fmt::join(names, ", ")));
  const std::string& word = arguments.front();
  if (word.substr(0, 1) == "-" || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw InputError(fmt::format("unknown command '{}'; {}", word, suggestion(word, names)));
}

int run_command_line(std::vector<std::string> arguments) {
  CLI::App app("Makes pictures of what bake has run. Needs no display.", "bake-render");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  Action action;
  add_picture_command(app, action);
  add_slice_command(app, action);
  add_movie_command(app, action);
  add_montage_command(app, action);
  add_surface_command(app, action);
  add_explain_command(app, action);
  check_command(app, arguments);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    return fail(k_wrong_use, error.what());
  }
  action();
  return k_success;
}

}  // namespace
}  // namespace bake::render

int main(int count, char** words) {
  using namespace bake::render;
  try {
    return run_command_line({words + 1, words + count});
  } catch (const bake::InputError& error) {
    return fail(k_wrong_use, error.what());
  } catch (const bake::OutputError& error) {
    return fail(k_wrong_use, error.what());
  } catch (const std::bad_alloc&) {
    return fail(k_failed_run, "out of memory");
  } catch (const std::exception& error) {
    return fail(k_failed_run, error.what());
  }
}

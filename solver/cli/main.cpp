// SPDX-License-Identifier: MIT
// The `bake` program: reads the command line, runs one command, and turns every error into one line and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <new>

#include "solver/cli/commands.h"
#include "solver/io/atomic_file.h"
#include "solver/scene/nearest.h"

namespace bake::cli {
namespace {

int fail(ExitCode code, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "bake: {}\n", message);
  return code;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(command->get_name());
  return names;
}

/// CLI11 alone would call a misspelt command an unexpected argument.
void check_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<std::string> names = command_names(app);
  if (arguments.empty()) throw InputError(fmt::format("no command given; commands: {} (see bake --help)", fmt::join(names, ", ")));
  const std::string& word = arguments.front();
  if (word.substr(0, 1) == "-" || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw InputError(fmt::format("unknown command '{}'; {}", word, suggestion(word, names)));
}

int run_command_line(std::vector<std::string> arguments) {
  CLI::App app("Bake simulates baking: dough as a mixture of solid, water and gas, by the material point method.", "bake");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.set_version_flag("--version", version_line, "Print the version and exit");
  app.require_subcommand(1);
  Action action;
  add_run_command(app, action);
  add_scene_commands(app, action);
  add_compare_command(app, action);
  add_check_commands(app, action);
  add_figure_commands(app, action);
  add_report_command(app, action);
  add_study_command(app, action);
  add_help_commands(app, action);
  app.footer("Through the script ./bake there are also the commands test, bench, mesh and render, and --no-install.");

  check_command(app, arguments);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    return fail(k_wrong_use, error.what());
  }
  return action();
}

}  // namespace

void add_quality_option(CLI::App& command, Quality& quality) {
  constexpr auto names = choice_names(Quality{});
  const auto store = [&quality, names](const std::string& word) {
    quality = static_cast<Quality>(std::find(names.begin(), names.end(), word) - names.begin());
  };
  command.add_option_function<std::string>("--quality", store, "resolution [draft]")
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
}

}  // namespace bake::cli

int main(int count, char** words) {
  using namespace bake::cli;
  try {
    return run_command_line({words + 1, words + count});
  } catch (const bake::InputError& error) {
    return fail(k_wrong_use, error.what());
  } catch (const bake::OutputError& error) {  // a full disk, a folder that cannot be written
    return fail(k_wrong_use, error.what());
  } catch (const std::bad_alloc&) {
    return fail(k_failed_run, "out of memory");
  } catch (const std::exception& error) {
    return fail(k_failed_run, error.what());
  }
}

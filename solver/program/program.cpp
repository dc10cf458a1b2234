// SPDX-License-Identifier: MIT
#include "solver/program/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>

#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/program/waiting.h"
#include "solver/scene/nearest.h"

namespace bake::cli {
namespace {

int fail(const CLI::App& app, ExitCode code, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "{}: {}\n", app.get_name(), message);
  return code;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) names.push_back(command->get_name());
  return names;
}

/// Without this check CLI11 would call a misspelt command an unexpected argument.
void check_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<std::string> names = command_names(app);
  if (arguments.empty())
    throw InputError(fmt::format("no command given; commands: {} (see {} --help)", fmt::join(names, ", "), app.get_name()));
  const std::string& word = arguments.front();
  if (word.substr(0, 1) == "-" || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw InputError(fmt::format("unknown command '{}'; {}", word, suggestion(word, names)));
}

int run_command_line(CLI::App& app, const Action& action, std::vector<std::string> arguments) {
  check_command(app, arguments);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 reads them from the back
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    return fail(app, k_wrong_use, error.what());
  }
  return action();
}

}  // namespace

int run_program(CLI::App& app, const Action& action, int count, char** words) {
  let_waiting_threads_sleep(words);
  try {
    return run_command_line(app, action, {words + 1, words + count});
  } catch (const InputError& error) {
    return fail(app, k_wrong_use, error.what());
  } catch (const OutputError& error) {  // a full disk, a folder that cannot be written
    return fail(app, k_wrong_use, error.what());
  } catch (const std::bad_alloc&) {
    return fail(app, k_failed_run, "out of memory");
  } catch (const std::exception& error) {
    return fail(app, k_failed_run, error.what());
  }
}

void add_quality_option(CLI::App& command, Quality& quality) {
  constexpr auto names = choice_names(Quality{});
  const auto store = [&quality, names](const std::string& word) {
    quality = static_cast<Quality>(std::find(names.begin(), names.end(), word) - names.begin());
  };
  command.add_option_function<std::string>("--quality", store, "resolution [draft]")
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
}

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "threads [all cores]; the results do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

void add_set_option(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "override any scene key (see `bake explain`); can be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

}  // namespace bake::cli

// SPDX-License-Identifier: MIT
#include "solver/program/program.h"

#include <cxxabi.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>
#include <utility>

#include "solver/core/errors.h"
#include "solver/core/tell.h"
#include "solver/io/atomic_file.h"
#include "solver/program/waiting.h"
#include "solver/scene/nearest.h"

namespace bake::cli {
namespace {

/// Is the whole text a number?
template <class Number>
bool reads(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

constexpr const char* k_not_printed = "cannot write to the standard output";

int fail(const CLI::App& app, ExitCode code, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  tell_user("{}: {}", app.get_name(), message);
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

/// A standard stream that is closed would give its number to the next file that is opened, and what is printed would go into that.
void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDONLY) < 0) return;  // read only: to print there fails as before
}

/// What a failed call of the system says; nothing of the library that called it.
std::string reason_of(const std::filesystem::filesystem_error& error) {
  return fmt::format("{}: {}", error.path1().string(), error.code().message());
}

/// Which kind of error a library or we ourselves threw; what it says is for programmers.
std::string type_name(const std::exception& error) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), std::free);
  return name ? name.get() : "unknown";
}

int run_and_tell_errors(CLI::App& app, const Action& action, std::vector<std::string> arguments) {
  try {
    return run_command_line(app, action, std::move(arguments));
  } catch (const InputError& error) {
    return fail(app, k_wrong_use, error.what());
  } catch (const UnfinishedOutputError& error) {
    return fail(app, k_failed_run, error.what());
  } catch (const OutputError& error) {  // a folder that cannot be written; a run that has begun throws RunError
    return fail(app, k_wrong_use, error.what());
  } catch (const RunError& error) {
    return fail(app, k_failed_run, error.what());
  } catch (const std::bad_alloc&) {
    return fail(app, k_failed_run, "out of memory");
  } catch (const std::length_error&) {  // more numbers than an array can have
    return fail(app, k_failed_run, "out of memory");
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(app, k_failed_run, reason_of(error));
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) return fail(app, k_failed_run, k_not_printed);
    return fail(app, k_failed_run, fmt::format("the system refuses: {}", error.code().message()));
  } catch (const std::exception& error) {
    return fail(app, k_failed_run, fmt::format("a fault of the program itself, please report it ({})", type_name(error)));
  }
}

}  // namespace

int run_program(CLI::App& app, const Action& action, int count, char** words) {
  hold_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may grow no further is an error that is told, as on a full disk
  let_waiting_threads_sleep(words);
  const int code = run_and_tell_errors(app, action, {words + 1, words + count});
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return code != k_success ? code : fail(app, k_failed_run, k_not_printed);
}

CLI::Validator whole_number(std::int64_t low, std::int64_t high) {
  const auto take = [low, high](std::string& text) -> std::string {
    std::int64_t value = 0;
    if (!reads(text, value) || value < low || value > high)
      return fmt::format("found {}, allowed: a whole number from {} to {}", text, low, high);
    text = std::to_string(value);  // without leading zeros, in which CLI11 would see base eight
    return {};
  };
  return {take, ""};
}

CLI::Validator number(double low, double high, const char* unit) {
  const auto check = [=](std::string& text) -> std::string {
    double value = 0;
    if (reads(text, value) && value >= low && value <= high) return {};
    return fmt::format("found {}, allowed: a number from {} to {}{}{}", text, low, high, *unit ? " " : "", unit);
  };
  return {check, ""};
}

CLI::Validator not_empty() {
  const auto check = [](std::string& text) { return text.empty() ? std::string("found an empty name, allowed: a path") : std::string(); };
  return {check, ""};
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
      ->transform(whole_number(1, 4096));
}

void add_set_option(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "override any scene key (see `bake explain`); can be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

}  // namespace bake::cli

// SPDX-License-Identifier: MIT
#include "experiments/make/programs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <mutex>

#include "solver/core/errors.h"
#include "solver/io/child.h"
#include "solver/io/progress.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// The last line that is not empty, without terminal control sequences.
std::string last_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line, last;
  while (std::getline(in, line)) {
    if (const auto redraw = line.rfind('\r'); redraw != std::string::npos && redraw + 1 < line.size()) line.erase(0, redraw + 1);
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last;
}

}  // namespace

fs::path find_program(const std::string& name) {
  std::error_code ignored;
  fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path() / name;
  if (!fs::exists(program, ignored))
    throw InputError(
        fmt::format("{}: found no such program beside bake, allowed: one built by ./bake figure (cmake -D BAKE_FIGURES=ON)", name));
  return program;
}

void call_program(const std::string& name, const std::vector<std::string>& arguments, const fs::path& log, bool quiet,
                  const std::string& doing) {
  const fs::path program = find_program(name);
  const std::string& called = doing.empty() ? name : doing;
  fs::create_directories(log.parent_path());
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), program.string());
  static std::mutex telling;
  const std::unique_lock tells(telling, std::try_to_lock);
  quiet = quiet || !tells;
  Meter meter(called, progress_on_stderr(quiet));
  std::string told;
  double told_s = steady_seconds();
  const auto tell = [&] {  // on a terminal at once, in a log now and then
    const std::string line = last_line(log);
    const double between_s = isatty(STDERR_FILENO) ? 0 : 10;
    if (line.empty() || line == told || steady_seconds() - told_s < between_s) return;
    meter.phase(line);
    told = line;
    told_s = steady_seconds();
  };
  const auto [start_error, code] = run_child(std::move(words), log, quiet ? std::function<void()>() : tell);
  meter.clear();
  if (start_error != 0) throw InputError(fmt::format("{}: cannot be started: {}", program.string(), std::strerror(start_error)));
  if (code == 0) return;
  std::string line = last_line(log);
  for (const auto& own : {name + ": ", std::string("bake: ")})  // the message names the program already
    if (line.starts_with(own)) line.erase(0, own.size());
  if (code == 2) throw InputError(fmt::format("{}: {}", called, line));
  throw RunError(fmt::format("{}: exit {}: {} (log: {})", called, code, line.empty() ? "no message" : line, log.string()));
}

}  // namespace bake

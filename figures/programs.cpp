// SPDX-License-Identifier: MIT
#include "figures/programs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstring>
#include <fstream>

#include "solver/baker/run_error.h"
#include "solver/io/atomic_file.h"
#include "solver/scene/entry.h"
#include "solver/scene/input_error.h"

extern char** environ;

namespace bake {
namespace {

namespace fs = std::filesystem;

/// How a child opens its files.
class FileActions {
 public:
  explicit FileActions(const fs::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions_, 1, 2);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// Its exit code, or 128 + the signal that ended it, as shells have it.
int run_and_wait(const fs::path& program, std::vector<std::string> words, const fs::path& log) {
  words.insert(words.begin(), program.string());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const FileActions actions(log);
  pid_t child = 0;
  if (const int error = posix_spawn(&child, program.c_str(), actions.get(), nullptr, pointers.data(), environ); error != 0)
    throw InputError(fmt::format("{}: cannot be started: {}", program.string(), std::strerror(error)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The last line that says something, without what the terminal was told to do before it.
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
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path() / name;
  if (!fs::exists(program, ignored))
    throw InputError(
        fmt::format("{}: found no such program beside bake, allowed: one built by ./bake figure (cmake -D BAKE_FIGURES=ON)", name));
  return program;
}

void call_program(const std::string& name, const std::vector<std::string>& arguments, const fs::path& log) {
  const fs::path program = find_program(name);
  fs::create_directories(log.parent_path());
  const int code = run_and_wait(program, arguments, log);
  if (code == 0) return;
  std::string line = last_line(log);
  for (const auto& own : {name + ": ", std::string("bake: ")})  // its own name is in front of ours anyway
    if (line.starts_with(own)) line.erase(0, own.size());
  if (code == 2) throw InputError(fmt::format("{}: {}", name, line));
  throw RunError(fmt::format("{}: exit {}: {} (log: {})", name, code, line.empty() ? "it says nothing" : line, log.string()));
}

}  // namespace bake

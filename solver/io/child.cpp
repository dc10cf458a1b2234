// SPDX-License-Identifier: MIT
#include "solver/io/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "solver/io/processors.h"
#include "solver/io/stop_signals.h"

namespace bake {
namespace {

/// How a child opens its files.
class FileActions {
 public:
  explicit FileActions(const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    if (log.empty()) return;
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

}  // namespace

ChildEnd run_child(std::vector<std::string> words, const std::filesystem::path& log, const std::function<void()>& meanwhile) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const FileActions actions(log);
  pid_t child = 0;
  {
    const Unbound unbound;
    if (const int error = posix_spawnp(&child, pointers[0], actions.get(), nullptr, pointers.data(), environ); error != 0)
      return {error, 0};
  }
  constexpr int k_between_ms = 10;
  int status = 0, waited_ms = 0;
  bool is_asked_to_stop = false;
  for (;;) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) break;
    if (ended != 0) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(k_between_ms));
    waited_ms += k_between_ms;
    if (waited_ms % 250 == 0 && meanwhile) meanwhile();
    if (StopSignals::asked() && !std::exchange(is_asked_to_stop, true)) ::kill(child, SIGTERM);
  }
  return {0, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
}

}  // namespace bake

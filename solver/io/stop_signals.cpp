// SPDX-License-Identifier: MIT
#include "solver/io/stop_signals.h"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace bake {
namespace {

std::atomic<std::int64_t> g_asked_ns = 0;  ///< when the user asked first, set by a handler, read by all threads; 0: not yet
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

/// Soon after the first, another one is the same wish: `timeout` and batch systems signal a process and then its group.
void note(int signal) {
  constexpr std::int64_t k_soon_ns = 1'000'000'000;
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t now_ns = std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
  std::int64_t first = 0;
  if (g_asked_ns.compare_exchange_strong(first, now_ns) || now_ns - first < k_soon_ns) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

StopSignals::StopSignals() {
  for (std::size_t i = 0; i < k_count; ++i) {
    struct sigaction action {};
    action.sa_handler = k_signals[i] == SIGPIPE ? SIG_IGN : note;
    sigaction(k_signals[i], nullptr, &old_[i]);
    const bool is_shielded = k_signals[i] == SIGHUP && old_[i].sa_handler == SIG_IGN;  // by nohup
    if (!is_shielded) sigaction(k_signals[i], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < k_count; ++i) sigaction(k_signals[i], &old_[i], nullptr);
  g_asked_ns = 0;
}

bool StopSignals::asked() { return g_asked_ns != 0; }

}  // namespace bake

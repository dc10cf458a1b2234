// SPDX-License-Identifier: MIT
#include "solver/io/stop_signals.h"

#include <atomic>

namespace bake {
namespace {

std::atomic<bool> g_stop_asked = false;  ///< set by a handler, read by all threads
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

StopSignals::StopSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { g_stop_asked = true; };
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, &old_int_);
  sigaction(SIGTERM, &action, &old_term_);
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &old_int_, nullptr);
  sigaction(SIGTERM, &old_term_, nullptr);
  g_stop_asked = false;
}

bool StopSignals::asked() { return g_stop_asked; }

}  // namespace bake

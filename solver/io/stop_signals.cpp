// SPDX-License-Identifier: MIT
#include "solver/io/stop_signals.h"

namespace bake {
namespace {

volatile std::sig_atomic_t g_stop_asked = 0;

}  // namespace

StopSignals::StopSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { g_stop_asked = 1; };
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, &old_int_);
  sigaction(SIGTERM, &action, &old_term_);
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &old_int_, nullptr);
  sigaction(SIGTERM, &old_term_, nullptr);
  g_stop_asked = 0;
}

bool StopSignals::asked() { return g_stop_asked != 0; }

}  // namespace bake

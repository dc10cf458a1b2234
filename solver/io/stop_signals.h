// SPDX-License-Identifier: MIT
// Ends long work in order when the user asks for it.
#pragma once

#include <csignal>

namespace bake {

/// While one is there, the first SIGINT or SIGTERM ends nothing but is noted: who works asks for it and stops where nothing is lost. A
/// second one ends the program as usual. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  /// Whether one has come to those that are there.
  static bool asked();

 private:
  struct sigaction old_int_, old_term_;
};

}  // namespace bake

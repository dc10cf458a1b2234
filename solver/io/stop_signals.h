// SPDX-License-Identifier: MIT
// Ends long work in order when the user asks for it.
#pragma once

#include <csignal>
#include <iterator>

namespace bake {

/// While one is there, SIGINT, SIGTERM and SIGHUP (a terminal that is closed) end nothing but are noted: who works asks for it and stops
/// where nothing is lost. One that comes a second or more later ends the program as usual. What nobody reads any more (SIGPIPE) is an error
/// of writing. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  /// Whether one has come to those that are there.
  static bool asked();

 private:
  static constexpr int k_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
  static constexpr std::size_t k_count = std::size(k_signals);
  struct sigaction old_[k_count];
};

}  // namespace bake

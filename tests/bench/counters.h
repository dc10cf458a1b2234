// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace bake::bench {

/// Sets a counter of a benchmark (benchmark::State::counters). What is not finite is left out: the library would write a bare NaN into
/// its file, which then is no JSON.
template <class Counters>
void set_counter(Counters& counters, const char* name, double value) {
  if (std::isfinite(value)) counters[name] = value;
}

}  // namespace bake::bench

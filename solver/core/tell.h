// SPDX-License-Identifier: MIT
// Lines to standard error.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace bake {

/// Prints a line to standard error. Where that is closed or its disk is full the line is lost, and nothing else: fmt::print would throw,
/// which ends a program that is about to tell what has failed.
template <class... Parts>
void tell_user(fmt::format_string<Parts...> text, Parts&&... parts) {
  const std::string line = fmt::format(text, std::forward<Parts>(parts)...) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace bake

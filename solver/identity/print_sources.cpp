// SPDX-License-Identifier: MIT
// Prints what the solver's identity is the hash of. Usage: bake-sources <folder of the solver>
#include <cstdio>
#include <exception>

#include "solver/identity/canonical_source.h"

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fputs("usage: bake-sources <folder>\n", stderr);
    return 2;
  }
  const std::string text = bake::canonical_sources(arguments[1]);
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

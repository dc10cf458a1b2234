// SPDX-License-Identifier: MIT
// Pages of docs/ that the program writes of itself.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/temporary_folder.h"

namespace bake {

/// docs/<name> is committed as it is generated now; with BAKE_WRITE_DOCS in the environment it is written.
inline void expect_page(const std::string& name, const std::string& page) {
  const std::string file = BAKE_SOURCE_DIR "/docs/" + name;
  if (std::getenv("BAKE_WRITE_DOCS")) std::ofstream(file) << page;
  EXPECT_EQ(contents(file), page) << "the first line of " << file << " says how it is written anew";
}

}  // namespace bake

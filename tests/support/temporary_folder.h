// SPDX-License-Identifier: MIT
// A folder of its own for a test, gone when the test ends; and what went wrong.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "solver/io/scratch_folder.h"

namespace bake {

using TemporaryFolder = ScratchFolder;

/// All bytes of a file.
inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The one line of the error that `action` must throw.
template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception& other) {
    return std::string("another exception: ") + other.what();
  }
  return "nothing was thrown";
}

}  // namespace bake

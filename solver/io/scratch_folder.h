// SPDX-License-Identifier: MIT
// A folder for files that are soon read again.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "solver/io/atomic_file.h"

namespace bake {

/// A new empty folder of its own among the system's temporary ones, removed at the end with all that is in it.
class ScratchFolder {
 public:
  /// Throws OutputError if none can be made.
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bake-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw OutputError(pattern + ": cannot create a folder there");
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace bake

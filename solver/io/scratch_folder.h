// SPDX-License-Identifier: MIT
// A temporary folder for files that the same program reads again.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "solver/io/atomic_file.h"

namespace bake {

/// A new, empty folder in the system's temporary folder. The destructor removes it with its contents.
class ScratchFolder {
 public:
  /// Throws OutputError if the folder cannot be created.
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

// SPDX-License-Identifier: MIT
// A lock that tells whether another process writes somewhere.
#pragma once

#include <filesystem>

#include "solver/core/errors.h"

namespace bake {

/// A lock on a file that lasts as long as the object or the process: the kernel releases it however the process ends, so that no lock is
/// ever stale. The file stays where it is and names the process that locked it last. Where the file system has no locks there is no lock.
class FileLock {
 public:
  /// Makes the file if it is missing. Throws InputError if another process has locked it, OutputError if it cannot be made.
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Whether the file that was locked still stands in its place: false once somebody has removed or moved it, or its folder.
  bool stands() const;

 private:
  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace bake

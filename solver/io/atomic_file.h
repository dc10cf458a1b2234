// SPDX-License-Identifier: MIT
// Files that appear complete or not at all: they are written as `<name>.part`, flushed to disk and renamed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "solver/core/errors.h"

namespace bake {

/// A file that is written beside `target`. commit() renames it to `target`; without commit() it is removed.
/// The first failing write is remembered and thrown later by check() or commit(), because the HDF5 driver above must not see it.
class AtomicFile {
 public:
  /// Opens `<target>.part` and truncates what an interrupted run left there. Throws OutputError.
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& target() const { return target_; }
  void write_at(std::uint64_t offset, std::span<const std::byte> bytes) noexcept;
  /// Reads back what was written and returns how many bytes there were; fewer than asked for only at the end of the file.
  std::size_t read_at(std::uint64_t offset, std::span<std::byte> bytes) noexcept;
  void resize(std::uint64_t size) noexcept;
  /// Throws OutputError if anything has failed so far.
  void check() const;
  /// Flushes the file, renames it to `target` and flushes the folder. Throws OutputError, `target` is then as it was
  /// (only if the very last step fails, the new file is there but may not survive a power cut).
  void commit();
  /// The same for one of many files, whose folder is flushed once for all of them.
  void put_in_place();

 private:
  void note_failure() noexcept;

  std::filesystem::path target_;
  std::filesystem::path aside_;
  int descriptor_ = -1;
  int first_error_ = 0;  ///< errno of the first failure
};

/// Makes files that were put in place there survive a power cut. Throws OutputError.
void flush_folder(const std::filesystem::path& folder);

/// Writes `text` to `path`, completely or not at all. Throws OutputError.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace bake

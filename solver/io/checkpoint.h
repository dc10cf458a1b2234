// SPDX-License-Identifier: MIT
// Checkpoints: named arrays and values, exact to the bit, in one file whose checksum is verified before it is used.
//
// An HDF5 file behind a heading of 512 bytes in plain text: format version, size and checksum of everything that follows.
// HDF5 tools open it as usual (they skip the heading). The heading is checked first, because HDF5 1.10 can crash on damaged data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/core/errors.h"
#include "solver/io/hdf5.h"
#include "solver/scene/settings.h"

namespace bake {

inline constexpr int k_checkpoint_format = 6;
inline constexpr std::size_t k_checkpoint_heading = 512;  ///< bytes

/// Writes a checkpoint piece by piece into a temporary file; commit() renames it to `path`.
/// Every function throws OutputError. Each name can be used once.
class CheckpointWriter {
 public:
  /// `fingerprint` identifies the scene: a run that resumes must have the same one.
  CheckpointWriter(const std::filesystem::path& path, std::string_view fingerprint, Precision precision);
  template <Hdf5Number T>
  void add(const std::string& name, std::span<const T> values) {
    out_.array("arrays/" + name, values);
  }
  /// T: double, std::int64_t, std::uint64_t or text (under 64 kB).
  template <class T>
  void set(const std::string& name, const T& value) {
    out_.attribute("values", name, value);
  }
  void commit();

 private:
  AtomicFile file_;
  Hdf5Writer out_;
};

/// Reads a checkpoint. Every function throws InputError if the file is missing, no checkpoint, cut short, damaged or of
/// another format, or if a name is missing or has another type.
class CheckpointReader {
 public:
  /// Reads the whole file once to compare its checksum.
  explicit CheckpointReader(const std::filesystem::path& path);

  /// Throws unless the checkpoint was written by a run of this scene with this precision. `difference` tells where another scene differs
  /// ("grid.dx_m: found 0.01, there 0.02"); empty if that is not known.
  void expect(
      std::string_view fingerprint, Precision precision,
      const std::function<std::string()>& difference = [] { return std::string(); }) const;
  /// T must be the type that was written.
  template <Hdf5Number T>
  std::vector<T> array(const std::string& name) const {
    expect_type("arrays/" + name, element_type<T>());
    return in_.array<T>("arrays/" + name);
  }
  /// T: double, std::int64_t, std::uint64_t or std::string, as it was written.
  template <class T>
  T value(const std::string& name) const {
    return in_.attribute<T>("values", name);
  }

 private:
  void expect_type(const std::string& name, ElementType type) const;

  Hdf5Reader in_;
};

/// The heading of a checkpoint: exactly k_checkpoint_heading characters. `size` counts all bytes of the file, `sum` is the
/// checksum of those behind the heading.
std::string checkpoint_heading(std::uint64_t size, std::uint64_t sum);

}  // namespace bake

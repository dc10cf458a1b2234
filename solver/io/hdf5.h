// SPDX-License-Identifier: MIT
// The part of HDF5 that Bake needs: arrays, tables and attributes, written completely or not at all.
//
// Names are paths inside the file ("VTKHDF/PointData/theta"); groups on the way are made as needed. HDF5 itself prints nothing:
// errors are thrown as one line that names the file and the object, without HDF5's own texts, which hold pointers and flags.
#pragma once

#include <hdf5.h>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/io/atomic_file.h"

namespace bake {

/// Kinds of numbers in a file. `other_*` can still be read as a number (HDF5 converts it); `none` is not a number.
enum class ElementType { float32, float64, int32, int64, uint64, uint8, other_real, other_whole, none };

template <class T>
concept Hdf5Number = std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::uint64_t> || std::same_as<T, std::uint8_t>;

template <Hdf5Number T>
constexpr ElementType element_type() {
  if constexpr (std::same_as<T, float>) return ElementType::float32;
  if constexpr (std::same_as<T, double>) return ElementType::float64;
  if constexpr (std::same_as<T, std::int32_t>) return ElementType::int32;
  if constexpr (std::same_as<T, std::int64_t>) return ElementType::int64;
  if constexpr (std::same_as<T, std::uint64_t>) return ElementType::uint64;
  if constexpr (std::same_as<T, std::uint8_t>) return ElementType::uint8;
}

/// An HDF5 id that is closed when it goes out of scope.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { close(); }
  operator hid_t() const { return id_; }  // NOLINT: every function of HDF5 takes one
  bool valid() const { return id_ >= 0; }
  bool close() { return !valid() || close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// `none`: as fast as the disk. `shuffle_gzip`: about two thirds of the size; HDF5's own filters, so that every reader opens it.
enum class Packing { none, shuffle_gzip };

/// Numbers in memory, and the shape that they are to have in a file.
struct ArrayView {
  ElementType type;
  std::size_t number_bytes;
  const void* values;
  std::vector<hsize_t> shape;
};
template <Hdf5Number T>
ArrayView array_view(std::span<const T> values) {
  return {element_type<T>(), sizeof(T), values.data(), {values.size()}};
}
/// Row by row, with shape [n / columns, columns]; `columns` must divide n.
template <Hdf5Number T>
ArrayView table_view(std::span<const T> values, std::size_t columns) {
  return {element_type<T>(), sizeof(T), values.data(), {values.size() / columns, columns}};
}

/// An array as Packing::shuffle_gzip stores it. It owns its bytes, so that it can be written when its numbers have gone.
struct PackedArray {
  ElementType type;
  std::vector<hsize_t> shape;
  std::vector<std::vector<std::byte>> chunks;  ///< of `chunk_rows` rows each; none without numbers
  hsize_t chunk_rows;
};

/// Packs arrays, all chunks of all of them in parallel: HDF5's own filters would take longer than the steps between two frames.
std::vector<PackedArray> pack(const std::vector<ArrayView>& arrays);
/// The same, but gives each to take(its place in `arrays`, array) as soon as it is packed, while others still are: in order, one at a time,
/// from whatever thread. So one thread writes while the others pack. Throws what `take` throws; then it gives no more.
void pack(const std::vector<ArrayView>& arrays, const std::function<void(std::size_t, PackedArray)>& take);

/// Writes an HDF5 file into `file`, which the caller commits after close(). Without close() the file is discarded.
/// Every function throws OutputError. The same contents give the same bytes (no time stamps).
class Hdf5Writer {
 public:
  /// The first `heading_bytes` (0, or a power of two from 512 on) belong to the caller; HDF5's own data begins behind them.
  explicit Hdf5Writer(AtomicFile& file, std::size_t heading_bytes = 0);

  void group(const std::string& name);
  /// Writes n numbers with shape [n]; n may be 0.
  template <Hdf5Number T>
  void array(const std::string& name, std::span<const T> values, Packing packing = Packing::none) {
    write(name, array_view(values), packing);
  }
  /// Writes n numbers, row by row, with shape [n / columns, columns]; `columns` must divide n.
  template <Hdf5Number T>
  void table(const std::string& name, std::span<const T> values, std::size_t columns, Packing packing = Packing::none) {
    write(name, table_view(values, columns), packing);
  }
  void packed(const std::string& name, const PackedArray& array);
  /// Attributes of the group or array `object` ("/" is the file). Together under 64 kB each.
  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, std::int64_t value);
  void attribute(const std::string& object, const std::string& name, std::uint64_t value);
  void attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
  void attribute(const std::string& object, const std::string& name, std::string_view text);
  void close();

 private:
  void write(const std::string& name, const ArrayView& array, Packing packing);
  /// A dataset without its numbers; chunked and with HDF5's filters if `chunk_rows` > 0.
  Hdf5Handle new_dataset(const std::string& name, ElementType type, const std::vector<hsize_t>& shape, hsize_t chunk_rows) const;
  void write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space, const void* value);
  Hdf5Handle checked(hid_t id, Hdf5Handle::Close close, const std::string& name) const;
  void check(herr_t status, const std::string& name) const;

  AtomicFile* target_;
  Hdf5Handle file_;
  Hdf5Handle make_groups_;  ///< link creation list: missing groups on the way are made
};

/// Reads an HDF5 file. Every function throws InputError if the file is missing, not HDF5 or cut short, or if an object
/// has the wrong shape or type.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  bool has(const std::string& name) const;
  /// Names of what is in a group, sorted.
  std::vector<std::string> names(const std::string& group) const;
  /// Type of the array's numbers as stored.
  ElementType stored_type(const std::string& name) const;
  std::vector<std::size_t> shape(const std::string& name) const;
  /// An array of shape [n]. Numbers stored in another type are converted.
  template <Hdf5Number T>
  std::vector<T> array(const std::string& name) const {
    std::vector<T> values(expect_rows(name, 0));
    read(name, element_type<T>(), values.data());
    return values;
  }
  /// A table of shape [n, columns], row by row.
  template <Hdf5Number T>
  std::vector<T> table(const std::string& name, std::size_t columns) const {
    std::vector<T> values(expect_rows(name, columns) * columns);
    read(name, element_type<T>(), values.data());
    return values;
  }
  bool has_attribute(const std::string& object, const std::string& name) const;
  /// T: double, std::int64_t, std::uint64_t or std::string; must be what was written.
  template <class T>
  T attribute(const std::string& object, const std::string& name) const;

 private:
  /// The number of rows of an array (`columns` = 0) or table. Throws if its data were never stored.
  std::size_t expect_rows(const std::string& name, std::size_t columns) const;
  void read(const std::string& name, ElementType type, void* to) const;
  Hdf5Handle dataset(const std::string& name) const;
  Hdf5Handle scalar_attribute(const std::string& object, const std::string& name, H5T_class_t kind) const;
  Hdf5Handle checked(hid_t id, Hdf5Handle::Close close, const std::string& name) const;
  void check(herr_t status, const std::string& name) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

template <>
double Hdf5Reader::attribute(const std::string& object, const std::string& name) const;
template <>
std::int64_t Hdf5Reader::attribute(const std::string& object, const std::string& name) const;
template <>
std::uint64_t Hdf5Reader::attribute(const std::string& object, const std::string& name) const;
template <>
std::string Hdf5Reader::attribute(const std::string& object, const std::string& name) const;

}  // namespace bake

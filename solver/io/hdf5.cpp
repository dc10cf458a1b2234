// SPDX-License-Identifier: MIT
#include "solver/io/hdf5.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <libdeflate.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <system_error>

#include "solver/core/errors.h"
#include "solver/io/hdf5_driver.h"

namespace bake {
namespace {

constexpr hsize_t k_most_chunk_rows = 16384;

hsize_t divided_up(hsize_t number, hsize_t by) { return (number + by - 1) / by; }

hsize_t count(const std::vector<hsize_t>& shape) { return std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>()); }

/// [bits] Shannon's entropy of a byte: what a code without memory needs for each.
double entropy(const std::array<std::uint32_t, 256>& counts, std::size_t bytes) {
  double bits = 0;
  for (const std::uint32_t n : counts)
    if (n > 0) bits -= n * std::log2(static_cast<double>(n) / static_cast<double>(bytes));
  return bits / static_cast<double>(bytes);
}

/// Whether deflating would take its time and save next to nothing, as a sample of the bytes tells. Numbers that count up, whose bytes are
/// all as frequent, differ from their neighbours by always the same.
bool looks_like_noise(std::span<const std::byte> bytes) {
  constexpr double k_noise_bits = 6.5;             // frames are the same size within 1 % from 7.6 down to 6
  constexpr std::size_t k_run = 256, k_runs = 16;  // neighbours together, from everywhere
  std::array<std::uint32_t, 256> counts{}, differences{};
  const std::size_t apart = std::max(bytes.size() / k_runs, k_run);
  std::size_t seen = 0;
  for (std::size_t first = 0; first < bytes.size(); first += apart) {
    std::uint8_t last = 0;
    for (const std::byte b : bytes.subspan(first, std::min(k_run, bytes.size() - first))) {
      const auto byte = std::to_integer<std::uint8_t>(b);
      ++counts[byte];
      ++differences[static_cast<std::uint8_t>(byte - last)];
      last = byte;
      ++seen;
    }
  }
  return entropy(counts, seen) > k_noise_bits && entropy(differences, seen) > k_noise_bits;
}

/// A deflate stream [RFC 1951] of the bytes, until the thread asks for the next one.
std::span<const std::byte> deflated(std::span<const std::byte> bytes) {
  thread_local const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> fastest(libdeflate_alloc_compressor(1),
                                                                                                           libdeflate_free_compressor);
  thread_local std::vector<std::byte> room;
  room.resize(std::max(room.size(), libdeflate_deflate_compress_bound(fastest.get(), bytes.size())));
  return {room.data(), libdeflate_deflate_compress(fastest.get(), bytes.data(), bytes.size(), room.data(), room.size())};
}

/// A zlib stream [RFC 1950] whose first `stored` bytes are blocks that hold them as they are [RFC 1951 Sec. 3.2.4]; the rest is deflated.
std::vector<std::byte> stored_and_deflated(std::span<const std::byte> bytes, std::size_t stored) {
  constexpr std::size_t k_largest_block = 0xffff;
  const std::span<const std::byte> rest = deflated(bytes.subspan(stored));
  std::vector<std::byte> out;
  out.reserve(2 + stored + 5 * divided_up(stored, k_largest_block) + rest.size() + 4);
  const auto put = [&](std::size_t byte) { out.push_back(static_cast<std::byte>(byte & 0xff)); };
  put(0x78), put(0x01);  // deflate with a window of 32 KiB, fastest
  for (std::size_t at = 0; at < stored; at += k_largest_block) {
    const std::size_t size = std::min(k_largest_block, stored - at);
    put(0), put(size), put(size >> 8), put(~size), put(~size >> 8);  // not the last one; its length, and that inverted
    out.insert(out.end(), bytes.data() + at, bytes.data() + at + size);
  }
  out.insert(out.end(), rest.begin(), rest.end());
  const std::uint32_t sum = libdeflate_adler32(1, bytes.data(), bytes.size());
  put(sum >> 24), put(sum >> 16), put(sum >> 8), put(sum);
  return out;
}

/// Byte b of number i goes to planes[b * plane_bytes + i].
template <class Word>
void shuffle(const std::byte* numbers, std::size_t count, std::byte* planes, std::size_t plane_bytes) {
  static_assert(std::endian::native == std::endian::little);
  for (std::size_t b = 0; b < sizeof(Word); ++b)
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
      Word number;
      std::memcpy(&number, numbers + i * sizeof(Word), sizeof(Word));
      planes[b * plane_bytes + i] = static_cast<std::byte>(number >> (8 * b));
    }
}

/// A chunk as HDF5's filters would store it: shuffled (the first bytes of all numbers, then the second ones, and so on) and deflated, but
/// for the leading planes of bytes that look like noise, as the low bytes of a mantissa do. Rows beyond the end of the array are zeros.
std::vector<std::byte> packed_chunk(const std::byte* values, std::size_t bytes, std::size_t chunk_bytes, std::size_t number_bytes) {
  thread_local std::vector<std::byte> room;
  room.resize(std::max(room.size(), chunk_bytes));
  const std::span planes(room.data(), chunk_bytes);
  const std::size_t numbers = chunk_bytes / number_bytes;
  if (bytes < chunk_bytes) std::ranges::fill(planes, std::byte{0});
  if (number_bytes == 4)
    shuffle<std::uint32_t>(values, bytes / number_bytes, planes.data(), numbers);
  else if (number_bytes == 8)
    shuffle<std::uint64_t>(values, bytes / number_bytes, planes.data(), numbers);
  else
    std::copy_n(values, bytes, planes.begin());
  std::size_t noisy = 0;
  while (noisy < number_bytes && looks_like_noise(planes.subspan(noisy * numbers, numbers))) ++noisy;
  return stored_and_deflated(planes, noisy * numbers);
}

std::vector<std::byte> chunk_of(const ArrayView& array, hsize_t chunk_rows, std::size_t chunk) {
  const std::size_t row_bytes = array.number_bytes * count(array.shape) / array.shape[0];
  const hsize_t first = chunk * chunk_rows, rows = std::min(chunk_rows, array.shape[0] - first);
  return packed_chunk(static_cast<const std::byte*>(array.values) + first * row_bytes, rows * row_bytes, chunk_rows * row_bytes,
                      array.number_bytes);
}

/// Carries the first exception out of tasks, which none may leave; what follows it is not done.
class FirstFailure {
 public:
  template <class Work>
  void watch(Work work) noexcept {
    if (failed_) return;
    try {
      work();
    } catch (...) {
      if (!failed_.exchange(true)) what_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }

 private:
  std::atomic<bool> failed_ = false;
  std::exception_ptr what_;
};

/// Stops HDF5 from printing its error stack in this thread.
void silence_hdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

template <class Error>
Error hdf5_error(const std::filesystem::path& file, const std::string& name, const std::string& reason) {
  return Error(fmt::format("{}: {}: {}", file.string(), name, reason));
}

hid_t native_type(ElementType type) {
  switch (type) {
    case ElementType::float32:
      return H5T_NATIVE_FLOAT;
    case ElementType::float64:
      return H5T_NATIVE_DOUBLE;
    case ElementType::int32:
      return H5T_NATIVE_INT32;
    case ElementType::int64:
      return H5T_NATIVE_INT64;
    case ElementType::uint64:
      return H5T_NATIVE_UINT64;
    case ElementType::uint8:
      return H5T_NATIVE_UINT8;
    default:
      return -1;
  }
}

ElementType kind_of(hid_t type) {
  using enum ElementType;
  for (const auto known : {float32, float64, int32, int64, uint64, uint8}) {
    if (H5Tequal(type, native_type(known)) > 0) return known;
  }
  const auto kind = H5Tget_class(type);
  return kind == H5T_FLOAT ? other_real : kind == H5T_INTEGER ? other_whole : none;
}

std::string in_words(const std::vector<std::size_t>& shape) { return fmt::format("[{}]", fmt::join(shape, ", ")); }

}  // namespace

// ---------------------------------------------------------------------------------------------------------------- writing

std::vector<PackedArray> pack(const std::vector<ArrayView>& arrays) {
  std::vector<PackedArray> all;
  pack(arrays, [&](std::size_t, PackedArray array) { all.push_back(std::move(array)); });
  return all;
}

void pack(const std::vector<ArrayView>& arrays, const std::function<void(std::size_t, PackedArray)>& take) {
  std::vector<PackedArray> all;
  for (const ArrayView& array : arrays) {
    const hsize_t rows = count(array.shape) > 0 ? array.shape[0] : 0, chunks = divided_up(rows, k_most_chunk_rows);
    all.push_back({array.type, array.shape, std::vector<std::vector<std::byte>>(chunks), chunks > 0 ? divided_up(rows, chunks) : 0});
  }
  FirstFailure failure;
  PackedArray* const packed = all.data();
#pragma omp parallel
#pragma omp master  // if another thread makes tasks with dependencies, gcc's library never frees the table of these
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t c = 0; c < packed[a].chunks.size(); ++c) {
#pragma omp task depend(in : packed[a])
      failure.watch([&] { packed[a].chunks[c] = chunk_of(arrays[a], packed[a].chunk_rows, c); });
    }
#pragma omp task depend(out : packed[a]) depend(inout : failure)
    failure.watch([&] { take(a, std::move(packed[a])); });
  }
  failure.rethrow();
}

Hdf5Writer::Hdf5Writer(AtomicFile& file, std::size_t heading_bytes) : target_(&file) {
  silence_hdf5();
  const auto access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "/");
  const auto creation = checked(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "/");
  make_groups_ = checked(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "/");
  check(H5Pset_create_intermediate_group(make_groups_, 1), "/");
  check(H5Pset_userblock(creation, heading_bytes), "/");
  check(write_through(access, file) ? 0 : -1, "/");
  file_ = checked(H5Fcreate(file.target().c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose, "/");
}

Hdf5Handle Hdf5Writer::checked(hid_t id, Hdf5Handle::Close close, const std::string& name) const {
  check(id < 0 ? -1 : 0, name);
  return Hdf5Handle(id, close);
}

void Hdf5Writer::check(herr_t status, const std::string& name) const {
  target_->check();  // the system's reason says more than HDF5's
  if (status < 0) throw hdf5_error<OutputError>(target_->target(), name, "cannot be written");
}

void Hdf5Writer::group(const std::string& name) {
  checked(H5Gcreate2(file_, name.c_str(), make_groups_, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name);
}

Hdf5Handle Hdf5Writer::new_dataset(const std::string& name, ElementType type, const std::vector<hsize_t>& shape, hsize_t chunk_rows) const {
  const auto space = checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, name);
  const auto creation = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  check(H5Pset_obj_track_times(creation, false), name);
  if (chunk_rows > 0) {
    auto chunk = shape;
    chunk[0] = chunk_rows;
    check(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), name);
    check(H5Pset_shuffle(creation), name);
    check(H5Pset_deflate(creation, 1), name);
  }
  return checked(H5Dcreate2(file_, name.c_str(), native_type(type), space, make_groups_, creation, H5P_DEFAULT), H5Dclose, name);
}

void Hdf5Writer::write(const std::string& name, const ArrayView& array, Packing packing) {
  if (packing == Packing::shuffle_gzip) return packed(name, pack({array}).front());
  const auto data = new_dataset(name, array.type, array.shape, 0);
  if (count(array.shape) > 0) check(H5Dwrite(data, native_type(array.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values), name);
}

void Hdf5Writer::packed(const std::string& name, const PackedArray& array) {
  const auto data = new_dataset(name, array.type, array.shape, array.chunks.empty() ? 0 : array.chunk_rows);
  std::vector<hsize_t> first(array.shape.size(), 0);
  for (const auto& chunk : array.chunks) {
    check(H5Dwrite_chunk(data, H5P_DEFAULT, 0, first.data(), chunk.size(), chunk.data()), name);
    first[0] += array.chunk_rows;
  }
}

void Hdf5Writer::write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space, const void* value) {
  const auto where = object + " @" + name;
  const auto attribute =
      checked(H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, where);
  check(H5Awrite(attribute, type, value), where);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(object, name, H5T_NATIVE_DOUBLE, checked(H5Screate(H5S_SCALAR), H5Sclose, name), &value);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, std::int64_t value) {
  write_attribute(object, name, H5T_NATIVE_INT64, checked(H5Screate(H5S_SCALAR), H5Sclose, name), &value);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, std::uint64_t value) {
  write_attribute(object, name, H5T_NATIVE_UINT64, checked(H5Screate(H5S_SCALAR), H5Sclose, name), &value);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t count = values.size();
  write_attribute(object, name, H5T_NATIVE_INT64, checked(H5Screate_simple(1, &count, nullptr), H5Sclose, name), values.data());
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, std::string_view text) {
  const auto type = checked(H5Tcopy(H5T_C_S1), H5Tclose, name);
  check(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), name);  // of fixed length: VTK reads no other
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), name);
  const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
  check(H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8), name);  // ParaView 5.11 takes a VTKHDF type in ASCII only
  write_attribute(object, name, type, checked(H5Screate(H5S_SCALAR), H5Sclose, name), text.empty() ? "" : text.data());
}

void Hdf5Writer::close() { check(file_.close() ? 0 : -1, "/"); }

// ---------------------------------------------------------------------------------------------------------------- reading

Hdf5Reader::Hdf5Reader(std::filesystem::path path) : path_(std::move(path)) {
  const int descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);  // HDF5 would not tell the reason
  if (descriptor < 0) throw InputError(fmt::format("{}: cannot open: {}", path_.string(), std::generic_category().message(errno)));
  ::close(descriptor);
  silence_hdf5();
  const auto access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "/");
  check(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), "/");
  check(H5Pset_file_locking(access, false, true), "/");  // our files never change in place, and some file systems have no locks
  file_ = Hdf5Handle(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
  if (!file_.valid()) throw InputError(fmt::format("{}: not an HDF5 file, or cut short", path_.string()));
}

Hdf5Handle Hdf5Reader::checked(hid_t id, Hdf5Handle::Close close, const std::string& name) const {
  check(id < 0 ? -1 : 0, name);
  return Hdf5Handle(id, close);
}

void Hdf5Reader::check(herr_t status, const std::string& name) const {
  if (status < 0) throw hdf5_error<InputError>(path_, name, "cannot be read: damaged, or cut short");
}

bool Hdf5Reader::has(const std::string& name) const {
  // HDF5 can only be asked for one part of a path at a time
  for (auto end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1)) {
    if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::names(const std::string& group) const {
  if (!has(group)) throw hdf5_error<InputError>(path_, group, "there is no such group");
  const auto opened = checked(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, group);
  H5G_info_t info{};
  check(H5Gget_info(opened, &info), group);
  std::vector<std::string> found(info.nlinks);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto name = [&](char* to, std::size_t size) {
      return H5Lget_name_by_idx(opened, ".", H5_INDEX_NAME, H5_ITER_INC, i, to, size, H5P_DEFAULT);
    };
    const ssize_t length = name(nullptr, 0);
    check(length < 0 ? -1 : 0, group);
    found[i].resize(static_cast<std::size_t>(length));
    name(found[i].data(), found[i].size() + 1);
  }
  return found;
}

Hdf5Handle Hdf5Reader::dataset(const std::string& name) const {
  if (!has(name)) throw hdf5_error<InputError>(path_, name, "there is no such dataset");
  return checked(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, name);
}

ElementType Hdf5Reader::stored_type(const std::string& name) const {
  const auto data = dataset(name);
  return kind_of(checked(H5Dget_type(data), H5Tclose, name));
}

std::vector<std::size_t> Hdf5Reader::shape(const std::string& name) const {
  const auto data = dataset(name);
  const auto space = checked(H5Dget_space(data), H5Sclose, name);
  if (H5Sget_simple_extent_type(space) == H5S_NULL) throw hdf5_error<InputError>(path_, name, "holds nothing");
  const int rank = H5Sget_simple_extent_ndims(space);
  check(rank, name);
  std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, sizes.data(), nullptr), name);
  return {sizes.begin(), sizes.end()};
}

std::size_t Hdf5Reader::expect_rows(const std::string& name, std::size_t columns) const {
  const auto found = shape(name);
  const bool right = columns == 0 ? found.size() == 1 : found.size() == 2 && found[1] == columns;
  const auto wanted = columns == 0 ? std::string("[n]") : fmt::format("[n, {}]", columns);
  if (!right) throw hdf5_error<InputError>(path_, name, fmt::format("has shape {}, needs {}", in_words(found), wanted));
  H5D_space_status_t stored{};
  check(H5Dget_space_status(dataset(name), &stored), name);
  if (found[0] > 0 && stored == H5D_SPACE_STATUS_NOT_ALLOCATED) throw hdf5_error<InputError>(path_, name, "was never filled");
  return found[0];
}

void Hdf5Reader::read(const std::string& name, ElementType type, void* to) const {
  if (stored_type(name) == ElementType::none) throw hdf5_error<InputError>(path_, name, "does not hold numbers");
  check(H5Dread(dataset(name), native_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, to), name);
}

bool Hdf5Reader::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Handle Hdf5Reader::scalar_attribute(const std::string& object, const std::string& name, H5T_class_t kind) const {
  const auto where = object + " @" + name;
  if (!has_attribute(object, name)) throw hdf5_error<InputError>(path_, where, "there is no such attribute");
  auto attribute = checked(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, where);
  const auto type = checked(H5Aget_type(attribute), H5Tclose, where);
  const auto space = checked(H5Aget_space(attribute), H5Sclose, where);
  const bool right = H5Tget_class(type) == kind && H5Sget_simple_extent_npoints(space) == 1 && H5Tis_variable_str(type) <= 0;
  if (!right) throw hdf5_error<InputError>(path_, where, "is of another type than this program writes");
  return attribute;
}

template <>
double Hdf5Reader::attribute(const std::string& object, const std::string& name) const {
  double value = 0;
  check(H5Aread(scalar_attribute(object, name, H5T_FLOAT), H5T_NATIVE_DOUBLE, &value), name);
  return value;
}

template <>
std::int64_t Hdf5Reader::attribute(const std::string& object, const std::string& name) const {
  std::int64_t value = 0;
  check(H5Aread(scalar_attribute(object, name, H5T_INTEGER), H5T_NATIVE_INT64, &value), name);
  return value;
}

template <>
std::uint64_t Hdf5Reader::attribute(const std::string& object, const std::string& name) const {
  std::uint64_t value = 0;
  check(H5Aread(scalar_attribute(object, name, H5T_INTEGER), H5T_NATIVE_UINT64, &value), name);
  return value;
}

template <>
std::string Hdf5Reader::attribute(const std::string& object, const std::string& name) const {
  const auto attribute = scalar_attribute(object, name, H5T_STRING);
  const auto type = checked(H5Aget_type(attribute), H5Tclose, name);
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, text.data()), name);
  if (text == std::string(1, '\0')) text.clear();  // an empty text is stored as one zero
  return text;
}

}  // namespace bake

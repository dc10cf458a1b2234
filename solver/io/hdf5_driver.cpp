// SPDX-License-Identifier: MIT
#include "solver/io/hdf5_driver.h"

#if __has_include(<H5FDdevelop.h>)
#include <H5FDdevelop.h>  // from HDF5 1.14 on
#endif

#include <algorithm>
#include <new>

namespace bake {
namespace {

/// The data in the access list; HDF5 copies it byte by byte.
struct Target {
  AtomicFile* file;
};

/// HDF5's own part comes first, because HDF5 passes us pointers to that part.
struct OpenFile : H5FD_t {
  AtomicFile* file;
  haddr_t end_of_allocated;
  haddr_t end_of_written;
};

OpenFile& ours(H5FD_t* file) { return *static_cast<OpenFile*>(file); }
const OpenFile& ours(const H5FD_t* file) { return *static_cast<const OpenFile*>(file); }

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t) {
  const auto* target = static_cast<const Target*>(H5Pget_driver_info(access));
  return target ? new (std::nothrow) OpenFile{{}, target->file, 0, 0} : nullptr;
}

herr_t close_file(H5FD_t* file) {
  delete &ours(file);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA |
              H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t end_of_allocated(const H5FD_t* file, H5FD_mem_t) { return ours(file).end_of_allocated; }

herr_t set_end_of_allocated(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  ours(file).end_of_allocated = end;
  return 0;
}

haddr_t end_of_written(const H5FD_t* file, H5FD_mem_t) { return ours(file).end_of_written; }

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t size, void* to) {
  auto* bytes = static_cast<std::byte*>(to);
  const auto got = ours(file).file->read_at(offset, {bytes, size});
  std::fill(bytes + got, bytes + size, std::byte{0});  // HDF5 may read bytes that it has not written yet
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t size, const void* from) {
  ours(file).file->write_at(offset, {static_cast<const std::byte*>(from), size});
  ours(file).end_of_written = std::max<haddr_t>(ours(file).end_of_written, offset + size);
  return 0;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
  if (ours(file).end_of_written == ours(file).end_of_allocated) return 0;
  ours(file).file->resize(ours(file).end_of_allocated);
  ours(file).end_of_written = ours(file).end_of_allocated;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
#ifdef H5FD_CLASS_VERSION
  driver.version = H5FD_CLASS_VERSION;
  driver.value = 512;  // the first value that HDF5 leaves to applications
#endif
  driver.name = "atomic_file";
  driver.maxaddr = HADDR_MAX;
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.fapl_size = sizeof(Target);
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = end_of_allocated;
  driver.set_eoa = set_end_of_allocated;
  driver.get_eof = end_of_written;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  const H5FD_mem_t one_list_per_kind[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(one_list_per_kind), std::end(one_list_per_kind), driver.fl_map);
  return driver;
}

}  // namespace

bool write_through(hid_t access, AtomicFile& file) {
  static const H5FD_class_t driver = driver_class();
  static const hid_t id = H5FDregister(&driver);
  const Target target{&file};
  return id >= 0 && H5Pset_driver(access, id, &target) >= 0;
}

}  // namespace bake

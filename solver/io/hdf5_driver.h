// SPDX-License-Identifier: MIT
// Lets HDF5 write through an AtomicFile.
#pragma once

#include <hdf5.h>

#include "solver/io/atomic_file.h"

namespace bake {

/// Makes the file access list `access` write into `file`, whatever name H5Fcreate is given. `file` must outlive the HDF5 file.
/// HDF5 is not told of a failing write, because it would free a file that it cannot flush, keep its id, and crash at the end of
/// the program. Call `file.check()` after writing. Returns false if HDF5 refuses.
bool write_through(hid_t access, AtomicFile& file);

}  // namespace bake

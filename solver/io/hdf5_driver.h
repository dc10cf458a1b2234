// SPDX-License-Identifier: MIT
// HDF5 files written through an AtomicFile.
#pragma once

#include <hdf5.h>

#include "solver/io/atomic_file.h"

namespace bake {

/// Lets the file access list `access` write into `file`, whatever name H5Fcreate is given. `file` must outlive the HDF5 file.
/// HDF5 never learns of a failing write: it frees a file that it cannot flush, keeps its id, and crashes at the end of the
/// program. Ask `file.check()` after writing. Returns false if HDF5 refuses.
bool write_through(hid_t access, AtomicFile& file);

}  // namespace bake

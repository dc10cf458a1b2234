#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-h5py-serial 3.7.0-8 with libhdf5-103-1 1.10.8+repack1-1.
# Behaviour: the scale-offset filter for floating-point numbers turns a NaN into an ordinary number, here the smallest of its chunk.
# Expected: NaN, or an error when it is written. The filter is known to be lossy: it keeps a stated number of decimal digits of every
# value. A mark for "no value here" is not a digit, and infinity does survive (the filter then leaves the chunk as it is).
# Seen: 1.25, NaN, 3.75 are read as 1.25, 1.25, 3.75; with infinity instead of NaN all is read as written.
source "$(dirname "$0")/common.sh"
debian_packages python3-h5py-serial=3.7.0-8 python3-h5py=3.7.0-8 libhdf5-103-1=1.10.8+repack1-1
cat >chunk.py <<'END'
import h5py, numpy

for strange in numpy.nan, numpy.inf:
    with h5py.File("chunk.h5", "w") as file:
        file.create_dataset("x", data=numpy.array([1.25, strange, 3.75]), chunks=(3,), scaleoffset=2)
    with h5py.File("chunk.h5") as file:
        print(*file["x"][:])
END
look_at "$python" chunk.py
conclude "1.25 1.25 3.75 1.25 inf 3.75" "HDF5's scale-offset filter reads a NaN back as an ordinary number"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: hdf5-tools 1.10.8+repack1-1, and python3-h5py-serial 3.7.0-8 to make the files.
# Behaviour: with a relative tolerance (-p), an infinity in the first file equals any number in the second: no difference, exit code 0. With
# the files in the other order, or with an absolute tolerance (-d), it is a difference.
# Expected: a difference each time. `h5diff --help` states the criterion: |(a - b) / b| > R, a of the first file; this is infinity here.
# A run that overflowed passes the comparison with its reference.
# Seen: relative 0, other order 1, absolute 1.
source "$(dirname "$0")/common.sh"
debian_packages hdf5-tools=1.10.8+repack1-1 python3-h5py-serial=3.7.0-8 python3-h5py=3.7.0-8
cat >files.py <<'END'
import h5py, numpy

for name, value in ("run.h5", numpy.inf), ("reference.h5", 1.0):
    with h5py.File(name, "w") as file:
        file["temperature"] = numpy.array([value, 2.0])
END
"$python" files.py || cannot_try "h5py does not work"
codes() {
  h5diff -p 0.1 run.h5 reference.h5 >/dev/null && echo "relative 0" || echo "relative $?"
  h5diff -p 0.1 reference.h5 run.h5 >/dev/null && echo "swapped 0" || echo "swapped $?"
  h5diff -d 0.1 run.h5 reference.h5 >/dev/null && echo "absolute 0" || echo "absolute $?"
}
look_at codes
conclude "relative 0 swapped 1 absolute 1" "h5diff -p takes an infinity in the first file for equal to any number"

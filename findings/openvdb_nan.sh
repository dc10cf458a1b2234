#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-openvdb and libopenvdb10.0, 10.0.1-2.
# Behaviour: copyFromArray takes a NaN for a value that equals the background, with tolerance 0: the voxel stays inactive and reads as the
# background.
# Expected: an active voxel that holds NaN. By its help the function leaves a voxel inactive if and only if its value equals the background,
# and NaN equals no number. A field that blew up in places looks as if there were nothing.
# Seen: of the values 1, NaN, infinity two voxels are active; NaN is read back as 0.
source "$(dirname "$0")/common.sh"
debian_packages python3-openvdb=10.0.1-2 libopenvdb10.0=10.0.1-2
cat >values.py <<'END'
import numpy
import pyopenvdb

grid = pyopenvdb.FloatGrid(background=0.0)
grid.copyFromArray(numpy.array([[[1.0, numpy.nan, numpy.inf]]]), tolerance=0.0)
print(grid.activeVoxelCount(), "active:", *(grid.getConstAccessor().getValue((0, 0, k)) for k in range(3)))
END
look_at "$python" values.py
conclude "2 active: 1.0 0.0 inf" "OpenVDB drops a NaN that is copied into a grid, as if it were the background"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-openvdb and libopenvdb10.0, 10.0.1-2.
# Behaviour: the quads that convertToPolygons (volumeToMesh) makes of a level set point inwards: seen from outside their corners run
# clockwise, and the signed volume is negative.
# Expected: outwards, as STL and glTF ask for and as the signs of a level set suggest: negative inside, so that its gradient does so.
# The help of the function states no orientation.
# Seen: for a ball of radius 1, volume 4.19, the signed volume is -4.14.
source "$(dirname "$0")/common.sh"
debian_packages python3-openvdb=10.0.1-2 libopenvdb10.0=10.0.1-2
cat >ball.py <<'END'
import numpy
import pyopenvdb

ball = pyopenvdb.createLevelSetSphere(radius=1.0, voxelSize=0.1)
points, triangles, quads = ball.convertToPolygons(adaptivity=0)
a, b, c, d = (points[quads[:, k]].astype(float) for k in range(4))
volume = (numpy.cross(a, b) * c).sum() / 6 + (numpy.cross(a, c) * d).sum() / 6
print("inside", "negative" if ball.getConstAccessor().getValue((0, 0, 0)) < 0 else "positive")
print("quads", len(quads), "volume", f"{volume:.2f}")
END
look_at "$python" ball.py
conclude "inside negative quads 1830 volume -4.14" "OpenVDB's meshes of level sets are inside out"

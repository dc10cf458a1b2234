#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-stl 2.9.0-2+b3 (numpy-stl).
# Behaviour: rotate turns a mesh clockwise for a positive angle, seen against the axis.
# Expected: counterclockwise, by the right-hand rule, as in OpenSCAD, Blender, three.js and VTK. The help of rotate speaks of an axis and an
# angle in radians, without a direction.
# Seen: a vertex at (1, 0, 0), turned by 90 degrees about +z, is at (0, -1, 0).
source "$(dirname "$0")/common.sh"
debian_packages python3-stl=2.9.0-2+b3
cat >turn.py <<'END'
import math
import numpy
from stl.mesh import Mesh

triangle = Mesh(numpy.zeros(1, dtype=Mesh.dtype))
triangle.vectors[0] = [1, 0, 0], [2, 0, 0], [1, 1, 0]
triangle.rotate([0, 0, 1], math.radians(90))
print("(1, 0, 0) turns to", triangle.vectors[0, 0].round(3).astype(int).tolist())
END
look_at "$python" turn.py
conclude "(1, 0, 0) turns to [0, -1, 0]" "numpy-stl turns a mesh clockwise for a positive angle"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-stl 2.9.0-2+b3 (numpy-stl).
# Behaviour: get_mass_properties gives a unit cube that lies 1000 from the origin moments of inertia that are rounding errors, also negative
# ones: it computes them about the origin in single precision and subtracts.
# Expected: 1/6 about each axis wherever it lies. The help says that the moments are those at the centre of gravity; single precision, in
# which STL keeps coordinates, represents this cube exactly, and its volume and centre come out right.
# Seen: at the origin 0.167 about all axes; 1000 away in x it was -6.03 about y, without a warning.
source "$(dirname "$0")/common.sh"
debian_packages python3-stl=2.9.0-2+b3
cat >cube.py <<'END'
import numpy
from stl.mesh import Mesh

corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
faces = numpy.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4],
                     [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]])
for x in 0, 1000:
    cube = Mesh(numpy.zeros(12, dtype=Mesh.dtype))
    cube.vectors[:] = (corners + (x, 0, 0))[faces]
    volume, _, inertia = cube.get_mass_properties()
    print(f"at {x}: volume {volume:.3f}, about y", "right;" if abs(6 * inertia[1, 1] - 1) < 0.1 else "wrong;")
END
look_at "$python" cube.py
conclude "at 0: volume 1.000, about y right; at 1000: volume 1.000, about y wrong;" \
  "numpy-stl's moments of inertia of a unit cube 1000 from the origin are rounding errors"

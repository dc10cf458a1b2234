#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-stl 2.9.0-2+b3 (numpy-stl).
# Behaviour: save in text mode writes six digits behind the point, whatever the size: all coordinates below 5e-7 become 0.
# Expected: digits that give the number back, which an exponent allows in STL; the format itself names the sign-mantissa-e-exponent form.
# In binary mode all is kept. A grain of half a micron, in metres, is a point.
# Seen: of a triangle with sides of 4e-7 the binary file keeps 4e-07, the text file 0.
source "$(dirname "$0")/common.sh"
debian_packages python3-stl=2.9.0-2+b3
cat >grain.py <<'END'
import numpy
import stl

grain = stl.mesh.Mesh(numpy.zeros(1, dtype=stl.mesh.Mesh.dtype))
grain.vectors[0] = [0, 0, 0], [4e-7, 0, 0], [0, 4e-7, 0]
for mode in stl.Mode.BINARY, stl.Mode.ASCII:
    grain.save("grain.stl", mode=mode)
    print(mode.name, f"{stl.mesh.Mesh.from_file('grain.stl').vectors.max():.0e};")
END
look_at "$python" grain.py
conclude "BINARY 4e-07; ASCII 0e+00;" "numpy-stl writes small coordinates as 0 in text mode"

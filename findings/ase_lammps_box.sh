#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-ase 3.22.1-3+deb12u1.
# Behaviour: ASE reads a LAMMPS dump whose box does not begin at 0 and writes a data file of LAMMPS in which the box begins at 0 and the
# particles have kept their places: they are no longer in it.
# Expected: the box where it was, or particles moved with it. The reader keeps the origin of the box (get_celldisp gives -5), the format has
# a place for it (xlo xhi), and the writer is told of no choice. Walls, regions and boundaries that are not periodic follow the box.
# Seen: a box from -5 to 5 with particles at x = -4 and 4 becomes a box from 0 to 10 with particles at x = -4 and 4.
source "$(dirname "$0")/common.sh"
debian_packages python3-ase=3.22.1-3+deb12u1
cat >box.dump <<'END'
ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff ff ff
-5 5
-5 5
-5 5
ITEM: ATOMS id type x y z
1 1 -4 0 0
2 1 4 0 0
END
cat >convert.py <<'END'
import ase.io

atoms = ase.io.read("box.dump", format="lammps-dump-text")
ase.io.write("box.data", atoms, format="lammps-data")
words = [line.split() for line in open("box.data")]
print("origin read:", atoms.get_celldisp().ravel()[0])
for line in words:
    if line[-2:] == ["xlo", "xhi"]:
        print("box written:", float(line[0]), float(line[1]))
print("particles at", *(float(line[2]) for line in words if len(line) == 5 and line[0] in "12"))
END
look_at "$python" convert.py
conclude "origin read: -5.0 box written: 0.0 10.0 particles at -4.0 4.0" \
  "ASE moves the box of a LAMMPS dump to the origin and leaves the particles where they were"

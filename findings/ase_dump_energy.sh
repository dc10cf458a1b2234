#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-ase 3.22.1-3+deb12u1.
# Behaviour: a LAMMPS dump that has forces is read with a potential energy of 0, which the file does not have; the extended XYZ file that
# ASE makes of it states "energy=0.0".
# Expected: no energy: get_potential_energy raises an error for a dump without forces, and so it does for atoms that are given forces alone
# with SinglePointCalculator, the class that the reader uses. A fit or an average over such files takes the 0 for data.
# Seen: the same two particles without forces: an error; with forces: 0.0, and energy=0.0 in the file.
source "$(dirname "$0")/common.sh"
debian_packages python3-ase=3.22.1-3+deb12u1
cat >energy.py <<'END'
import ase.io

head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id type x y z"
for name, columns, numbers in ("without", "", ""), ("with", " fx fy fz", " 0.5 0 0"):
    with open("two.dump", "w") as file:
        file.write(f"{head}{columns}\n1 1 1 2 3{numbers}\n2 1 4 5 6{numbers}\n")
    atoms = ase.io.read("two.dump", format="lammps-dump-text")
    try:
        energy = atoms.get_potential_energy()
    except RuntimeError:
        energy = "none"
    ase.io.write("two.xyz", atoms, format="extxyz")
    print(name, "forces:", energy, *(word for word in open("two.xyz").read().split() if word.startswith("energy")), end="; ")
END
look_at "$python" energy.py
conclude "without forces: none; with forces: 0.0 energy=0.0;" "ASE gives a LAMMPS dump with forces a potential energy of 0"

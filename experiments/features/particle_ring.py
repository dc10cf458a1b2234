#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes experiments/features/ring.h5: a ring, one half soft (material 0), one half stiff (1), as particles that a scene can read.

    experiments/features/particle_ring.py experiments/features/ring.h5
"""
import sys

import h5py
import numpy as np

SPACING, RADIUS, THICKNESS, HEIGHT = 0.005, 0.06, 0.02, 0.1


def main():
    steps = (np.arange(-40, 40) + 0.5) * SPACING
    x, y, z = (axis.ravel() for axis in np.meshgrid(steps, steps, steps, indexing="ij"))
    inside = (np.hypot(x, z) - RADIUS) ** 2 + y**2 < THICKNESS**2
    positions = np.stack([x, y, z + HEIGHT], axis=1)[inside]
    with h5py.File(sys.argv[1], "w") as file:
        for name, values in (("positions", positions.astype("f4")), ("volumes", np.full(len(positions), SPACING**3, "f4")),
                             ("material", (positions[:, 0] > 0).astype("i4"))):
            file.create_dataset(name, data=values, compression="gzip", shuffle=True)


if __name__ == "__main__":
    main()

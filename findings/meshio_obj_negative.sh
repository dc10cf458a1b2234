#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-meshio 7.0.0-3.
# Behaviour: negative vertex numbers of an OBJ face, which count back from the last vertex, are taken for positive ones: each lands one
# vertex too early, without an error.
# Expected: -1 is the last vertex, as the specification of OBJ defines relative numbers; several exporters write only those. Or a refusal.
# Seen: of four vertices, "f -3 -2 -1" is the triangle of the last three; meshio gives one whose largest coordinate is that of the third.
source "$(dirname "$0")/common.sh"
debian_packages python3-meshio=7.0.0-3
cat >relative.py <<'END'
import meshio

vertices = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 3 0 0\n"
for face in "f 2 3 4", "f -3 -2 -1":
    with open("triangle.obj", "w") as file:
        file.write(vertices + face + "\n")
    mesh = meshio.read("triangle.obj")
    print(face, "is at x =", *(f"{x:g}" for x in mesh.points[mesh.cells[0].data[0], 0]), end=";\n")
END
look_at "$python" relative.py
conclude "f 2 3 4 is at x = 1 2 3; f -3 -2 -1 is at x = 0 1 2;" \
  "meshio takes other vertices than those that negative numbers of an OBJ face name"

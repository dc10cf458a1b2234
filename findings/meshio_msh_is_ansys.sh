#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-meshio 7.0.0-3.
# Behaviour: a mesh that is written to a name with the ending .msh becomes an ANSYS file and loses its point and cell data, without a
# message.
# Expected: a Gmsh file, whose ending that is as well, or an error: meshio's writer of the format that it chooses holds no data, that of
# the other does. With file_format="gmsh" all is kept.
# Seen: read back, the file chosen by its ending has no temperature; the one chosen by name has it.
source "$(dirname "$0")/common.sh"
debian_packages python3-meshio=7.0.0-3
cat >write.py <<'END'
import meshio, numpy

corners = numpy.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
mesh = meshio.Mesh(corners, [("triangle", numpy.array([[0, 1, 2]]))], point_data={"temperature": numpy.array([10.0, 20, 30])})
for choice in {}, {"file_format": "gmsh"}:
    mesh.write("triangle.msh", **choice)
    with open("triangle.msh", "rb") as file:
        print(file.read(4).decode(), "temperature" in meshio.read("triangle.msh", **choice).point_data, end=";\n")
END
look_at "$python" write.py
conclude '(1 " False; $Mes True;' "meshio writes a .msh file as ANSYS's and drops the values at the points in silence"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-meshio 7.0.0-3, and python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1, with python3-netcdf4 1.6.2-1+b1.
# Behaviour: meshio writes the nodes of a quadratic hexahedron to an Exodus file in VTK's order. In Exodus, the nodes on the upright edges
# come before those on the top edges, so that other programs find eight of the twenty nodes on wrong edges.
# Expected: the order of the format, as meshio takes care of it in Gmsh's files, where some nodes are in another order too.
# Seen: a cube of volume 1, read by VTK, has volume 1 from a VTU file and 0.083 from an Exodus file that meshio made of the same mesh.
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages python3-meshio=7.0.0-3 "python3-vtk9=$version" "libvtk9.1=$version" python3-netcdf4=1.6.2-1+b1
cat >write.py <<'END'
import meshio, numpy

corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
points = numpy.array(corners, float)
points = numpy.vstack([points, [(points[a] + points[b]) / 2 for a, b in edges]])
for name in "cube.vtu", "cube.e":
    meshio.write(name, meshio.Mesh(points, [("hexahedron20", numpy.arange(20).reshape(1, 20))]))
END
cat >read.py <<'END'
import vtk

def volume(grid):
    size = vtk.vtkCellSizeFilter()
    size.SetInputData(grid)
    size.Update()
    return f"{size.GetOutput().GetCellData().GetArray('Volume').GetValue(0):.3f}"

vtu = vtk.vtkXMLUnstructuredGridReader()
vtu.SetFileName("cube.vtu")
vtu.Update()
exodus = vtk.vtkExodusIIReader()
exodus.SetFileName("cube.e")
exodus.Update()
print("VTU", volume(vtu.GetOutput()), "Exodus", volume(exodus.GetOutput().GetBlock(0).GetBlock(0)))
END
"$python" write.py || cannot_try "meshio does not work"
look_at "$python" read.py
conclude "VTU 1.000 Exodus 0.083" "meshio writes the nodes of a quadratic hexahedron to Exodus files in another order than the format's"

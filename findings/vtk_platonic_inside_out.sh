#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1.
# Behaviour: of the five solids of vtkPlatonicSolidSource, the tetrahedron and the icosahedron have all faces the other way round, so that
# they point inwards; cube, octahedron and dodecahedron point outwards.
# Expected: outwards for all, as the other sources of closed surfaces have it (vtkSphereSource, vtkCubeSource). Signed volumes, inside
# tests and back-face culling give the opposite for two of five solids.
# Seen: summed over the triangles of each solid, the signed volumes are -0.513 (tetrahedron), 1.540 (cube), 1.333 (octahedron), -2.536
# (icosahedron) and 2.785 (dodecahedron).
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages "python3-vtk9=$version" "libvtk9.1=$version"
cat >solids.py <<'END'
import vtk

for kind in range(5):
    source = vtk.vtkPlatonicSolidSource()
    source.SetSolidType(kind)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    solid = triangles.GetOutput()
    volume = 0
    for i in range(solid.GetNumberOfCells()):
        a, b, c = (solid.GetPoint(solid.GetCell(i).GetPointId(k)) for k in range(3))
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    print("outwards" if volume > 0 else "inwards")
END
look_at "$python" solids.py
conclude "inwards outwards outwards inwards outwards" "two of VTK's five Platonic solids, tetrahedron and icosahedron, are inside out"

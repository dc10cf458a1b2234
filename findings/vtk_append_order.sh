#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1.
# Behaviour: vtkAppendFilter gives all points the precision of its first input: if that has floats, the doubles of the others are rounded to
# floats in silence. With the inputs in the other order they stay.
# Expected: doubles if any input has them, as vtkAppendPolyData gives for the same inputs in both orders. The filter has a setting for the
# precision; its default is called the default precision, and the header tells nothing of the first input.
# Seen: a point at x = 500000.1, in doubles, beside one in floats: appended second it is at 500000.09375, appended first at 500000.1.
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages "python3-vtk9=$version" "libvtk9.1=$version"
cat >append.py <<'END'
import vtk

def vertex(precision, x):
    points = vtk.vtkPoints()
    points.SetDataType(precision)
    points.InsertNextPoint(x, 0, 0)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.Allocate(1)
    data.InsertNextCell(vtk.VTK_VERTEX, 1, [0])
    return data

near, far = vertex(vtk.VTK_FLOAT, 1.0), vertex(vtk.VTK_DOUBLE, 500000.1)
for name in "vtkAppendPolyData", "vtkAppendFilter":
    for inputs in (near, far), (far, near):
        append = getattr(vtk, name)()
        for data in inputs:
            append.AddInputData(data)
        append.Update()
        print(name, append.GetOutput().GetBounds()[1], end=";\n")
END
look_at "$python" append.py
conclude "vtkAppendPolyData 500000.1; vtkAppendPolyData 500000.1; vtkAppendFilter 500000.09375; vtkAppendFilter 500000.1;" \
  "vtkAppendFilter rounds doubles to floats if its first input has floats"

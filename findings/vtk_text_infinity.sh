#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1.
# Behaviour: the XML writer puts an infinity into a text file (format="ascii") as the word inf; the XML reader refuses the array, and with
# it the whole piece: it prints an error, keeps error code 0 and gives a grid without points. A NaN comes back, and in base64 both do.
# Expected: that VTK reads what VTK writes, and that NaN and infinity fare alike. One overflowed value of one field costs the whole grid.
# Seen: of 3 points, 3 are read with a NaN as text, 0 with an infinity as text, 3 with an infinity in base64; the error code is 0 each time.
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages "python3-vtk9=$version" "libvtk9.1=$version"
cat >infinity.py <<'END'
import vtk

def points_read(mode, word):
    points = vtk.vtkPoints()
    values = vtk.vtkDoubleArray()
    values.SetName("temperature")
    for i, value in enumerate((1.0, float(word), 3.0)):
        points.InsertNextPoint(i, 0, 0)
        values.InsertNextValue(value)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().AddArray(values)
    writer = vtk.vtkXMLPolyDataWriter()
    getattr(writer, f"SetDataModeTo{mode}")()
    writer.SetInputData(data)
    writer.SetFileName("values.vtp")
    if not writer.Write():
        return "not written"
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName("values.vtp")
    reader.Update()
    return f"{reader.GetOutput().GetNumberOfPoints()} points, code {reader.GetErrorCode()};"

for mode, word in ("Ascii", "nan"), ("Ascii", "inf"), ("Binary", "inf"):
    print(mode, word, points_read(mode, word))
END
look_at "$python" infinity.py
conclude "Ascii nan 3 points, code 0; Ascii inf 0 points, code 0; Binary inf 3 points, code 0;" \
  "VTK writes an infinity into an XML text file from which it then reads no point at all"

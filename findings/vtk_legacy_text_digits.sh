#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1.
# Behaviour: as text, the writer of legacy files (.vtk) gives floats 6 digits and doubles 11, and has no setting for more; the XML writer
# gives the same points all digits that they need.
# Expected: the same numbers from both, 9 and 17 digits where needed. In a domain of 123 km, 6 digits are steps of one metre.
# Seen: the float 123456.789 is read back as 123457, the double 1/3 as 0.33333333333; with the XML writer both are unchanged.
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages "python3-vtk9=$version" "libvtk9.1=$version"
cat >points.py <<'END'
import vtk

def again(writer, reader, name, kind, value):
    points = vtk.vtkPoints()
    points.SetDataType(kind)
    points.InsertNextPoint(value, 0, 0)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    writer.SetInputData(data)
    writer.SetFileName(name)
    writer.Write()
    reader.SetFileName(name)
    reader.Update()
    read = reader.GetOutput().GetPoint(0)[0]
    return "same" if read == points.GetPoint(0)[0] else read

for kind, value in (vtk.VTK_FLOAT, 123456.789), (vtk.VTK_DOUBLE, 1 / 3):
    legacy = vtk.vtkPolyDataWriter()
    legacy.SetFileTypeToASCII()
    xml = vtk.vtkXMLPolyDataWriter()
    xml.SetDataModeToAscii()
    print("legacy", again(legacy, vtk.vtkPolyDataReader(), "points.vtk", kind, value))
    print("XML", again(xml, vtk.vtkXMLPolyDataReader(), "points.vtp", kind, value))
END
look_at "$python" points.py
conclude "legacy 123457.0 XML same legacy 0.33333333333 XML same" \
  "VTK's legacy text files keep 6 digits of a float and 11 of a double, its XML files all"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1, and python3-h5py-serial 3.7.0-8 to make the file.
# Behaviour: VTK 9.1 reads a VTKHDF file of several time steps as one grid that has the points of all steps at once. The steps are stored
# one behind the other, as parts are, and the reader knows parts only.
# Expected: the first step, or a refusal. The file names version 2.0 of the format, as the steps ask for; the reader knows version 1.0, says
# so in a warning, and goes on with error code 0. A later minor version may be read so, a later major one is another format.
# Seen: of a file of two points in three steps, VTK gives a grid of six points.
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages "python3-vtk9=$version" "libvtk9.1=$version" python3-h5py-serial=3.7.0-8 python3-h5py=3.7.0-8
cat >file.py <<'END'
import h5py, numpy

count, steps = 2, 3
with h5py.File("steps.vtkhdf", "w") as file:
    grid = file.create_group("VTKHDF")
    grid.attrs["Version"] = numpy.array([2, 0])
    grid.attrs.create("Type", b"UnstructuredGrid", dtype=h5py.string_dtype("ascii", 16))
    for name in "NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds":
        grid[name] = numpy.full(steps, count)
    grid["Points"] = numpy.arange(3.0 * count * steps).reshape(-1, 3)
    grid["Connectivity"] = numpy.tile(numpy.arange(count), steps)
    grid["Offsets"] = numpy.tile(numpy.arange(count + 1), steps)
    grid["Types"] = numpy.ones(count * steps, numpy.uint8)
    group = grid.create_group("Steps")
    group.attrs["NSteps"] = steps
    group["Values"] = numpy.arange(1.0 * steps)
    group["NumberOfParts"] = numpy.ones(steps, int)
    group["PartOffsets"] = numpy.arange(steps)
    group["PointOffsets"] = numpy.arange(steps) * count
    group["CellOffsets"] = numpy.arange(steps).reshape(-1, 1) * count
    group["ConnectivityIdOffsets"] = numpy.arange(steps).reshape(-1, 1) * count
END
cat >read.py <<'END'
import vtk

reader = vtk.vtkHDFReader()
reader.SetFileName("steps.vtkhdf")
reader.Update()
print(reader.GetOutputDataObject(0).GetNumberOfPoints(), "points, code", reader.GetErrorCode())
END
"$python" file.py || cannot_try "h5py does not work"
look_at "$python" read.py
conclude "6 points, code 0" "VTK 9.1 reads the time steps of a VTKHDF file as one grid of them all"

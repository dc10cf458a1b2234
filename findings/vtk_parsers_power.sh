#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-vtk9 and libvtk9.1, 9.1.0+really9.1.0+dfsg2-5+deb12u1.
# Behaviour: vtkArrayCalculator computes -T^2 and 2^3^2 otherwise with the one of its two parsers than with the other. vtkFunctionParser
# squares minus T and takes powers from the left; ExprTk, the default, negates the square and takes powers from the right.
# Expected: the same from both, -T^2 negative as in mathematics. The header of the calculator lists one set of operators for the two, apart
# from the products of vectors. A function that was written for the one has another sign by the other, without a message.
# Seen: for T = 3, ExprTk gives -9 and 512, vtkFunctionParser 9 and 64.
source "$(dirname "$0")/common.sh"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
debian_packages "python3-vtk9=$version" "libvtk9.1=$version"
cat >power.py <<'END'
import vtk

values = vtk.vtkDoubleArray()
values.SetName("T")
values.InsertNextValue(3.0)
points = vtk.vtkPoints()
points.InsertNextPoint(0, 0, 0)
data = vtk.vtkPolyData()
data.SetPoints(points)
data.GetPointData().AddArray(values)
for parser in "ExprTkFunctionParser", "FunctionParser":
    for function in "-T^2", "2^3^2":
        calculator = vtk.vtkArrayCalculator()
        getattr(calculator, f"SetFunctionParserTypeTo{parser}")()
        calculator.SetInputData(data)
        calculator.AddScalarArrayName("T")
        calculator.SetFunction(function)
        calculator.SetResultArrayName("result")
        calculator.Update()
        print(parser, function, "is", calculator.GetOutput().GetPointData().GetArray("result").GetValue(0), end=";\n")
END
look_at "$python" power.py
conclude "ExprTkFunctionParser -T^2 is -9.0; ExprTkFunctionParser 2^3^2 is 512.0; FunctionParser -T^2 is 9.0; FunctionParser 2^3^2 is 64.0;" \
  "-T^2 and 2^3^2 have two values in VTK's calculator, by the parser"

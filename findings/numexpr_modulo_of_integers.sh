#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-numexpr 2.8.4-1+b2, python3-numpy 1:1.24.2-1+deb12u1, python3-pandas 1.5.3+dfsg-2.
# Behaviour: NumExpr's % of negative integers is C's remainder, which keeps the sign, that of negative floats NumPy's modulo, which does
# not. So the type of the numbers decides the result, and DataFrame.eval gives another one where NumExpr is installed.
# Expected: the modulo for both. NumExpr says that it evaluates expressions of NumPy faster and lists % with the arithmetic operators,
# without more; pandas takes its engine for a matter of speed. Cells or angles left of 0 are no longer wrapped into their period.
# Seen: -135 % 360 is -135 from integers and 225 from floats, NumPy gives 225 for both; DataFrame.eval gives -135 by NumExpr, 225 without.
source "$(dirname "$0")/common.sh"
debian_packages python3-numexpr=2.8.4-1+b2 python3-numpy=1:1.24.2-1+deb12u1 python3-pandas=1.5.3+dfsg-2
cat >modulo.py <<'END'
import numexpr
import numpy
import pandas

for angle in numpy.array([-135]), numpy.array([-135.0]):
    frame = pandas.DataFrame({"angle": angle})
    results = [angle % 360, numexpr.evaluate("angle % 360")]
    results += [frame.eval("angle % 360", engine=engine).to_numpy() for engine in ("numexpr", "python")]
    print(angle.dtype, *(f"{result[0]:g}" for result in results), end=";\n")
END
look_at "$python" modulo.py
conclude "int64 225 -135 -135 225; float64 225 225 225 225;" "-135 % 360 is -135 from integers and 225 from floats in NumExpr"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-sympy 1.11.1-1 and python3-mpmath 1.2.1-2.
# Behaviour: the C code of a quotient by a secant or cotangent divides by a cosine or tangent instead: SymPy writes 1.0/cos(x) for the
# function that C lacks, without parentheses. A fractional part, x - floor(x), has none either, so that what is subtracted is x alone.
# Expected: code with the value of the expression, as SymPy itself evaluates it. The documentation of ccode promises a string of C
# code for the expression. What stands for a Mod of integers gets its parentheses.
# Seen: x/sec(x) becomes x/1.0/cos(x), at x = 1.25 the value 3.96 instead of 0.39, and 1 - frac(x) becomes 1 - x - floor(x), -1.25 for 0.75.
source "$(dirname "$0")/common.sh"
debian_packages python3-sympy=1.11.1-1 python3-mpmath=1.2.1-2
cat >write.py <<'END'
import sympy

x = sympy.Symbol("x")
print("#include <math.h>\n#include <stdio.h>\nint main() {\n  const double x = 1.25;")
for expression in x / sympy.sec(x), 2 / sympy.cot(x), 1 - sympy.frac(x):
    code, value = sympy.ccode(expression), sympy.N(expression.subs(x, sympy.Rational(5, 4)))
    print(f'  printf("{code}: %.2f for {value:.2f};\\n", {code});')
print("}")
END
"$python" write.py >code.cpp || cannot_try "SymPy does not work"
compile code.cpp
look_at ./program
conclude "x/1.0/cos(x): 3.96 for 0.39; 2/1.0/tan(x): 0.66 for 6.02; 1 - x - floor(x): -1.25 for 0.75;" \
  "SymPy's C code of x/sec(x) is that of x/cos(x)"

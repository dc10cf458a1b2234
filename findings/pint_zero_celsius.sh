#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-pint 0.19.2-1.
# Behaviour: 0 degC equals 0 kelvin and 0 degF, and at the same time equals 273.15 kelvin. A quantity that is 0 in its own unit equals every
# other of that dimension that is 0 in its unit; all other temperatures are converted before they are compared.
# Expected: not equal: 0 degC is 273.15 K. Pint knows that these units have an offset, converts them and puts them in order rightly. The
# page on temperatures does not tell of it. A test whether water freezes takes absolute zero for a hit.
# Seen: 0 degC equals 273.15 K, 0 K and 0 degF; it is also greater than 0 K and 0 degF.
source "$(dirname "$0")/common.sh"
debian_packages python3-pint=0.19.2-1
cat >zero.py <<'END'
import pint

quantity = pint.UnitRegistry().Quantity
frost = quantity(0, "degC")
for other in quantity(273.15, "kelvin"), quantity(0, "kelvin"), quantity(0, "degF"):
    print(f"{other:~}: equal {frost == other}, greater {frost > other};")
END
look_at "$python" zero.py
conclude "273.15 K: equal True, greater False; 0 K: equal True, greater True; 0 °F: equal True, greater True;" \
  "Pint takes 0 degC for equal to 0 kelvin, and to 273.15 kelvin too"

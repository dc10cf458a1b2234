#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: cdo 2.1.1-1+deb12u1.
# Behaviour: if a variable is of an integer type, what an operator makes of it is rounded to integers in the file: a quotient, a mean, a
# square root. Inside a chain of operators the same numbers are not rounded, so that a step through a file changes the result.
# Expected: 0.5 for 1 divided by 2, or a warning. The option -b sets the number of bits of the output; without it the type of the input
# stays, which is harmless for floats. CDO rounds in silence and with exit code 0.
# Seen: the integers 1, 2, 3, 4 divided by 2 are 0.5, 1, 1.5, 2 in a chain and 1, 1, 2, 2 from a file; their mean is 2.5 or 3.
source "$(dirname "$0")/common.sh"
debian_packages cdo=2.1.1-1+deb12u1
results() {
  local operator
  cdo -s -f nc -b I32 for,1,4 numbers.nc
  for operator in divc,2 timmean; do
    cdo -s "$operator" numbers.nc result.nc
    echo "$operator, chain: $(cdo -s -output "-$operator" numbers.nc | xargs) file: $(cdo -s output result.nc | xargs);"
  done
}
look_at results
conclude "divc,2, chain: 0.5 1 1.5 2 file: 1 1 2 2; timmean, chain: 2.5 file: 3;" \
  "CDO rounds the results for a variable of integers when it writes them to a file"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: plotutils 2.6-13 (its program ode).
# Behaviour: ode, which integrates differential equations, squares minus x where the equation says -x^2: the sign is bound closer than the
# power. After an operator the same characters mean the opposite, 0-x^2 is minus the square.
# Expected: -x^2 as 0-x^2, as in mathematics. The table of operators in the manual has the power at the top, alone; the minus stands two
# classes below, and no other one is named. A decay becomes an explosion, exp(-t^2) a function that grows.
# Seen: x' = -x^2 leads from 1 to 2 at the time 0.5, x' = 0-x^2 to 0.6667, which is right; x' = exp(-t^2) leads from 0 to 1.463 at 1, with
# parentheses around t^2 to 0.7468.
source "$(dirname "$0")/common.sh"
debian_packages plotutils=2.6-13
at_the_end() {  # of the equation x' = $1 from x = $2 at the time 0 to the time $3
  printf "x' = %s\nx = %s\nprint x\nstep 0, %s\n" "$1" "$2" "$3" | ode -p 4 | awk 'NF {x = $1} END {printf "%g", x}'
}
ends() {
  echo "-x^2 $(at_the_end '-x^2' 1 0.5), 0-x^2 $(at_the_end '0-x^2' 1 0.5);"
  echo "exp(-t^2) $(at_the_end 'exp(-t^2)' 0 1), exp(-(t^2)) $(at_the_end 'exp(-(t^2))' 0 1);"
}
look_at ends
conclude "-x^2 2, 0-x^2 0.6667; exp(-t^2) 1.463, exp(-(t^2)) 0.7468;" "-x^2 is the square of minus x in GNU ode, so that a decay explodes"

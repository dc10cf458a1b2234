#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: calculix-ccx 2.20-1.
# Behaviour: CalculiX looks at the first 20 characters of a real number and ignores the rest, so that a number with many digits loses the
# end of its exponent in silence: "2.100000000000000e+05" is 21 characters long and means 2.1.
# Expected: 210000, or an error. The manual gives user-defined names a greatest length, numbers none, and says that the data have no fixed
# format. Programs write such numbers: the format %.15e gives 21 characters.
# Seen: a cube of height 1 on a fixed base under tension; its top rises by 0.0019 with a modulus of 2.1e5 and by 190.5, a hundred thousand
# times more, with the same modulus in 21 characters. Both runs end with exit code 0 and without a message.
source "$(dirname "$0")/common.sh"
debian_packages calculix-ccx=2.20-1
deck() {
  cat <<END
*NODE, NSET=ALL
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*MATERIAL, NAME=STEEL
*ELASTIC
$1, 0
*SOLID SECTION, ELSET=CUBE, MATERIAL=STEEL
*STEP
*STATIC
*BOUNDARY
1, 1, 3
2, 2, 3
3, 3, 3
4, 3, 3
*CLOAD
5, 3, 100
6, 3, 100
7, 3, 100
8, 3, 100
*NODE PRINT, NSET=ALL
U
*END STEP
END
}
rise() {
  local modulus
  for modulus in 2.1e5 2.100000000000000e+05; do
    deck "$modulus" >cube.inp
    ccx cube >messages && echo "$modulus $(awk '$1 == 7 {print $4}' cube.dat)" || echo "$modulus refused"
  done
}
look_at rise
conclude "2.1e5 1.904762E-03 2.100000000000000e+05 1.904762E+02" \
  "CalculiX drops what lies behind the 20th character of a number, exponent included"

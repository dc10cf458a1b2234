#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: convert-units 2.3.4 (npm).
# Behaviour: a cubic foot has 1728.007 cubic inches and a cubic yard 27.00004 cubic feet, though a foot has 12 inches and a square foot 144
# square inches.
# Expected: 1728 and 27. Inch, foot and yard are exact by definition, 25.4 mm, 12 inches and 3 feet, and lengths and areas of the package
# agree with each other to all digits. The readme says nothing of accuracy.
# Seen: 12, 144, 1728.0071 and 27.000040.
source "$(dirname "$0")/common.sh"
npm_packages convert-units@2.3.4
cat >feet.cjs <<'END'
const convert = require('convert-units');
for (const [big, small] of [['ft', 'in'], ['ft2', 'in2'], ['ft3', 'in3'], ['yd3', 'ft3']])
  console.log(big, Number(convert(1).from(big).to(small).toPrecision(8)), small + ';');
END
look_at node feet.cjs
conclude "ft 12 in; ft2 144 in2; ft3 1728.0071 in3; yd3 27.00004 ft3;" "in convert-units a cubic foot has 1728.007 cubic inches"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: js-quantities 1.8.0 (npm).
# Behaviour: sqft, the library's unit of a square foot, is a square metre.
# Expected: 0.0929 square metres. The table of units defines it as 1 times foot times foot, but the number is taken for one of square
# metres, as it is for all other units; the acre beside it has its size in square metres. The documentation has no exception for it.
# Seen: 1 sqft is 1 m2 and 10.764 ft2; an acre has 4046.86 sqft instead of 43560.
source "$(dirname "$0")/common.sh"
npm_packages js-quantities@1.8.0
cat >area.cjs <<'END'
const Qty = require('js-quantities');
for (const [quantity, unit] of [['1 sqft', 'm2'], ['1 ft2', 'm2'], ['1 sqft', 'ft2'], ['1 acre', 'sqft'], ['1 acre', 'ft2']])
  console.log(quantity, '=', +Qty(quantity).to(unit).scalar.toPrecision(6), unit + ';');
END
look_at node area.cjs
conclude "1 sqft = 1 m2; 1 ft2 = 0.092903 m2; 1 sqft = 10.7639 ft2; 1 acre = 4046.86 sqft; 1 acre = 43560 ft2;" \
  "a square foot is a square metre in js-quantities"

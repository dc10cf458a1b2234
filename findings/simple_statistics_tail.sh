#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: simple-statistics 7.12.1 (npm).
# Behaviour: the cumulative probability of the standard normal distribution is never above 0.999 nor below 0.001: what lies beyond any
# number of standard deviations is a thousandth.
# Expected: 2.9e-7 beyond five standard deviations. The documentation tells of a lookup in a table of the distribution, not that the table
# ends and that the last entry holds for all that follows; the package has an error function that is good for seven digits.
# Seen: 0.001 beyond 5 and beyond 10; (1 - errorFunction(5 / sqrt 2)) / 2 is below 1e-6.
source "$(dirname "$0")/common.sh"
npm_packages simple-statistics@7.12.1
cat >tail.cjs <<'END'
const {cumulativeStdNormalProbability, errorFunction} = require('simple-statistics');
for (const z of [5, 10]) console.log('beyond', z + ':', (1 - cumulativeStdNormalProbability(z)).toFixed(4));
console.log('by errorFunction', (1 - errorFunction(5 / Math.SQRT2)) / 2 < 1e-6 ? 'below 1e-6' : 'more');
END
look_at node tail.cjs
conclude "beyond 5: 0.0010 beyond 10: 0.0010 by errorFunction below 1e-6" \
  "simple-statistics has one thousandth beyond any number of standard deviations"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: jstat 1.9.6 (npm).
# Behaviour: the median of a Pareto distribution is scale times shape times the square root of 2, which grows with the shape, although the
# values crowd at the scale then.
# Expected: scale times the shape-th root of 2, so that one half lies below, by the package's own cdf and inv. The documentation promises
# the median of the distribution. A sample of grain or crack sizes gets a median that 98 of 100 stay below.
# Seen: for scale 1 and shape 3 the median is 4.243 and cdf of it 0.987; inv(0.5) is 1.260.
source "$(dirname "$0")/common.sh"
npm_packages jstat@1.9.6
cat >median.cjs <<'END'
const {pareto} = require('jstat').jStat;
const median = pareto.median(1, 3);
console.log('median', median.toFixed(3), 'cdf', pareto.cdf(median, 1, 3).toFixed(3), 'inv', pareto.inv(0.5, 1, 3).toFixed(3));
END
look_at node median.cjs
conclude "median 4.243 cdf 0.987 inv 1.260" "jStat's median of a Pareto distribution is not where its own cdf is one half"

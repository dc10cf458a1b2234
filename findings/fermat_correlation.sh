#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: @mathigon/fermat 1.1.24 (npm).
# Behaviour: the correlation of n pairs is too small by the factor (n - 1) / n, also that of a series with itself: the covariance is divided
# by n and the variances by n - 1.
# Expected: 1 for a series with itself and with every series that grows in proportion. The two divisors are a matter of taste, but cancel
# in a correlation if both take the same; the comments say no more than variance, covariance and correlation. Few points on a straight line
# look scattered.
# Seen: with itself a series of 3 numbers has 0.667, one of 10 has 0.900; its covariance is 0.667 where its variance is 1.
source "$(dirname "$0")/common.sh"
npm_packages @mathigon/fermat@1.1.24
cat >series.cjs <<'END'
const {correlation, covariance, variance} = require('@mathigon/fermat');
for (const n of [3, 10]) {
  const series = Array.from({length: n}, (_, i) => i + 1);
  console.log(`${n}: correlation ${correlation(series, series).toFixed(3)},`,
              `covariance ${covariance(series, series).toFixed(3)}, variance ${variance(series).toFixed(3)};`);
}
END
look_at node series.cjs
conclude "3: correlation 0.667, covariance 0.667, variance 1.000; 10: correlation 0.900, covariance 8.250, variance 9.167;" \
  "the correlation of a series with itself is less than 1 in @mathigon/fermat"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: jstat 1.9.6 (npm).
# Behaviour: under a Poisson distribution, the probability of 200 events where 200 are expected is NaN, and so is the cumulative one: the
# power and the factorial in it overflow.
# Expected: 0.0282 and 0.5188. The package has the logarithm of the gamma function, and its binomial distribution is right at 500 of 1000;
# the documentation states no limit.
# Seen: 0.0399 and 0.5266 for 100 of 100; NaN and NaN for 200 of 200; the binomial distribution gives 0.0252.
source "$(dirname "$0")/common.sh"
npm_packages jstat@1.9.6
cat >counts.cjs <<'END'
const {jStat} = require('jstat');
for (const mean of [100, 200]) console.log(mean, jStat.poisson.pdf(mean, mean).toFixed(4), jStat.poisson.cdf(mean, mean).toFixed(4));
console.log('binomial', jStat.binomial.pdf(500, 1000, 0.5).toFixed(4));
END
look_at node counts.cjs
conclude "100 0.0399 0.5266 200 NaN NaN binomial 0.0252" "jStat gives NaN for a Poisson distribution of 200 events where 200 are expected"

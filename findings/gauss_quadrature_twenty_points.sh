#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: gauss-quadrature 1.0.0 (npm).
# Behaviour: the weights of a Gauss rule of 20 points or more are wrong, by factors of hundreds too, and others in each run: the points come
# from an iteration that begins at random numbers, and nothing tells that it has not arrived. Rules of 10 points are right to 13 digits.
# Expected: weights whose sum is the length of the interval, within the 1e-6 that the documentation states for the points. It gives no
# greatest number of points. More points are taken to make an integral more accurate.
# Seen: in five runs each the integral of 1 from -1 to 1, which is 2, was never within 1e-3 of it with 20 and with 24 points; with 20 it was
# 215 and 550 for example. With 10 points it was always 2.
source "$(dirname "$0")/common.sh"
npm_packages gauss-quadrature@1.0.0
cat >rules.cjs <<'END'
const rule = require('gauss-quadrature');
for (const points of [10, 20, 24]) {
  let wrong = 0;
  for (let run = 0; run < 5; ++run) {
    const integralOfOne = rule(points)[1].reduce((sum, weight) => sum + weight, 0);
    if (!(Math.abs(integralOfOne - 2) < 1e-3)) ++wrong;
  }
  console.log(`${points} points: ${wrong} of 5 wrong;`);
}
END
look_at node rules.cjs
conclude "10 points: 0 of 5 wrong; 20 points: 5 of 5 wrong; 24 points: 5 of 5 wrong;" \
  "Gauss rules of 20 points by gauss-quadrature do not integrate 1"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: matter-js 0.20.0.
# Behaviour: the moment of inertia of a body of several parts is the sum of those of the parts about their own centres, however far they
# lie from the common one; and that of each polygon is four times its moment of inertia.
# Expected: for a square of side 2 and mass 4 it is 4 (2^2 + 2^2) / 12 = 2.667; for two of them at a distance d the sum and 8 (d/2)^2, by
# the parallel axis theorem. The documentation calls the property the moment of inertia, and updates divide the torque by it.
# Seen: 10.667 for the square; 21.333 for two side by side, instead of 13.333; 21.333 at a distance of 20 too, instead of 805.333, so that
# a torque turns them 38 times too fast.
source "$(dirname "$0")/common.sh"
npm_packages matter-js@0.20.0
cat >inertia.js <<'END'
const { Bodies, Body } = require("matter-js");
const square = (x) => Bodies.rectangle(x, 0, 2, 2, { density: 1 });
console.log(`square of mass ${square(0).mass}: ${square(0).inertia.toFixed(3)} for 2.667;`);
for (const distance of [2, 20]) {
  const pair = Body.create({ parts: [square(-distance / 2), square(distance / 2)] });
  const right = 2 * 4 * (2 ** 2 + 2 ** 2) / 12 + 8 * (distance / 2) ** 2;
  console.log(`two, ${distance} apart: ${pair.inertia.toFixed(3)} for ${right.toFixed(3)};`);
}
END
look_at node inertia.js
conclude "square of mass 4: 10.667 for 2.667; two, 2 apart: 21.333 for 13.333; two, 20 apart: 21.333 for 805.333;" \
  "the moment of inertia of a matter-js body does not depend on how far its parts are from each other"

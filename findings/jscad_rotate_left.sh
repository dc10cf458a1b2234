#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: @jscad/modeling 2.13.0 (npm).
# Behaviour: extrudeRotate makes a body inside out of a shape that is left of the axis: its volume is negative, and to subtract it from a
# block leaves the body instead of the block without it.
# Expected: the ring that the same square right of the axis gives, which is the same set of points. The source says that all points of the
# shape must be left of the axis or all right of it, and the documentation has an option for shapes that are on both sides.
# Seen: 100.4 and -100.4 for a square of edge 2 around x = 4 and around x = -4 (exact: 100.5); a block of 8000 less the ring is 7899.6
# with the first and 100.4 with the second.
source "$(dirname "$0")/common.sh"
npm_packages @jscad/modeling@2.13.0
cat >ring.cjs <<'END'
const {booleans, extrusions, measurements, primitives} = require('@jscad/modeling');
const block = primitives.cube({size: 20});
for (const x of [4, -4]) {
  const ring = extrusions.extrudeRotate({segments: 64}, primitives.square({size: 2, center: [x, 0]}));
  const volumes = [ring, booleans.subtract(block, ring)].map(body => measurements.measureVolume(body).toFixed(1));
  console.log(`x = ${x}: ${volumes[0]}, block less ring ${volumes[1]};`);
}
END
look_at node ring.cjs
conclude "x = 4: 100.4, block less ring 7899.6; x = -4: -100.4, block less ring 100.4;" \
  "JSCAD makes a ring inside out of a shape left of the axis"

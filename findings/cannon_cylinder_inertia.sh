#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: cannon-es 0.20.0 (npm).
# Behaviour: the moments of inertia of a Cylinder are four times those of its bounding box, more than four and a half times too large, and
# alike about all axes if it is as high as wide. The same holds for every ConvexPolyhedron.
# Expected: m (3 r^2 + h^2) / 12 about a cross axis and m r^2 / 2 about its own, or at worst the moments of the bounding box: a comment in
# the source says that a box stands in for the body. Box and Sphere of the same package are exact. Whatever rolls, tips or tumbles does
# so too slowly.
# Seen: for mass 1, radius 1, height 2: 2.667 about each axis. Exact are 0.583 and 0.500; the bounding box, as Box, has 0.667.
source "$(dirname "$0")/common.sh"
npm_packages cannon-es@0.20.0
cat >bodies.mjs <<'END'
import {Box, Cylinder, Vec3} from 'cannon-es';
for (const shape of [new Box(new Vec3(1, 1, 1)), new Cylinder(1, 1, 2, 64)]) {
  const moments = new Vec3();
  shape.calculateLocalInertia(1, moments);
  console.log(shape.constructor.name, moments.toArray().map(x => x.toFixed(3)).join(' '));
}
END
look_at node bodies.mjs
conclude "Box 0.667 0.667 0.667 Cylinder 2.667 2.667 2.667" "cannon-es gives a cylinder more than four times its moments of inertia"

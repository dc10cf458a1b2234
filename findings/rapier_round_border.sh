#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: @dimforge/rapier3d-compat 0.21.0 (npm).
# Behaviour: the mass and the moments of inertia of a round cuboid, and of a round cylinder, are those of the core without its border,
# although the border collides.
# Expected: density times the volume of the body, as for all other shapes: of a ball as well as of a capsule, which is a segment with a
# border. The documentation of roundCuboid says that the border is added to the half extents.
# Seen: for density 1, half extents 1 and a border of 1 the mass is 8; the volume is 55. A capsule of the same border has its full mass.
source "$(dirname "$0")/common.sh"
npm_packages @dimforge/rapier3d-compat@0.21.0
cat >mass.mjs <<'END'
import rapier from '@dimforge/rapier3d-compat';
await rapier.init();
const world = new rapier.World({x: 0, y: 0, z: 0});
const box = 8 + 6 * 4 + 12 * 2 * Math.PI / 4 + 4 / 3 * Math.PI;  // the cube, six plates, twelve quarters of a cylinder, a ball
const capsule = 2 * Math.PI + 4 / 3 * Math.PI;
for (const [name, shape, volume] of [['capsule', rapier.ColliderDesc.capsule(1, 1), capsule],
                                     ['roundCuboid', rapier.ColliderDesc.roundCuboid(1, 1, 1, 1), box]]) {
  const body = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setTranslation(10 * world.bodies.len(), 0, 0));
  world.createCollider(shape.setDensity(1), body);
  world.step();
  console.log(name, body.mass().toFixed(2), 'of', volume.toFixed(2));
}
END
look_at node mass.mjs
conclude "capsule 10.47 of 10.47 roundCuboid 8.00 of 55.04" "Rapier leaves the border of a round cuboid out of its mass"

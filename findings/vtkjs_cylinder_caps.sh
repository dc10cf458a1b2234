#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: @kitware/vtk.js 37.4.3 (npm).
# Behaviour: the normals of the two caps of vtkCylinderSource are neither parallel to the axis nor of length 1: all of them also carry the
# cross components of the last normal on the side.
# Expected: (0, 1, 0) and (0, -1, 0), as the caps are perpendicular to the axis; so does the class of that name in VTK 9.1, and the normals
# of the side are right. Light, an offset along the normals or a flux through the caps goes wrong by 45 degrees.
# Seen: for 60 segments the two caps have the normals (0.995, 1, 0.105) and (0.995, -1, 0.105) of length 1.414; the side has length 1.
source "$(dirname "$0")/common.sh"
npm_packages @kitware/vtk.js@37.4.3
cat >caps.mjs <<'END'
import vtkCylinderSource from '@kitware/vtk.js/Filters/Sources/CylinderSource.js';
const resolution = 60;
const source = vtkCylinderSource.newInstance({resolution, capping: true});
source.update();
const normals = source.getOutputData().getPointData().getNormals();
const some = (first, count) => Array.from({length: count}, (_, i) => [...normals.getTuple(first + i)]);
const different = texts => [...new Set(texts)].join(' ');
const cap = first => different(some(first, resolution).map(normal => normal.map(x => x.toFixed(3)).join()));
console.log('side: length', different(some(0, 2 * resolution).map(normal => Math.hypot(...normal).toFixed(3))));
console.log('caps:', cap(2 * resolution), 'and', cap(3 * resolution));
END
look_at node caps.mjs
conclude "side: length 1.000 caps: 0.995,1.000,0.105 and 0.995,-1.000,0.105" \
  "the caps of vtk.js's cylinder have normals that lean by 45 degrees"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: delaunator 5.1.0 (npm), which d3-delaunay builds on.
# Behaviour: if the two axes have very different scales, points are left out of the triangulation, a third of them here, although all are
# distinct. The same points with each axis scaled to whole numbers are triangulated completely.
# Expected: a triangulation of all points: 100 of them with 162 triangles. The readme says that duplicate points are skipped, and that the
# output should be valid even on highly degenerate input, thanks to robust predicates. Time in seconds against a fraction is such a plane.
# Seen: a grid of 10 times, 100000 s apart, and 10 fractions, 0.0001 apart: 67 points and 103 triangles; scaled: 100 and 162.
source "$(dirname "$0")/common.sh"
npm_packages delaunator@5.1.0
cat >grid.mjs <<'END'
import Delaunator from 'delaunator';
for (const [step, fraction] of [[1, 1], [100000, 0.0001]]) {
  const points = [];
  for (let i = 0; i < 10; ++i)
    for (let j = 0; j < 10; ++j) points.push([i * step, j * fraction]);
  const triangles = Delaunator.from(points).triangles;
  console.log(new Set(triangles).size, 'points', triangles.length / 3, 'triangles');
}
END
look_at node grid.mjs
conclude "100 points 162 triangles 67 points 103 triangles" "delaunator leaves distinct points out if the axes have very different scales"

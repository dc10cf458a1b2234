#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: three 0.187.0 (npm), openctm-tools 1.0.3+dfsg1-2.1+b3, assimp-utils 5.2.5~ds0-1+b1.
# Behaviour: three readers make three meshes of one PLY file with a face of five corners and a triangle: three.js leaves the pentagon out
# and keeps the triangle, OpenCTM keeps the first three corners of the pentagon, Assimp gives all of it.
# Expected: four triangles from each, or a refusal. The faces of a PLY file are lists of any length, and duals and CAD programs write
# polygons. The header of three.js's loader names a limitation, on colours, but not this one.
# Seen: three.js 1 triangle, OpenCTM 2, Assimp 4.
source "$(dirname "$0")/common.sh"
npm_packages three@0.187.0
debian_packages openctm-tools=1.0.3+dfsg1-2.1+b3 assimp-utils=5.2.5~ds0-1+b1
cat >house.ply <<'END'
ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
2 0 0
2 1 0
1 2 0
0 1 0
3 0 0
4 0 0
3 1 0
5 0 1 2 3 4
3 5 6 7
END
cat >read.mjs <<'END'
import fs from 'fs';
import {PLYLoader} from 'three/examples/jsm/loaders/PLYLoader.js';
console.log(new PLYLoader().parse(fs.readFileSync('house.ply', 'latin1')).index.count / 3);
END
readers() {
  echo "three.js $(node read.mjs)"
  ctmconv house.ply house.obj >/dev/null
  echo "OpenCTM $(grep -c '^f' house.obj)"
  assimp export house.ply house.stl -fstl -tri >/dev/null
  echo "Assimp $(grep -c 'facet normal' house.stl)"
}
look_at readers
conclude "three.js 1 OpenCTM 2 Assimp 4" \
  "a PLY face of five corners is left out by three.js, cut to a triangle by OpenCTM and whole in Assimp"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: three 0.187.0 (npm).
# Behaviour: one line element ("l 1 2") among the faces of an object makes OBJLoader give the whole object as LineSegments: the corners of
# the triangles are taken in pairs as ends of lines, across triangles, and no surface is left.
# Expected: a mesh and lines beside it, or the mesh alone. An OBJ file may hold both kinds of elements in one object, and Blender writes
# such files for a mesh that has a loose edge.
# Seen: 2 triangles alone: Mesh, 6 corners; with the line: LineSegments, 8 ends.
source "$(dirname "$0")/common.sh"
npm_packages three@0.187.0
cat >read.mjs <<'END'
import {OBJLoader} from 'three/examples/jsm/loaders/OBJLoader.js';
const square = 'o square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';
for (const text of [square, square + 'l 1 2\n'])
  for (const part of new OBJLoader().parse(text).children) console.log(part.type, part.geometry.attributes.position.count);
END
look_at node read.mjs
conclude "Mesh 6 LineSegments 8" "one line element in an OBJ file turns all faces of the object into lines in three.js"

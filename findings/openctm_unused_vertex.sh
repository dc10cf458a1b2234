#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: openctm-tools 1.0.3+dfsg1-2.1+b3, assimp-utils 5.2.5~ds0-1+b1.
# Behaviour: a vertex of an OBJ file that no face uses keeps its number in OpenCTM, but is moved to the origin; Assimp drops it, so that
# all later vertices get other numbers.
# Expected: the vertex where it was, or a message. Fields that belong to the vertices are stored beside a mesh by number; and a point at the
# origin changes the bounding box and the centre.
# Seen: the vertex 7 8 9 becomes 0 0 0 in OpenCTM's PLY file; Assimp's PLY file has three vertices instead of four.
source "$(dirname "$0")/common.sh"
debian_packages openctm-tools=1.0.3+dfsg1-2.1+b3 assimp-utils=5.2.5~ds0-1+b1
cat >unused.obj <<'END'
v 7 8 9
v 1 1 1
v 2 1 1
v 1 2 1
f 2 3 4
END
converters() {
  ctmconv unused.obj openctm.ply >/dev/null
  echo "OpenCTM $(grep 'element vertex' openctm.ply), the first $(sed '1,/end_header/d' openctm.ply | head -n 1)"
  assimp export unused.obj assimp.ply -fply >/dev/null
  echo "Assimp $(grep 'element vertex' assimp.ply), the first $(sed '1,/end_header/d' assimp.ply | head -n 1)"
}
look_at converters
conclude "OpenCTM element vertex 4, the first 0 0 0 Assimp element vertex 3, the first 1 1 1" \
  "an OBJ vertex that no face uses moves to the origin in OpenCTM and vanishes in Assimp"

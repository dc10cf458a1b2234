#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: python3-meshio 7.0.0-3.
# Behaviour: meshio gives the values of a $NodeData section of a Gmsh file to the nodes in the order of its lines and ignores the node number
# on each line.
# Expected: each value at its node. The format has the number on every line for that, prescribes no order, and meshio does use the numbers
# of the $Nodes and $Elements sections.
# Seen: lines for the nodes 3, 1, 2 with 30, 10, 20: node 1 gets 30.
source "$(dirname "$0")/common.sh"
debian_packages python3-meshio=7.0.0-3
cat >nodes.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
3
1 0 0 0
2 1 0 0
3 0 1 0
$EndNodes
$Elements
1
1 2 2 1 1 1 2 3
$EndElements
$NodeData
1
"temperature"
1
0.0
3
0
1
3
3 30
1 10
2 20
$EndNodeData
END
cat >read.py <<'END'
import meshio

mesh = meshio.read("nodes.msh", file_format="gmsh")
for point, value in zip(mesh.points, mesh.point_data["temperature"]):
    print(*(f"{x:g}" for x in point), "has", f"{value:g};")
END
look_at "$python" read.py
conclude "0 0 0 has 30; 1 0 0 has 10; 0 1 0 has 20;" "meshio ignores the node numbers of a \$NodeData section of a Gmsh file"

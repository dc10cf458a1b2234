#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: gmsh 4.8.4+ds2-3.
# Behaviour: of each quadrilateral of second order Gmsh writes one of the two triangles to an STL file, so that half of the surface is
# missing. In a binary file the number of facets is that of both triangles, twice what follows. There is no warning.
# Expected: two triangles for each quadrilateral, as from the same mesh of first order: it covers the same flat rectangle. Triangles of
# second order are written whole.
# Seen: a rectangle of the area 2, four quadrilaterals: of first order 8 facets of the area 2, of second order 4 of the area 1; the binary
# file says 8 facets and has room for 4.
source "$(dirname "$0")/common.sh"
debian_packages gmsh=4.8.4+ds2-3
cat >rectangle.geo <<'END'
Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {2, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 2, 3, 4} = 3; Transfinite Surface{1}; Recombine Surface{1};
END
area() {
  awk '$1 == "vertex" {x[++n] = $2; y[n] = $3}
       $1 == "endfacet" {area += ((x[2] - x[1]) * (y[3] - y[1]) - (x[3] - x[1]) * (y[2] - y[1])) / 2; ++facets; n = 0}
       END {printf "%d facets, area %.2f", facets, area}' "$1"
}
facets() {
  local order
  for order in 1 2; do
    gmsh rectangle.geo -2 -order "$order" -o "text_$order.stl" >log
    gmsh rectangle.geo -2 -order "$order" -bin -o "binary_$order.stl" >log
    echo "order $order: $(area "text_$order.stl"), binary $(od -An -tu4 -j80 -N4 "binary_$order.stl" | xargs)" \
      "of $((($(wc -c <"binary_$order.stl") - 84) / 50));"
  done
}
look_at facets
conclude "order 1: 8 facets, area 2.00, binary 8 of 8; order 2: 4 facets, area 1.00, binary 8 of 4;" \
  "Gmsh leaves half of each quadrilateral of second order out of an STL file"

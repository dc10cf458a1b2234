#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: libfcl-dev and libfcl0.7 0.7.0-3+b1, with libccd-dev 2.1-2+b1, liboctomap-dev 1.9.7+dfsg-3+b1 and libeigen3-dev 3.4.0-4.
# Behaviour: the moments of inertia of a Convex are those for mass 1; those of all other shapes are those for density 1. The moments related
# to the centre of mass mix the two and become negative for a body away from the origin.
# Expected: one convention for one virtual function: the same cube as Box and as Convex has the same moments, as it has the same volume. The
# documentation of the function says "the inertia matrix, related to the origin".
# Seen: a cube of edge 2 has 5.333 as Box and 0.667 as Convex; a Convex cube 5 away from the origin has the moments 0.667, -174.333 and
# -174.333 about its own centre.
source "$(dirname "$0")/common.sh"
debian_packages libfcl-dev=0.7.0-3+b1 libfcl0.7=0.7.0-3+b1 libccd-dev=2.1-2+b1 libccd2=2.1-2+b1 \
  liboctomap-dev=1.9.7+dfsg-3+b1 liboctomap1.9=1.9.7+dfsg-3+b1 libeigen3-dev=3.4.0-4
cat >cube.cpp <<'END'
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <cstdio>

fcl::Convex<double> cube(double x_of_centre) {
  auto corners = std::make_shared<std::vector<fcl::Vector3<double>>>();
  for (int x : {-1, 1})
    for (int y : {-1, 1})
      for (int z : {-1, 1}) corners->emplace_back(x + x_of_centre, y, z);
  auto faces = std::make_shared<std::vector<int>>(
      std::vector<int>{4, 0, 1, 3, 2, 4, 4, 6, 7, 5, 4, 0, 4, 5, 1, 4, 2, 3, 7, 6, 4, 0, 2, 6, 4, 4, 1, 5, 7, 3});
  return {corners, 6, faces};
}

int main() {
  const fcl::Box<double> box(2, 2, 2);
  const fcl::Convex<double> convex = cube(0), away = cube(5);
  std::printf("volume: Box %g Convex %g\n", box.computeVolume(), convex.computeVolume());
  std::printf("moment: Box %.3f Convex %.3f\n", box.computeMomentofInertia()(0, 0), convex.computeMomentofInertia()(0, 0));
  const auto moments = away.computeMomentofInertiaRelatedToCOM().diagonal().eval();
  std::printf("away: %.3f %.3f %.3f\n", moments[0], moments[1], moments[2]);
}
END
compile cube.cpp -lfcl -lccd -loctomap -loctomath
look_at ./program
conclude "volume: Box 8 Convex 8 moment: Box 5.333 Convex 0.667 away: 0.667 -174.333 -174.333" \
  "FCL gives the moments of inertia of a Convex for mass 1 and those of other shapes for density 1"

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libnanoflann-dev 1.4.3+ds-2.
# Behaviour: in a tree of angles with metric_SO2 the nearest angle is not the nearest one: the distance has a sign, so that the angle
# furthest in the negative direction counts as the nearest.
# Expected: of -3, -1, 0.1 and 2 the one nearest to 0 is 0.1. All angles lie in the range from -pi to pi, as the header asks; a metric is
# never negative, and a search for the nearest takes the smallest.
# Seen: -3 is the nearest to 0, at a distance of -3; of 200 other searches 2 agreed with a comparison of all angles. The metric L1,
# which knows no circle, finds 0.1.
source "$(dirname "$0")/common.sh"
debian_packages libnanoflann-dev=1.4.3+ds-2
cat >angles.cpp <<'END'
#include <nanoflann.hpp>
#include <cmath>
#include <cstdio>
#include <vector>

struct Angles {
  std::vector<double> values;
  size_t kdtree_get_point_count() const { return values.size(); }
  double kdtree_get_pt(size_t i, size_t) const { return values[i]; }
  template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
};

template <class Metric> void nearest(const char* name, const Angles& angles, double angle, double& found, double& distance) {
  using Distance = typename Metric::template traits<double, Angles>::distance_t;
  nanoflann::KDTreeSingleIndexAdaptor<Distance, Angles, 1> tree(1, angles);
  tree.buildIndex();
  uint32_t number = 0;
  if (tree.knnSearch(&angle, 1, &number, &distance) != 1) std::puts("nothing found");
  found = angles.values[number];
  if (name) std::printf("%s: %g at %g;\n", name, found, distance);
}

int main() {
  const Angles four{{-3, -1, 0.1, 2}};
  double found = 0, distance = 0;
  nearest<nanoflann::metric_SO2>("SO2", four, 0, found, distance);
  nearest<nanoflann::metric_L1>("L1", four, 0, found, distance);
  Angles many;
  for (int i = 0; i < 200; ++i) many.values.push_back(std::remainder(2.4 * i, 2 * M_PI));
  int right = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = std::remainder(1.7 * i + 0.3, 2 * M_PI);
    double least = 10;
    for (const double other : many.values) least = std::min(least, std::abs(std::remainder(other - angle, 2 * M_PI)));
    nearest<nanoflann::metric_SO2>(nullptr, many, angle, found, distance);
    right += std::abs(std::remainder(found - angle, 2 * M_PI)) < least + 1e-12;
  }
  std::printf("%d of 200 right\n", right);
}
END
compile angles.cpp
look_at ./program
conclude "SO2: -3 at -3; L1: 0.1 at 0.1; 2 of 200 right" "nanoflann's nearest angle is the one furthest in the negative direction"

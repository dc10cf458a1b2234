#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libboost1.81-dev 1.81.0-5+deb12u1 (Boost.Accumulators).
# Behaviour: the median of one or two samples is 0, that of three or four samples the third that came, whatever the others are.
# Expected: the median, for so few samples. It is an estimate, by markers of which there are five; but up to five samples the markers are
# the samples themselves, and from the fifth on they are sorted. The documentation gives no least number of samples, and min, max and mean
# of the same samples are right from the first one on.
# Seen: 20 and 20 have the median 0 and the minimum 20; of 10, 20, 30 it is 30; of 10, 20, 30, 40, 50 it is 30, which is right.
source "$(dirname "$0")/common.sh"
debian_packages libboost1.81-dev=1.81.0-5+deb12u1
cat >median.cpp <<'END'
#include <boost/accumulators/accumulators.hpp>
#include <boost/accumulators/statistics.hpp>
#include <cstdio>
#include <vector>
namespace acc = boost::accumulators;

int main() {
  for (const std::vector<double>& samples : {std::vector<double>{20, 20}, {10, 20, 30}, {10, 20, 30, 40, 50}}) {
    acc::accumulator_set<double, acc::stats<acc::tag::median, acc::tag::min>> set;
    for (const double sample : samples) set(sample);
    std::printf("of %zu: median %g minimum %g\n", samples.size(), acc::median(set), acc::min(set));
  }
}
END
compile median.cpp
look_at ./program
conclude "of 2: median 0 minimum 20 of 3: median 30 minimum 10 of 5: median 30 minimum 10" \
  "Boost.Accumulators gives 0 as the median of 20 and 20, and 30 as that of 10, 20 and 30"

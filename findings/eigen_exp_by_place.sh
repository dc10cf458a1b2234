#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libeigen3-dev 3.4.0-4.
# Behaviour: exp of minus infinity is a small positive number in the places of an array that vector instructions treat, and 0 in those left
# over at its end; log of a number below the smallest normal one is wrong in the same places.
# Expected: one result for one number wherever it stands, and exp(-infinity) = 0, as std::exp gives. The page of coefficient-wise functions
# says that exp and log of an array are those of its elements.
# Seen: five floats, all minus infinity: the first exponential is 2.9e-39, the last 0; five floats, all 1e-40: the first logarithm is
# -87.34, the last -92.10, which is right.
source "$(dirname "$0")/common.sh"
debian_packages libeigen3-dev=3.4.0-4
cat >places.cpp <<'END'
#include <Eigen/Core>
#include <cstdio>
#include <limits>

int main() {
  const Eigen::ArrayXf exponentials = Eigen::ArrayXf::Constant(5, -std::numeric_limits<float>::infinity()).eval().exp();
  const Eigen::ArrayXf logarithms = Eigen::ArrayXf::Constant(5, 1e-40f).eval().log();
  std::printf("exp first %.1e last %.1e\n", exponentials[0], exponentials[4]);
  std::printf("log first %.2f last %.2f\n", logarithms[0], logarithms[4]);
}
END
compile places.cpp
look_at ./program
conclude "exp first 2.9e-39 last 0.0e+00 log first -87.34 last -92.10" \
  "in Eigen, exp of minus infinity is 0 or not, by the place in the array"

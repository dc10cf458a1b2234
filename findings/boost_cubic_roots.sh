#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libboost1.81-dev 1.81.0-5+deb12u1 (Boost.Math).
# Behaviour: cubic_roots gives wrong roots if the cubic term is small: it divides by its coefficient, and the roots of ordinary size are
# differences of very large numbers, which one step of correction does not mend.
# Expected: the roots 1 and 2 of (a x + 1) (x - 1) (x - 2), to many digits for every small a: they are simple, far from each other and
# hardly depend on a. Without the cubic term, a = 0, the same function gives 1 and 2; and with the coefficients in reverse order, which
# have the reciprocals of the roots, it gives them too. The documentation promises values of the polynomial at the roots of the order of
# rounding errors, and warns of double roots only.
# Seen: 0.47 and 2.53 for a = 1e-9, where the polynomial is 0.8; none, only the third root -1/a, for a = 1e-12.
source "$(dirname "$0")/common.sh"
debian_packages libboost1.81-dev=1.81.0-5+deb12u1
cat >cubic.cpp <<'END'
#include <boost/math/tools/cubic_roots.hpp>
#include <cstdio>

int main() {
  using boost::math::tools::cubic_roots;
  for (const double a : {1e-3, 1e-9, 1e-12}) {
    const auto roots = cubic_roots(a, 1 - 3 * a, 2 * a - 3, 2.0);
    const auto reverse = cubic_roots(2.0, 2 * a - 3, 1 - 3 * a, a);
    std::printf("%g: %.2f %.2f, reverse %.2f %.2f;\n", a, roots[1], roots[2], 1 / reverse[2], 1 / reverse[1]);
  }
  const auto square = cubic_roots(0.0, 1.0, -3.0, 2.0);
  std::printf("0: %.2f %.2f\n", square[0], square[1]);
}
END
compile cubic.cpp
look_at ./program
conclude "0.001: 1.00 2.00, reverse 1.00 2.00; 1e-09: 0.47 2.53, reverse 1.00 2.00; 1e-12: nan nan, reverse 1.00 2.00; 0: 1.00 2.00" \
  "Boost's roots of a cubic with a small cubic term are wrong or missing"

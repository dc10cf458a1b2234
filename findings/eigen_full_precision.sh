#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libeigen3-dev 3.4.0-4.
# Behaviour: IOFormat with FullPrecision prints 15 digits of a double and 6 of a float. Neither is enough to read the number back: 0.1 + 0.2
# is printed as 0.3, which is another double.
# Expected: what the name and the reference of IOFormat promise, a number of digits that matches the full precision of the type: 17 and 9,
# as std::numeric_limits has in max_digits10. (Eigen takes digits10, the digits that survive from text to number and back.)
# Seen: "0.3 0.333333", and reading it back gives two other numbers.
source "$(dirname "$0")/common.sh"
debian_packages libeigen3-dev=3.4.0-4
cat >matrix.cpp <<'END'
#include <Eigen/Core>
#include <iostream>
#include <sstream>
int main() {
  const Eigen::IOFormat format(Eigen::FullPrecision);
  const Eigen::Matrix<double, 1, 1> number(0.1 + 0.2);
  const Eigen::Matrix<float, 1, 1> single(1.0f / 3);
  std::stringstream text;
  text << number.format(format) << ' ' << single.format(format);
  double number_again = 0;
  float single_again = 0;
  text >> number_again >> single_again;
  std::cout << text.str() << '\n';
  for (const bool same : {number_again == number(0), single_again == single(0)}) std::cout << (same ? "same\n" : "other\n");
}
END
compile matrix.cpp
look_at ./program
conclude "0.3 0.333333 other other" "Eigen's FullPrecision prints too few digits to read a matrix back"

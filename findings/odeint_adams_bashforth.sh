#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libboost1.81-dev 1.81.0-5+deb12u1 (Boost.Numeric.Odeint).
# Behaviour: the first steps of adams_bashforth, until it has enough former steps, are far too long if the state is changed in place, as
# integrate_const does it. They are made by extrapolation_stepper, which writes its first estimate into the state and takes that as the
# beginning of all later ones. Nothing of this shows in a smooth result: the error is that of another initial value.
# Expected: with the slope 1, which every method integrates without error, the place x after the time x. The header describes do_step with
# the state in place as one step of the method, like the one that leaves the initial state alone, and that one is right.
# Seen: after ten steps of 0.1 with the slope 1 the methods of 2, 4 and 8 steps are at 1.13, 1.40 and 7.60 instead of 1; with another
# vector for the result all are at 1, and adams_bashforth_moulton is so in both ways.
source "$(dirname "$0")/common.sh"
debian_packages libboost1.81-dev=1.81.0-5+deb12u1
cat >slope.cpp <<'END'
#include <cstdio>
#include <utility>
#include <vector>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>

using namespace boost::numeric::odeint;
using State = std::vector<double>;

void slope(const State&, State& derivative, double) { derivative[0] = 1; }

template <class Stepper> void run(const char* name) {
  State integrated{0}, old{0}, result{0};
  integrate_const(Stepper(), slope, integrated, 0.0, 1.0, 0.1);
  Stepper stepper;
  for (int step = 0; step < 10; ++step) {
    stepper.do_step(slope, old, 0.1 * step, result, 0.1);
    old = result;
  }
  std::printf("%s: %.2f in place, %.2f not;\n", name, integrated[0], result[0]);
}

int main() {
  run<adams_bashforth<2, State>>("2 steps");
  run<adams_bashforth<4, State>>("4");
  run<adams_bashforth<8, State>>("8");
  run<adams_bashforth_moulton<4, State>>("with corrector");
}
END
compile slope.cpp
look_at ./program
conclude "2 steps: 1.13 in place, 1.00 not; 4: 1.40 in place, 1.00 not; 8: 7.60 in place, 1.00 not; with corrector: 1.00 in place, 1.00 not;" \
  "the first steps of odeint's adams_bashforth in place are too long: x' = 1 does not lead to 1 at the time 1"

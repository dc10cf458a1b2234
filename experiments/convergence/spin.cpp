// SPDX-License-Identifier: MIT
// An elastic disc, one metre in radius, one cell thick, spins freely for many turns. In units in which rho = E = 1, with nu = 0, it widens
// by
//     u(r) = omega^2 r (3 R^2 - r^2) / 8,   so that its moment of inertia grows by 7/12 (omega R)^2,
// about which it swings, since the start is sudden.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/common/study_scene.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

/// Mean square distance from the axis [m^2].
double moment_of_inertia(const Simulation& simulation) {
  const Snapshot now = simulation.snapshot();
  double sum = 0;
  for (const Vector3& x : now.position) sum += x[0] * x[0] + x[1] * x[1];
  return sum / static_cast<double>(now.id.size());
}

}  // namespace

std::vector<Errors> spinning_disc(bool quick) {
  constexpr double omega = 0.1;
  const double turns = quick ? 4 : 100, period = 2 * std::numbers::pi / omega;
  Errors angular, inertia;
  angular.quantity = fmt::format("angular momentum after {} turns", turns);
  angular.figure = Errors::Figure::largest_error;
  angular.high = 1e-9;
  angular.why = "APIC keeps it to round-off: 1e5 steps of at most 1e-14 each";
  inertia.quantity = fmt::format("growth of the moment of inertia, mean of {} turns", turns);
  inertia.low = 0.7, inertia.high = 2.3;
  inertia.why =
      "first to second order, by the rim: particles in rows make it ragged by a share of dx, now outside and now inside of the circle. The "
      "mean of "
      "a swing is its rest, however much of it is left";
  angular.refined = inertia.refined = "cells in the radius";
  angular.refinements = inertia.refinements = quick ? std::vector<double>{4, 6, 8, 12} : std::vector<double>{4, 6, 8};
  for (const double n : inertia.refinements) {
    StudyScene setting("motion, elasticity");
    const double dx = setting.dx = 1 / n;
    const double sample = period / 100;  // some seven to a swing of the disc
    setting.frame_s = sample;
    setting.low = {-1.5, -1.5, 0};
    setting.high = {1.5, 1.5, dx};
    setting.faces = "z_min = \"slip\"\nz_max = \"slip\"\n";
    setting.time = "safety = 0.5";
    setting.material += "young_modulus_Pa = 1\npoisson_ratio = 0\n";
    setting.shape = fmt::format("cylinder = {{ from_m = [0, 0, 0], to_m = [0, 0, {:.17g}], radius_m = 1 }}", dx);
    setting.body = fmt::format("jitter = 0\nangular_velocity_rad_per_s = [0, 0, {}]", omega);
    const auto s = setting.begin();
    const double L = s->total(total::angular_momentum, 2), at_first = moment_of_inertia(*s);
    double mean = 0;
    for (int i = 1; i <= 100 * turns; ++i) {
      run_to(*s, i * sample);
      mean += moment_of_inertia(*s) / (100 * turns);
    }
    angular.errors.push_back(std::abs(s->total(total::angular_momentum, 2) / L - 1));
    const double widening = 7. / 12 * omega * omega;
    inertia.errors.push_back(std::abs((mean / at_first - 1) / widening - 1));
  }
  return {angular, inertia};
}

}  // namespace bake::studies

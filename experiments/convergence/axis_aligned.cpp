// SPDX-License-Identifier: MIT
// Axis-aligned manufactured solution: a cube of 1 m between its walls, with
//     x_i = X_i + a_i sin(pi X_i),   a_i(t) = A S(t) sin(pi (c t + phi_i)),   A = 0.05, c = 1, phi = (0, 2/3, 4/3).
// S rises smoothly from 0 to 1 in the first half second, since a body starts without strain and the standing waves alone do not.
//
// F is diagonal, F_i = 1 + a_i pi cos(pi X_i). Hencky's law gives tau_i = lambda ln J + 2 mu ln F_i, and P = tau F^-T is diagonal as well.
// Of div P axis i sees only dP_i/dX_i, in which X_i changes F_i alone:
//     P_i = tau_i / F_i,   dP_i/dX_i = (lambda + 2 mu - tau_i) F_i' / F_i^2,   F_i' = -a_i pi^2 sin(pi X_i).
// Momentum, rho_0 x_i'' = dP_i/dX_i + rho_0 b_i, asks for the body force
//     b_i = a_i'' sin(pi X_i) - (lambda + 2 mu - tau_i) F_i' / (F_i^2 rho_0).
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/common/study_scene.h"
#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/manufactured.h"
#include "solver/core/vector3.h"

namespace bake::studies {

namespace axis_aligned {

namespace {

using std::numbers::pi;

constexpr double A = 0.05, c = 1, k_rise = 0.5;
constexpr Vector3 phi{0, 2. / 3, 4. / 3};

/// A function of time with its first two derivatives.
struct Course {
  double value, rate, second;
};

Course product(const Course& f, const Course& g) {
  return {f.value * g.value, f.rate * g.value + f.value * g.rate, f.second * g.value + 2 * f.rate * g.rate + f.value * g.second};
}

/// S(t) = s^3 (10 - 15 s + 6 s^2), whose first two derivatives vanish at both ends.
Course rise(double t) {
  const double s = t / k_rise;
  if (s >= 1) return {1, 0, 0};
  return {s * s * s * (10 - 15 * s + 6 * s * s), 30 * s * s * (1 - s) * (1 - s) / k_rise,
          60 * s * (1 - s) * (1 - 2 * s) / (k_rise * k_rise)};
}

Course amplitude(std::size_t axis, double t) {
  const double w = pi * c, angle = pi * (c * t + phi[axis]);
  return product({A, 0, 0}, product(rise(t), {std::sin(angle), w * std::cos(angle), -w * w * std::sin(angle)}));
}

/// X of what is at x = X + a sin(pi X): Newton, which from X = x gains all digits in five steps since a pi < 0.16.
double first_place(double x, double a) {
  double X = x;
  for (int i = 0; i < 5; ++i) X -= (X + a * std::sin(pi * X) - x) / (1 + a * pi * std::cos(pi * X));
  return X;
}

}  // namespace

Point position(const Point& X, double t) {
  Point x = X;
  for (std::size_t i = 0; i < 3; ++i) x[i] += amplitude(i, t).value * std::sin(pi * X[i]);
  return x;
}

Vector3 velocity(const Point& x, double t) {
  Vector3 v;
  for (std::size_t i = 0; i < 3; ++i) {
    const Course a = amplitude(i, t);
    v[i] = a.rate * std::sin(pi * first_place(x[i], a.value));
  }
  return v;
}

Vector3 body_force(const Point& x, double t) {
  Vector3 F, sine, a, second;
  for (std::size_t i = 0; i < 3; ++i) {
    const Course course = amplitude(i, t);
    const double X = first_place(x[i], course.value);
    a[i] = course.value;
    second[i] = course.second;
    sine[i] = std::sin(pi * X);
    F[i] = 1 + course.value * pi * std::cos(pi * X);
  }
  const double ln_J = std::log(F[0] * F[1] * F[2]);
  Vector3 b;
  for (std::size_t i = 0; i < 3; ++i) {
    const double tau = elastic::lambda * ln_J + 2 * elastic::mu * std::log(F[i]), F_slope = -a[i] * pi * pi * sine[i];
    b[i] = second[i] * sine[i] - (elastic::lambda + 2 * elastic::mu - tau) * F_slope / (F[i] * F[i]);
  }
  return b;
}

namespace {

bool in_cube(const Point& x) {
  for (const double along : x)
    if (!(along > 0 && along < 1)) return false;
  return true;
}

/// Between walls that slip; or, `beyond` cells deep, in material that is held to the exact velocity.
double error(double cells, bool held, int rows) {
  constexpr double t = 1;
  StudyScene setting("motion, elasticity");
  const double dx = setting.dx = 1 / cells, beyond = held ? 2 * dx : 0, air = held ? 2 * dx : 0;
  setting.frame_s = t;
  for (std::size_t i = 0; i < 3; ++i) setting.low[i] = -beyond - air, setting.high[i] = 1 + beyond + air;
  setting.faces = "x_min = \"slip\"\nx_max = \"slip\"\ny_min = \"slip\"\ny_max = \"slip\"\nz_min = \"slip\"\nz_max = \"slip\"\n";
  setting.time = fmt::format("safety = 1\nlargest_step_s = {:.17g}", dx / 4);
  setting.material += elastic::material;
  setting.particles_per_cell = rows * rows * rows;
  setting.shape = fmt::format("box = {{ centre_m = [0.5, 0.5, 0.5], half_extents_m = [{0:.17g}, {0:.17g}, {0:.17g}] }}", 0.5 + beyond);
  setting.body = "jitter = 0";
  const auto s = setting.begin();
  s->set_force([=](const Point& x, const Vector3& v, double time, double dt) {
    return held && !in_cube(x) ? velocity(x, time + dt / 2) : v + dt * body_force(x, time);
  });
  return place_error(*s, t, in_cube, position) / A;
}

}  // namespace

}  // namespace axis_aligned

std::vector<Errors> axis_aligned_waves(bool quick) {
  Errors between_walls, continued, with_27;
  between_walls.quantity = "place at t = 1 between walls that slip, rms, relative to A";
  between_walls.low = 0.8, between_walls.high = 1.4;
  between_walls.why =
      "first order from the surface layer: the nodes behind a wall do not continue the velocity's line but slip as well, so that the half "
      "cell at the wall strains too little";
  continued.quantity = "place at t = 1, beyond the cube material held to the exact velocity, rms, relative to A";
  with_27.quantity = continued.quantity + ", 27 particles a cell";
  continued.low = 1.6, with_27.low = 1.7;
  continued.high = with_27.high = 2.3;
  continued.why =
      "second order in space and in time (places and velocities stand half a step apart, as in leapfrog); what 8 particles a cell of "
      "changing stretch leave of noise in the stress shows on the finest grids";
  with_27.why = "second order: the same with less noise";
  for (Errors* e : {&between_walls, &continued, &with_27}) {
    e->refined = "cells in the edge";
    e->refinements = quick ? std::vector<double>{8, 12, 16} : std::vector<double>{8, 12, 16, 24, 32};
    for (const double n : e->refinements) e->errors.push_back(axis_aligned::error(n, e != &between_walls, e == &with_27 ? 3 : 2));
  }
  return {between_walls, continued, with_27};
}

}  // namespace bake::studies

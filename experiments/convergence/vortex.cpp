// SPDX-License-Identifier: MIT
// Generalised vortex: the rings of an annulus turn about its axis by
//     alpha(R, t) = A sin(pi c t) h(R),   h = 1 - 32 (R - 1)^2 + 256 (R - 1)^4,   A = 0.3, c = 1,
// that is h = (1 - 16 (R - 1)^2)^2: the free rims at R = 0.75 and 1.25 rest and are not sheared. A body turned and sheared at once shows
// what a transfer loses of rotation.
//
// In the turned directions e_r, e_theta the motion is simple shear: F = e_r E_R + e_theta E_Theta + gamma e_theta E_R with
// gamma = R d alpha/dR, so that J = 1 and
//     b = F F^T = [1, gamma; gamma, 1 + gamma^2],   of principal stretches exp(+-s), sinh s = gamma / 2.
// b = cosh(2 s) I + sinh(2 s) N has the logarithm 2 s N, and Hencky's stress 2 mu s N is
//     tau_rtheta = 2 mu s / cosh s,   tau_thetatheta = -tau_rr = 2 mu s tanh s.
// r = R and rho = rho_0, so that the balance of momentum in polar coordinates asks for
//     b_r     = -R alpha_t^2 - (d tau_rr/dR + 2 tau_rr / R) / rho_0,
//     b_theta =  R alpha_tt  - (d tau_rtheta/dR + 2 tau_rtheta / R) / rho_0,
// with ds/dR = (d gamma/dR) / (2 cosh s). tau_rtheta grows with gamma up to gamma = 3 only; A = 0.3 keeps below 1.9.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/common/study_scene.h"
#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/manufactured.h"
#include "solver/core/vector3.h"

namespace bake::studies {

namespace vortex {

namespace {

using std::numbers::pi;

constexpr double A = amplitude, c = 1;

double h(double R) { return std::pow(1 - 16 * (R - 1) * (R - 1), 2); }
double h_slope(double R) { return -64 * (R - 1) + 1024 * std::pow(R - 1, 3); }
double h_bend(double R) { return -64 + 3072 * (R - 1) * (R - 1); }

double radius(const Point& x) { return std::hypot(x[0], x[1]); }

/// Unit vectors outwards and about the axis at x.
struct Directions {
  Vector3 r, theta;
};
Directions directions(const Point& x) {
  const double R = radius(x);
  return {{x[0] / R, x[1] / R, 0}, {-x[1] / R, x[0] / R, 0}};
}

}  // namespace

Point position(const Point& X, double t) {
  const double alpha = A * std::sin(pi * c * t) * h(radius(X)), cosine = std::cos(alpha), sine = std::sin(alpha);
  return {cosine * X[0] - sine * X[1], sine * X[0] + cosine * X[1], X[2]};
}

Vector3 velocity(const Point& x, double t) {
  const double R = radius(x);
  return (A * pi * c * std::cos(pi * c * t) * R * h(R)) * directions(x).theta;
}

Vector3 body_force(const Point& x, double t) {
  const double R = radius(x), g = A * std::sin(pi * c * t);
  const double alpha_t = A * pi * c * std::cos(pi * c * t) * h(R), alpha_tt = -pi * pi * c * c * g * h(R);
  const double gamma = R * g * h_slope(R), gamma_slope = g * (h_slope(R) + R * h_bend(R));
  const double s = std::asinh(gamma / 2), cosh = std::cosh(s), tanh = std::tanh(s), s_slope = gamma_slope / (2 * cosh);
  const double tau_rr = -2 * elastic::mu * s * tanh, tau_rr_slope = -2 * elastic::mu * (tanh + s / (cosh * cosh)) * s_slope;
  const double tau_rtheta = 2 * elastic::mu * s / cosh, tau_rtheta_slope = 2 * elastic::mu * (1 - s * tanh) / cosh * s_slope;
  const double b_r = -R * alpha_t * alpha_t - (tau_rr_slope + 2 * tau_rr / R);
  const double b_theta = R * alpha_tt - (tau_rtheta_slope + 2 * tau_rtheta / R);
  const auto [e_r, e_theta] = directions(x);
  return b_r * e_r + b_theta * e_theta;
}

bool in_annulus(const Point& x) { return std::abs(radius(x) - 1) < 0.25; }

StudyScene setting(double cells, bool held) {
  StudyScene setting("motion, elasticity");
  const double dx = setting.dx = 1 / cells, beyond = held ? 2 * dx : 0;
  setting.frame_s = furthest_s;
  setting.low = {-1.5, -1.5, 0};
  setting.high = {1.5, 1.5, dx};
  setting.faces = "z_min = \"slip\"\nz_max = \"slip\"\n";
  setting.material += elastic::material;
  setting.body = "jitter = 0";
  setting.shape = fmt::format(R"(difference = [
  {{ cylinder = {{ from_m = [0, 0, 0], to_m = [0, 0, {0:.17g}], radius_m = {1:.17g} }} }},
  {{ cylinder = {{ from_m = [0, 0, {2:.17g}], to_m = [0, 0, {3:.17g}], radius_m = {4:.17g} }} }} ])",
                              dx, 1.25 + beyond, -dx, 2 * dx, 0.75 - beyond);
  return setting;
}

NodalForce force(bool held) {
  return [held](const Point& x, const Vector3& v, double time, double dt) {
    const bool given = time == 0 || (held && !in_annulus(x));  // in the first step the velocity that the rings start with
    return given ? velocity(x, time + dt / 2) : v + dt * body_force(x, time);
  };
}

namespace {

double error(double cells, bool held, const char* transfer) {
  StudyScene scene = setting(cells, held);
  scene.motion = fmt::format("transfer = \"{}\"", transfer);
  scene.time = fmt::format("safety = 1\nlargest_step_s = {:.17g}", scene.dx / 4);
  const auto s = scene.begin();
  s->set_force(force(held));
  return place_error(*s, furthest_s, in_annulus, position) / A;
}

}  // namespace

}  // namespace vortex

std::vector<Errors> generalised_vortex(bool quick) {
  struct Variant {
    bool held;
    const char* transfer;
    double low, high;
    const char* why;
  };
  std::vector<Variant> variants{
      {true, "apic", 1.6, 2.3, "second order in space and in time (places and velocities stand half a step apart, as in leapfrog)"},
      {false, "apic", 0.9, 1.7,
       "first order from the rims, and steeper as long as these are barely resolved: there the stress is nothing but its slope and the "
       "body "
       "force are largest, and of a node outside the rim the cut stencils make its few particles' stress and its own place's force"}};
  if (!quick)
    variants.push_back({true, "flip", 1.3, 2.3, "second order, until the noise shows that FLIP lets particles keep and APIC does not"});
  std::vector<Errors> all;
  for (const Variant& v : variants) {
    Errors e;
    e.quantity = fmt::format("place at t = 1/2 with {}, {}, rms, relative to A", v.transfer,
                             v.held ? "beyond the rims material held to the exact velocity" : "free rims");
    e.low = v.low, e.high = v.high;
    e.why = v.why;
    e.refined = "cells in the radius";
    e.refinements = quick ? std::vector<double>{24, 32, 40} : std::vector<double>{24, 32, 48, 64};
    for (const double n : e.refinements) e.errors.push_back(vortex::error(n, v.held, v.transfer));
    all.push_back(e);
  }
  return all;
}

}  // namespace bake::studies

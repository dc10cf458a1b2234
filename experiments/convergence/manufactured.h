// SPDX-License-Identifier: MIT
// Manufactured solutions: motions of an elastic body of finite strain that are thought up, and the body force that makes Hencky's law
// take them. Units in which rho_0 = E = 1, with nu = 0.3.
#pragma once

#include <functional>

#include "experiments/common/study_scene.h"
#include "solver/boundary/shape.h"
#include "solver/run/simulation.h"

namespace bake::studies {

/// How far those particles are from position(X, t) that started, in `first`, at an X that `counts`: rms, in metres.
double place_error(const Snapshot& first, const Snapshot& now, double t, const std::function<bool(const Point&)>& counts,
                   Point (*position)(const Point& X, double t));
/// The same after running until `t`.
double place_error(Simulation& simulation, double t, const std::function<bool(const Point&)>& counts,
                   Point (*position)(const Point& X, double t));

namespace elastic {
inline constexpr double nu = 0.3, lambda = nu / ((1 + nu) * (1 - 2 * nu)), mu = 1 / (2 * (1 + nu));
inline constexpr const char* material = "young_modulus_Pa = 1\npoisson_ratio = 0.3\n";
}  // namespace elastic

/// Every axis is stretched for itself, by waves that stand in a cube of 1 m.
namespace axis_aligned {
Point position(const Point& X, double t);
Vector3 velocity(const Point& x, double t);    ///< of what is at x
Vector3 body_force(const Point& x, double t);  ///< for each unit of mass, on what is at x
}  // namespace axis_aligned

/// Rings about the z axis, of radius 0.75 to 1.25 m, turn against each other.
namespace vortex {
Point position(const Point& X, double t);
Vector3 velocity(const Point& x, double t);
Vector3 body_force(const Point& x, double t);
bool in_annulus(const Point& x);
inline constexpr double amplitude = 0.3;
inline constexpr double furthest_s = 0.5;  ///< then the rings have turned furthest and stand
/// One cell thick, with `cells` in a metre. With free rims; or `held`, in material that has the exact velocity beyond them.
StudyScene setting(double cells, bool held);
NodalForce force(bool held);
}  // namespace vortex

}  // namespace bake::studies

// SPDX-License-Identifier: MIT
// The body forces of the manufactured solutions against finite differences of the motion and of Hencky's law, which know nothing of the
// derivation: F, a and div P are differenced, tau is lambda tr(eps) + 2 mu eps with eps = 1/2 ln(F F^T) by eigenvalues.
#include "experiments/convergence/manufactured.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "solver/core/vector3.h"

namespace bake::studies {
namespace {

using Eigen::Matrix3d;

constexpr double k_inner = 1e-4, k_outer = 1e-3, k_time = 3e-4;  // steps of the differences [m], [m], [s]

struct Motion {
  Point (*position)(const Point& X, double t);
  Vector3 (*velocity)(const Point& x, double t);
  Vector3 (*body_force)(const Point& x, double t);
};
constexpr Motion k_axis_aligned{axis_aligned::position, axis_aligned::velocity, axis_aligned::body_force};
constexpr Motion k_vortex{vortex::position, vortex::velocity, vortex::body_force};

/// f'(0) to fourth order from f at -2, -1, 1, 2 steps.
template <class Function>
auto difference(Function f, double step) {
  return ((8 * (f(step) - f(-step)) - (f(2 * step) - f(-2 * step))) / (12 * step)).eval();
}

Eigen::Vector3d packed(const Vector3& v) { return {v[0], v[1], v[2]}; }
Point moved(Point X, int axis, double by) {
  X[static_cast<std::size_t>(axis)] += by;
  return X;
}

/// P = tau F^-T [E].
Matrix3d first_piola(const Motion& motion, const Point& X, double t) {
  Matrix3d F;
  for (int k = 0; k < 3; ++k) F.col(k) = difference([&](double by) { return packed(motion.position(moved(X, k, by), t)); }, k_inner);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> b(F * F.transpose());
  const Matrix3d strain = b.eigenvectors() * (0.5 * b.eigenvalues().array().log()).matrix().asDiagonal() * b.eigenvectors().transpose();
  const Matrix3d tau = elastic::lambda * strain.trace() * Matrix3d::Identity() + 2 * elastic::mu * strain;
  return tau * F.inverse().transpose();
}

void expect_balance(const Motion& motion, const Point& X, double t) {
  const auto at = [&](double later) { return packed(motion.position(X, t + later)); };
  const Eigen::Vector3d acceleration =
      difference([&](double a) { return difference([&](double b) { return at(a + b); }, k_time); }, k_time);
  Eigen::Vector3d div_P{0, 0, 0};
  for (int k = 0; k < 3; ++k)
    div_P += difference([&](double by) { return first_piola(motion, moved(X, k, by), t).col(k).eval(); }, k_outer);
  const Point x = motion.position(X, t);
  const Eigen::Vector3d force = acceleration - div_P;
  EXPECT_LT((packed(motion.body_force(x, t)) - force).norm(), 2e-5 * (1 + force.norm()))
      << "X " << packed(X).transpose() << " t " << t << ": " << packed(motion.body_force(x, t)).transpose() << " not " << force.transpose();
  EXPECT_LT((packed(motion.velocity(x, t)) - difference(at, k_time)).norm(), 1e-8);
}

TEST(ManufacturedWaves, AreWhatTheirBodyForceMakesOfHenckysLaw) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.02, 0.98);
  for (int i = 0; i < 200; ++i) {
    const double t = uniform(random) / 2 + 0.5 * (i % 2);  // the third derivative jumps at 1/2, where the waves have risen
    expect_balance(k_axis_aligned, {uniform(random), uniform(random), uniform(random)}, t);
  }
}

TEST(ManufacturedVortex, IsWhatItsBodyForceMakesOfHenckysLaw) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double R = 0.75 + 0.5 * uniform(random), Theta = 2 * M_PI * uniform(random);
    expect_balance(k_vortex, {R * std::cos(Theta), R * std::sin(Theta), uniform(random)}, uniform(random));
  }
}

}  // namespace
}  // namespace bake::studies

// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include "solver/effects/elasticity.h"
#include "tests/unit/engine/scene_of_everything.h"
#include "tests/unit/laws/law.h"

namespace bake {
namespace {

template <class Real>
class HenckysLaw : public Law<Real> {
 public:
  using L = Law<Real>;
  /// Of the logarithm and the exponential, relative to the norm: twenty Jacobi rotations.
  static constexpr double k_series = 50 * L::eps;

  static Elasticity::Constants<Real> constants() {
    static const Scene scene = scene_of_everything("yield_stress_Pa = 1\n");
    return {scene, scene.materials[0]};
  }
  /// Kirchhoff stress of an elastic strain b - I.
  static Symmetric<double> stress(const Symmetric<double>& b) {
    ParticleOfEverything<Real> p;
    const auto strain = half_log1p<Real>(L::all(b));
    for (int i = 0; i < 6; ++i) p[field::epsilon][i] = strain.at[i];
    Elasticity::stress(p, constants());
    Symmetric<double> tau;
    for (int i = 0; i < 6; ++i) tau.at[i] = L::first(p[field::tau][i]);
    return tau;
  }
};
TYPED_TEST_SUITE(HenckysLaw, Reals);

double norm(const Symmetric<double>& a) { return std::sqrt(norm_squared(a)); }
Symmetric<double> scaled(double factor, Symmetric<double> a) {
  for (double& x : a.at) x *= factor;
  return a;
}
Symmetric<double> exponential_less_one(const Symmetric<double>& h) {
  const auto b = expm1_twice<double>(Law<double>::all(h));
  Symmetric<double> result;
  for (int i = 0; i < 6; ++i) result.at[i] = b.at[i][0];
  return result;
}
Eigen::Matrix3d random_rotation() {
  const double x = between(-1, 1, "x"), y = between(-1, 1, "y"), z = between(-1, 1, "z"), angle = between(0, 3.2, "angle");
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(x, y, z + 2).normalized()).toRotationMatrix();
}
Symmetric<double> turned(const Eigen::Matrix3d& R, const Symmetric<double>& a) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = a.at[k_component[i][j]];
  m = R * m * R.transpose();
  Symmetric<double> result;
  for (int k = 0; k < 6; ++k) result.at[k] = m(k_row_of[k], k_column_of[k]);
  return result;
}
/// Strains of all sizes up to 0.4 a component: norms up to 1, stretches from e^-1 to e.
Symmetric<double> random_strain() { return scaled(decades(-6, 0, "size"), random_symmetric(0.4, "h")); }

// 1/(1 + b), by which the logarithm amplifies the rounding of b, is at most e^2.
constexpr double k_amplified = 8;

TYPED_TEST(HenckysLaw, LogarithmAndExponentialUndoEachOther) {
  EXPECT_TRUE(rc::check([] {
    const Symmetric<double> h = random_strain();
    const auto start = TestFixture::all(h);
    const auto b = expm1_twice<TypeParam>(start);
    const auto again = half_log1p<TypeParam>(b);
    const auto b_again = expm1_twice<TypeParam>(again);
    const double bound = k_amplified * TestFixture::k_series * norm(h);
    for (int i = 0; i < 6; ++i) {
      expect_near(TestFixture::first(again.at[i]), TestFixture::first(start.at[i]), bound);
      expect_near(TestFixture::first(b_again.at[i]), TestFixture::first(b.at[i]), 2 * k_amplified * bound);  // d exp(2h) = 2 exp(2h) dh
    }
  }));
}

TYPED_TEST(HenckysLaw, StressIsLinearInTheLogarithm) {
  EXPECT_TRUE(rc::check([] {
    const Symmetric<double> h = random_strain();
    const auto tau = TestFixture::stress(exponential_less_one(h));
    const auto k = TestFixture::constants();
    const double lambda = static_cast<double>(k.lambda), mu = static_cast<double>(k.mu), tr = h.at[0] + h.at[1] + h.at[2];
    for (int i = 0; i < 6; ++i)
      expect_near(tau.at[i], 2 * mu * h.at[i] + (i < 3 ? lambda * tr : 0),
                  (3 * lambda + 2 * mu) * k_amplified * TestFixture::k_series * norm(h));
  }));
}

TYPED_TEST(HenckysLaw, StressTurnsWithTheStrain) {
  EXPECT_TRUE(rc::check([] {
    const Symmetric<double> h = random_strain();
    const Eigen::Matrix3d R = random_rotation();
    const auto of_turned = TestFixture::stress(exponential_less_one(turned(R, h)));
    const auto turned_stress = turned(R, TestFixture::stress(exponential_less_one(h)));
    const auto k = TestFixture::constants();
    const double bound = 2 * static_cast<double>(3 * k.lambda + 2 * k.mu) * k_amplified * TestFixture::k_series * norm(h);
    for (int i = 0; i < 6; ++i) expect_near(of_turned.at[i], turned_stress.at[i], bound);
  }));
}

}  // namespace
}  // namespace bake

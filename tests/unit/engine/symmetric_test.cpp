// SPDX-License-Identifier: MIT
#include "solver/core/symmetric.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace bake {
namespace {

using Matrix = Eigen::Matrix<long double, 3, 3>;

Matrix random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Quaternion<long double> q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

/// A symmetric matrix of Frobenius norm `size` with all eigenvalues above `lowest`.
Matrix random_symmetric(std::mt19937_64& random, double size, double lowest) {
  std::normal_distribution<double> normal;
  for (;;) {
    Eigen::Matrix<long double, 3, 1> value(normal(random), normal(random), normal(random));
    value *= size / value.norm();
    if (value.minCoeff() < lowest) continue;
    const Matrix u = random_rotation(random);
    return u * value.asDiagonal() * u.transpose();
  }
}

template <class Function>
Matrix by_eigenvalues(const Matrix& a, Function f) {
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(a);
  Eigen::Matrix<long double, 3, 1> value = eigen.eigenvalues();
  for (int i = 0; i < 3; ++i) value[i] = f(value[i]);
  return eigen.eigenvectors() * value.asDiagonal() * eigen.eigenvectors().transpose();
}

template <class Real>
void put(const Matrix& a, int lane, Symmetric<Lanes<Real>>& to) {
  for (int k = 0; k < 6; ++k) to.at[k][lane] = static_cast<Real>(a(k_row_of[k], k_column_of[k]));
}
template <class Real>
Matrix get(const Symmetric<Lanes<Real>>& from, int lane) {
  Matrix a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a(i, j) = static_cast<long double>(from.at[k_component[i][j]][lane]);
  return a;
}

template <class Real>
class SymmetricMatrices : public testing::Test {
 public:
  /// Largest |f(a) - exact(a)| / |exact(a)| over random matrices of norm `size`; the exact function sees the rounded matrix.
  template <class Function, class Exact>
  static double worst_error(double size, double lowest, Function f, Exact exact) {
    std::mt19937_64 random(static_cast<std::uint64_t>(size * 1e9));
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
      Symmetric<Lanes<Real>> a;
      for (int l = 0; l < k_width<Real>; ++l) put<Real>(random_symmetric(random, size, lowest), l, a);
      const auto result = f(a);
      for (int l = 0; l < k_width<Real>; ++l) {
        const Matrix right = by_eigenvalues(get<Real>(a, l), exact);
        worst = std::max(worst, static_cast<double>((get<Real>(result, l) - right).norm() / right.norm()));
      }
    }
    return worst;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SymmetricMatrices, Reals);

// What the kernel study measured for the series, 3e-7 and 2e-15, doubled for the tails of more samples. Jacobi lanes (norms
// beyond 0.42 and 0.16) pass through some twenty rotations: ten times more. Eigenvalues near -1 amplify the input's own
// rounding by 1/(1 + x), at most 5 here.
template <class Real>
constexpr double k_series = sizeof(Real) == 4 ? 6e-7 : 4e-15;
template <class Real>
constexpr double k_jacobi = 10 * k_series<Real>;

template <class Real>
double bound(double size, double series_up_to) {
  return size < series_up_to ? k_series<Real> : k_jacobi<Real>;
}

TYPED_TEST(SymmetricMatrices, HenckyStrainIsHalfTheLogarithm) {
  for (const double size : {1e-6, 1e-4, 1e-2, 0.1, 0.15, 0.17, 0.3, 0.4, 0.44, 1.0, 2.0}) {
    const double error = TestFixture::worst_error(
        size, -0.8, [](const auto& b) { return half_log1p<TypeParam>(b); }, [](long double x) { return std::log1p(x) / 2; });
    EXPECT_LE(error, bound<TypeParam>(size, sizeof(TypeParam) == 4 ? 0.42 : 0.16)) << "norm " << size;
  }
}

TYPED_TEST(SymmetricMatrices, ElasticStretchIsTheExponentialOfTwiceTheStrain) {
  for (const double size : {1e-6, 1e-4, 1e-2, 0.1, 0.14, 0.16, 0.34, 0.36, 1.0, 2.0}) {
    const double error = TestFixture::worst_error(
        size, -10, [](const auto& h) { return expm1_twice<TypeParam>(h); }, [](long double x) { return std::expm1(2 * x); });
    EXPECT_LE(error, bound<TypeParam>(2 * size, sizeof(TypeParam) == 4 ? 0.7 : 0.3)) << "norm " << size;
  }
}

TYPED_TEST(SymmetricMatrices, ALaneDoesNotDependOnItsNeighbours) {
  std::mt19937_64 random(5);
  for (const double size : {0.1, 1.0}) {
    const Matrix mine = random_symmetric(random, size, -0.8);
    for (int lane = 0; lane < k_width<TypeParam>; ++lane) {
      Symmetric<Lanes<TypeParam>> alone{}, among{};
      put<TypeParam>(mine, lane, alone);
      for (int l = 0; l < k_width<TypeParam>; ++l)
        put<TypeParam>(l == lane ? mine : random_symmetric(random, l % 2 ? 1.5 : 1e-3, -0.8), l, among);
      const auto log_alone = half_log1p<TypeParam>(alone), log_among = half_log1p<TypeParam>(among);
      const auto exp_alone = expm1_twice<TypeParam>(alone), exp_among = expm1_twice<TypeParam>(among);
      for (int k = 0; k < 6; ++k) {
        EXPECT_EQ(log_alone.at[k][lane], log_among.at[k][lane]);
        EXPECT_EQ(exp_alone.at[k][lane], exp_among.at[k][lane]);
      }
    }
  }
}

TYPED_TEST(SymmetricMatrices, AMatrixThatIsAlreadyDiagonalOrEqualInAllDirectionsIsNoSpecialCase) {
  for (const double x : {0.0, 1e-3, 0.5, 3.0}) {
    Symmetric<Lanes<TypeParam>> b{};
    for (int k = 0; k < 3; ++k) b.at[k] = lanes<TypeParam>(static_cast<TypeParam>(x));
    const auto log = half_log1p<TypeParam>(b);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(log.at[k][0], k < 3 ? std::log1p(x) / 2 : 0, k_jacobi<TypeParam> * x) << x;
  }
}

}  // namespace
}  // namespace bake

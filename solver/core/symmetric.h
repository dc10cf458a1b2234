// SPDX-License-Identifier: MIT
// Symmetric 3x3 matrices on lanes, with the logarithm and exponential that Hencky's strain needs.
//
// Pressure and shear need only the trace and the deviator of log b, so no eigen-decomposition is needed: log(I + b) and
// exp(h) - I are short polynomials in the matrix, reduced by Cayley-Hamilton (three multiply-adds a degree). Lanes
// whose matrix is too large for the series take a Jacobi decomposition; the choice is made lane by lane, so that a
// particle's result never depends on its neighbours in the register.
#pragma once

#include "solver/core/lanes.h"

namespace bake {

/// Components in the order xx, yy, zz, yz, xz, xy.
template <class V>
struct Symmetric {
  V at[6];
};

inline constexpr int k_row_of[6] = {0, 1, 2, 1, 0, 0};
inline constexpr int k_column_of[6] = {0, 1, 2, 2, 2, 1};
/// The index at which component (i, j) is stored.
inline constexpr int k_component[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

template <class V>
BAKE_INLINE V trace(const Symmetric<V>& a) {
  return a.at[0] + a.at[1] + a.at[2];
}
template <class V>
BAKE_INLINE V norm_squared(const Symmetric<V>& a) {
  return a.at[0] * a.at[0] + a.at[1] * a.at[1] + a.at[2] * a.at[2] + 2 * (a.at[3] * a.at[3] + a.at[4] * a.at[4] + a.at[5] * a.at[5]);
}
template <class V>
BAKE_INLINE Symmetric<V> square(const Symmetric<V>& s) {
  const V* a = s.at;
  return {{a[0] * a[0] + a[5] * a[5] + a[4] * a[4], a[5] * a[5] + a[1] * a[1] + a[3] * a[3], a[4] * a[4] + a[3] * a[3] + a[2] * a[2],
           a[5] * a[4] + a[1] * a[3] + a[3] * a[2], a[0] * a[4] + a[5] * a[3] + a[4] * a[2], a[0] * a[5] + a[5] * a[1] + a[4] * a[3]}};
}

namespace detail {

/// Eigenvalues and eigenvectors (columns of `u`) by cyclic Jacobi rotations.
template <class Real>
__attribute__((noinline)) void jacobi(const Symmetric<Lanes<Real>>& s, Lanes<Real> (&value)[3], Lanes<Real> (&u)[3][3]) {
  using V = Lanes<Real>;
  V a[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      a[i][j] = s.at[k_component[i][j]];
      u[i][j] = lanes<Real>(i == j);
    }
  constexpr int k_sweeps = sizeof(Real) == 4 ? 5 : 7;
  constexpr int first[3] = {0, 0, 1}, second[3] = {1, 2, 2}, other[3] = {2, 1, 0};
  for (int sweep = 0; sweep < k_sweeps; ++sweep)
    for (int r = 0; r < 3; ++r) {
      const int p = first[r], q = second[r], o = other[r];
      const V gap = a[q][q] - a[p][p], off = a[p][q];
      const V denominator = abs(gap) + sqrt(gap * gap + 4 * off * off) + lanes<Real>(Real(1e-30));
      V t = 2 * off / denominator;
      t = gap < lanes<Real>(0) ? -t : t;
      const V c = 1 / sqrt(1 + t * t), sine = t * c;
      a[p][p] -= t * off;
      a[q][q] += t * off;
      a[p][q] = a[q][p] = lanes<Real>(0);
      const V ap = a[p][o], aq = a[q][o];
      a[p][o] = a[o][p] = c * ap - sine * aq;
      a[q][o] = a[o][q] = sine * ap + c * aq;
      for (int k = 0; k < 3; ++k) {
        const V up = u[k][p];
        u[k][p] = c * up - sine * u[k][q];
        u[k][q] = sine * up + c * u[k][q];
      }
    }
  for (int i = 0; i < 3; ++i) value[i] = a[i][i];
}

template <class Real, class Function>
Symmetric<Lanes<Real>> by_eigenvalues(const Symmetric<Lanes<Real>>& a, Function f) {
  using V = Lanes<Real>;
  V value[3], u[3][3];
  jacobi<Real>(a, value, u);
  for (V& x : value) x = f(x);
  Symmetric<V> result;
  for (int k = 0; k < 6; ++k) {
    const int i = k_row_of[k], j = k_column_of[k];
    result.at[k] = u[i][0] * u[j][0] * value[0] + u[i][1] * u[j][1] * value[1] + u[i][2] * u[j][2] * value[2];
  }
  return result;
}

/// sum_{k=1}^{N} c[k-1] a^k by Horner on (I, a, a^2), reduced by Cayley-Hamilton.
template <class Real, int N>
BAKE_INLINE Symmetric<Lanes<Real>> polynomial(const Symmetric<Lanes<Real>>& a, const Real (&c)[N]) {
  using V = Lanes<Real>;
  const V* m = a.at;
  const Symmetric<V> a2 = square(a);
  const V i1 = m[0] + m[1] + m[2];
  const V i2 = m[0] * m[1] - m[5] * m[5] + m[0] * m[2] - m[4] * m[4] + m[1] * m[2] - m[3] * m[3];
  const V i3 = m[0] * (m[1] * m[2] - m[3] * m[3]) - m[5] * (m[5] * m[2] - m[3] * m[4]) + m[4] * (m[5] * m[3] - m[1] * m[4]);
  V alpha = lanes<Real>(c[N - 1]), beta = lanes<Real>(0), gamma = lanes<Real>(0);
#pragma GCC unroll 32
  for (int k = N - 2; k >= 0; --k) {
    const V g = gamma;
    gamma = beta + g * i1;
    beta = alpha - g * i2;
    alpha = g * i3 + c[k];
  }
  const V h0 = gamma * i3, h1 = alpha - gamma * i2, h2 = beta + gamma * i1;
  Symmetric<V> result;
  for (int k = 0; k < 6; ++k) result.at[k] = h1 * m[k] + h2 * a2.at[k];
  for (int k = 0; k < 3; ++k) result.at[k] += h0;
  return result;
}

/// Series of 1/2 log(1 + x) and of exp(x) - 1 (coefficients of x, x^2, ...), and the Frobenius norm up to which
/// they hold to round-off: Chebyshev fits of f(x)/x, relative error 6e-8 and 5e-8 in single, 6e-18 and 1e-17 in double.
template <class Real>
struct Series;
template <>
struct Series<float> {
  static constexpr float half_log[10] = {5.000000226e-01f,  -2.500000208e-01f, 1.666602826e-01f,  -1.249941179e-01f, 1.002849470e-01f,
                                         -8.359582789e-02f, 6.706237816e-02f,  -5.847953537e-02f, 8.169394441e-02f,  -7.404558084e-02f};
  static constexpr float expm1[7] = {1.000000000e+00f, 5.000003222e-01f, 1.666667024e-01f, 4.166140986e-02f,
                                     8.332750182e-03f, 1.410301579e-03f, 2.007889419e-04f};
  static constexpr float log_norm = 0.42f, exp_norm = 0.7f;
};
template <>
struct Series<double> {
  static constexpr double half_log[15] = {5.0000000000000000e-01, -2.5000000000000022e-01, 1.6666666666666688e-01, -1.2499999999967251e-01,
                                          9.9999999999691599e-02, -8.3333333471285895e-02, 7.1428571558480869e-02, -6.2499974407729045e-02,
                                          5.5555531455820768e-02, -5.0002432655833859e-02, 4.5456836171106192e-02, -4.1543269464655523e-02,
                                          3.8345347251820906e-02, -3.8874339190083346e-02, 3.6308525670520460e-02};
  static constexpr double expm1[11] = {1.0000000000000000e+00, 5.0000000000000011e-01, 1.6666666666666669e-01, 4.1666666666637202e-02,
                                       8.3333333333310677e-03, 1.3888888907222733e-03, 1.9841269855370408e-04, 2.4801540745401102e-05,
                                       2.7557283416994899e-06, 2.7609033935894174e-07, 2.5091884342633377e-08};
  static constexpr double log_norm = 0.16, exp_norm = 0.3;
};

template <class V>
BAKE_INLINE Symmetric<V> select(auto mask, const Symmetric<V>& a, const Symmetric<V>& b) {
  Symmetric<V> result;
  for (int k = 0; k < 6; ++k) result.at[k] = mask ? a.at[k] : b.at[k];
  return result;
}

}  // namespace detail

/// Hencky strain 1/2 log(I + b). Eigenvalues of b are held above -0.9975 (a stretch of 0.05).
template <class Real>
BAKE_INLINE Symmetric<Lanes<Real>> half_log1p(const Symmetric<Lanes<Real>>& b) {
  using S = detail::Series<Real>;
  auto result = detail::polynomial<Real>(b, S::half_log);
  const auto large = norm_squared(b) > lanes<Real>(S::log_norm * S::log_norm);
  if (__builtin_expect(any(large), 0)) {
    const auto exact = detail::by_eigenvalues<Real>(b, [](auto x) { return Real(0.5) * log1p(max(x, lanes<Real>(Real(-0.9975)))); });
    result = detail::select(large, exact, result);
  }
  return result;
}

/// exp(2 h) - I: the elastic left Cauchy-Green strain less the identity.
template <class Real>
BAKE_INLINE Symmetric<Lanes<Real>> expm1_twice(const Symmetric<Lanes<Real>>& h) {
  using S = detail::Series<Real>;
  Symmetric<Lanes<Real>> twice;
  for (int k = 0; k < 6; ++k) twice.at[k] = 2 * h.at[k];
  auto result = detail::polynomial<Real>(twice, S::expm1);
  const auto large = norm_squared(twice) > lanes<Real>(S::exp_norm * S::exp_norm);
  if (__builtin_expect(any(large), 0)) {
    const auto exact = detail::by_eigenvalues<Real>(twice, [](auto x) { return expm1(x); });
    result = detail::select(large, exact, result);
  }
  return result;
}

}  // namespace bake

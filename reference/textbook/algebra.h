// SPDX-License-Identifier: MIT
// Vectors and 3x3 matrices, written out.
#pragma once

#include <cmath>

namespace bake::textbook {

struct Vector {
  double at[3] = {0, 0, 0};
  double& operator[](int i) { return at[i]; }
  double operator[](int i) const { return at[i]; }
};

inline Vector operator+(const Vector& a, const Vector& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
inline Vector operator*(double s, const Vector& a) { return {{s * a[0], s * a[1], s * a[2]}}; }
inline Vector& operator+=(Vector& a, const Vector& b) { return a = a + b; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

struct Matrix {
  double at[3][3] = {};
  double& operator()(int i, int j) { return at[i][j]; }
  double operator()(int i, int j) const { return at[i][j]; }
};

inline Matrix diagonal(double a, double b, double c) { return {{{a, 0, 0}, {0, b, 0}, {0, 0, c}}}; }
inline Matrix identity() { return diagonal(1, 1, 1); }
inline double trace(const Matrix& a) { return a(0, 0) + a(1, 1) + a(2, 2); }

inline Matrix operator+(const Matrix& a, const Matrix& b) {
  Matrix sum;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum(i, j) = a(i, j) + b(i, j);
  return sum;
}
inline Matrix operator*(double s, const Matrix& a) {
  Matrix scaled;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) scaled(i, j) = s * a(i, j);
  return scaled;
}
inline Matrix& operator+=(Matrix& a, const Matrix& b) { return a = a + b; }
inline Matrix operator-(const Matrix& a, const Matrix& b) { return a + (-1) * b; }

inline Vector operator*(const Matrix& a, const Vector& v) {
  Vector product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product[i] += a(i, j) * v[j];
  return product;
}
inline Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) product(i, j) += a(i, k) * b(k, j);
  return product;
}
inline Matrix transposed(const Matrix& a) {
  Matrix t;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t(i, j) = a(j, i);
  return t;
}
/// a (x) b
inline Matrix outer(const Vector& a, const Vector& b) {
  Matrix product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product(i, j) = a[i] * b[j];
  return product;
}
inline double determinant(const Matrix& a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}
inline double frobenius_squared(const Matrix& a) { return trace(a * transposed(a)); }

/// The symmetric matrix with the eigenvectors of `a` and the eigenvalues f(lambda). Jacobi: each rotation takes one
/// off-diagonal pair to zero; ten sweeps leave nothing that a double could hold.
template <class Function>
Matrix of_eigenvalues(Matrix a, Function f) {
  Matrix vectors = identity();
  for (int sweep = 0; sweep < 10; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (a(p, q) == 0) continue;
        const double angle = 0.5 * std::atan2(2 * a(p, q), a(q, q) - a(p, p));
        Matrix turn = identity();
        turn(p, p) = turn(q, q) = std::cos(angle);
        turn(p, q) = std::sin(angle);
        turn(q, p) = -turn(p, q);
        a = transposed(turn) * a * turn;
        a(p, q) = a(q, p) = 0;
        vectors = vectors * turn;
      }
  return vectors * diagonal(f(a(0, 0)), f(a(1, 1)), f(a(2, 2))) * transposed(vectors);
}

}  // namespace bake::textbook

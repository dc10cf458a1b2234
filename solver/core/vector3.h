// SPDX-License-Identifier: MIT
// Vectors of three numbers, for geometry that is evaluated point by point.
#pragma once

#include <array>
#include <cmath>

namespace bake {

using Vector3 = std::array<double, 3>;

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
constexpr Vector3 operator-(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }
constexpr Vector3 operator*(double factor, const Vector3& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

constexpr double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector3& a) { return std::sqrt(dot(a, a)); }

/// a / |a|; the z axis if `a` has no direction.
inline Vector3 unit(const Vector3& a) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : Vector3{0, 0, 1};
}

}  // namespace bake

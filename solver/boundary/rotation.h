// SPDX-License-Identifier: MIT
// Rotations: rotation vectors (axis times angle), unit quaternions, matrices.
#pragma once

#include <numbers>

#include "solver/boundary/shape.h"
#include "solver/core/elementary.h"
#include "solver/core/vector3.h"

namespace bake {

using Rotation = std::array<Vector3, 3>;  ///< rows of an orthogonal matrix
inline constexpr Rotation k_no_rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
inline constexpr double k_rad_per_deg = std::numbers::pi / 180;

constexpr Vector3 operator*(const Rotation& r, const Vector3& a) { return {dot(r[0], a), dot(r[1], a), dot(r[2], a)}; }
/// R^T a: the inverse rotation.
constexpr Vector3 turn_back(const Rotation& r, const Vector3& a) { return a[0] * r[0] + a[1] * r[1] + a[2] * r[2]; }

struct Quaternion {
  double w = 1;
  Vector3 v = {0, 0, 0};
};

/// The rotation b followed by a.
constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
constexpr Quaternion inverse(const Quaternion& q) { return {q.w, -q.v}; }

/// The rotation by |a| [rad] about a.
inline Quaternion quaternion(const Vector3& rotation_rad) {
  const double angle = length(rotation_rad);
  return {elementary::cosine(angle / 2), elementary::sine(angle / 2) * unit(rotation_rad)};
}

/// Rotation vector of at most half a turn [rad].
inline Vector3 rotation_vector(const Quaternion& q) {
  const double sine = length(q.v);
  const double half = elementary::angle(sine, std::abs(q.w));
  return (q.w < 0 ? -2 : 2) * half * unit(q.v);
}

constexpr Rotation matrix(const Quaternion& q) {
  const auto& [x, y, z] = q.v;
  const double w = q.w;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// Smallest box with faces along the axes around a turned box, which may be infinite.
constexpr Box3 turned(const Rotation& r, const Box3& box) {
  Box3 result{{0, 0, 0}, {0, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (r[i][j] == 0) continue;  // 0 times infinity
      const double a = r[i][j] * box.low[j], b = r[i][j] * box.high[j];
      result.low[i] += a < b ? a : b;
      result.high[i] += a < b ? b : a;
    }
  }
  return result;
}

}  // namespace bake

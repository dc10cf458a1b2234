// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/surface_foot.h"

#include <Eigen/Dense>
#include <cmath>

#include "solver/core/vector3.h"

namespace bake {
namespace {

Eigen::Vector3d eigen(const Vector3& a) { return {a[0], a[1], a[2]}; }
Vector3 vector3(const Eigen::Vector3d& a) { return {a[0], a[1], a[2]}; }

/// Six along the axes and eight along the diagonals, turned so that none lies along a face of what people draw.
const std::array<Vector3, 14>& probe_directions() {
  static const std::array<Vector3, 14> directions = [] {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Eigen::Vector3d(3, 1, 2).normalized()).toRotationMatrix();
    std::array<Vector3, 14> list;
    int n = 0;
    for (int i = 0; i < 3; ++i)
      for (const double sign : {-1.0, 1.0}) list[n++] = vector3(sign * turn.col(i));
    for (int i = 0; i < 8; ++i) list[n++] = vector3(turn * Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).normalized());
    return list;
  }();
  return directions;
}

/// Sums over the tangent planes n . (z - x) = h seen from x: A = mean of n n^T, b = mean of n h.
struct Planes {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

Planes planes_around(const Shape& solid, const Point& x, double radius) {
  Planes planes;
  int count = 0;
  for (const Vector3& direction : probe_directions()) {
    const Point probe = x + radius * direction;
    const double distance = solid.distance(probe);
    const Vector3 normal = solid.normal(probe);
    const Point foot = probe - distance * normal;
    if (std::abs(solid.distance(foot)) > 0.1 * radius) continue;  // a face that ends before
    planes.a += eigen(normal) * eigen(normal).transpose();
    planes.b += eigen(normal) * dot(normal, foot - x);
    ++count;
  }
  if (count > 0) planes.a /= count, planes.b /= count;
  return planes;
}

}  // namespace

std::optional<Point> foot_on_surface(const Shape& solid, const Point& x, double tolerance_m, double reach_m) {
  constexpr int k_most_steps = 40;
  Point foot = x;
  double distance = solid.distance(foot);
  for (int step = 0; step < k_most_steps && std::abs(distance) > tolerance_m; ++step) {
    const Vector3 move = -distance * solid.normal(foot);
    Point next = foot + move;
    double left = solid.distance(next);
    // a first-order distance may overshoot
    for (double share = 0.5; share > 0.1 && std::abs(left) > std::abs(distance); share *= 0.5) {
      next = foot + share * move;
      left = solid.distance(next);
    }
    foot = next;
    distance = left;
  }
  if (!(std::abs(distance) <= tolerance_m) || length(foot - x) > reach_m) return std::nullopt;
  return foot;
}

Sharpest sharpest_near(const Shape& solid, const Point& x, double reach_m) {
  // Normals that part by the angle phi, half of them on either side, have the second eigenvalue sin(phi / 2)^2: 20 degrees in the end.
  constexpr double k_seen = 0.01, k_sure = 0.03;
  Point at = x;
  int faces = 1;
  for (const double share : {1.0, 0.5, 0.2, 0.04, 0.04}) {
    const double radius = share * reach_m;
    const Planes planes = planes_around(solid, at, radius);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(planes.a);
    const bool last = share < 0.1;
    faces = 0;
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    for (int i = 2; i >= 0 && parts.eigenvalues()[i] > (last ? k_sure : k_seen); --i) {
      ++faces;
      step += parts.eigenvectors().col(i) * (parts.eigenvectors().col(i).dot(planes.b) / parts.eigenvalues()[i]);
    }
    if (faces < 2) return {x, 1};
    if (step.norm() > 1.5 * radius) step *= 1.5 * radius / step.norm();
    at = at + vector3(step);
    if (length(at - x) > 2 * reach_m) return {x, 1};
  }
  if (std::abs(solid.distance(at)) > 1e-3 * reach_m) return {x, 1};
  return {at, faces};
}

}  // namespace bake

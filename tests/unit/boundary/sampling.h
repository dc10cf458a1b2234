// SPDX-License-Identifier: MIT
// Random points and sample shapes for the tests of the boundary room.
#pragma once

#include <functional>
#include <random>
#include <string>

#include "solver/boundary/shapes.h"
#include "solver/core/vector3.h"

namespace bake {

/// Points spread evenly over a box.
class RandomPoints {
 public:
  RandomPoints(const Point& low, const Point& high) : low_(low), high_(high) {}
  Point operator()() {
    Point x;
    for (int i = 0; i < 3; ++i) x[i] = low_[i] + (high_[i] - low_[i]) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    return x;
  }

 private:
  Point low_, high_;
  std::mt19937_64 engine_{12345};
};

template <class Solid>
ShapePtr make(const std::function<void(Solid&)>& set) {
  auto shape = std::make_shared<Solid>();
  set(*shape);
  return shape;
}

inline ShapePtr make_sphere(const Point& centre, double radius) {
  return make<Sphere>([&](Sphere& s) { s.centre_m = centre, s.radius_m = radius; });
}
inline ShapePtr make_box(const Point& centre, const Vector3& half) {
  return make<Box>([&](Box& s) { s.centre_m = centre, s.half_extents_m = half; });
}
inline ShapePtr make_half_space(const Point& point, const Vector3& normal) {
  return make<HalfSpace>([&](HalfSpace& s) { s.point_m = point, s.outward_normal = normal; });
}
inline ShapePtr make_ellipsoid(const Point& centre, const Vector3& half) {
  return make<Ellipsoid>([&](Ellipsoid& s) { s.centre_m = centre, s.half_axes_m = half; });
}
inline ShapePtr make_superellipsoid(const Vector3& half, double plan, double profile) {
  return make<Superellipsoid>([&](Superellipsoid& s) { s.half_axes_m = half, s.plan_exponent = plan, s.profile_exponent = profile; });
}
inline ShapePtr make_cylinder(const Point& from, const Point& to, double radius) {
  return make<Cylinder>([&](Cylinder& s) { s.from_m = from, s.to_m = to, s.radius_m = radius; });
}
inline ShapePtr make_cone(const Point& from, const Point& to, double from_radius, double to_radius) {
  return make<Cone>([&](Cone& s) { s.from_m = from, s.to_m = to, s.from_radius_m = from_radius, s.to_radius_m = to_radius; });
}

/// Whether x is in the box, or no farther from it than the tolerance along an axis.
inline bool holds(const Box3& box, const Point& x, double tolerance = 0) {
  for (int axis = 0; axis < 3; ++axis)
    if (x[axis] < box.low[axis] - tolerance || x[axis] > box.high[axis] + tolerance) return false;
  return true;
}

struct Sample {
  std::string name;
  ShapePtr shape;
  Point inside, outside;
  double volume;  ///< closed form [m^3]
};

/// Finite shapes with an exact distance, all within about 0.2 m of the origin.
std::vector<Sample> exact_shapes();

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/boundary/shapes.h"

#include <algorithm>
#include <numbers>

#include "solver/core/elementary.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

constexpr double k_pi = std::numbers::pi;

Box3 box_around(const Point& centre, const Vector3& half) { return {centre - half, centre + half}; }

/// a with the signs of b.
Vector3 with_signs(const Vector3& a, const Vector3& b) {
  return {std::copysign(a[0], b[0]), std::copysign(a[1], b[1]), std::copysign(a[2], b[2])};
}

Vector3 magnitudes(const Vector3& a) { return {std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}; }

/// Any unit vector at right angles to the unit vector a.
Vector3 perpendicular(const Vector3& a) { return unit(cross(a, std::abs(a[0]) < 0.5 ? Vector3{1, 0, 0} : Vector3{0, 1, 0})); }

int index_of_largest(const Vector3& a) { return static_cast<int>(std::max_element(a.begin(), a.end()) - a.begin()); }
int index_of_smallest(const Vector3& a) { return static_cast<int>(std::min_element(a.begin(), a.end()) - a.begin()); }

// --- boxes: y is relative to the centre

Vector3 beyond(const Vector3& excess) { return {std::max(excess[0], 0.0), std::max(excess[1], 0.0), std::max(excess[2], 0.0)}; }

double box_distance(const Vector3& y, const Vector3& half) {
  const Vector3 excess = magnitudes(y) - half;
  return length(beyond(excess)) + std::min(*std::max_element(excess.begin(), excess.end()), 0.0);
}

double box_volume(const Vector3& half) { return 8 * half[0] * half[1] * half[2]; }

Vector3 box_normal(const Vector3& y, const Vector3& half) {
  const Vector3 excess = magnitudes(y) - half;
  const int face = index_of_largest(excess);
  Vector3 outwards = {0, 0, 0};
  if (excess[face] > 0) {
    outwards = beyond(excess);
  } else {
    outwards[face] = 1;
  }
  return unit(with_signs(outwards, y));
}

// --- ellipsoid

/// The point of an ellipsoid's surface nearest to y, for y >= 0: foot_i = e_i^2 y_i / (t + gap_i) with
/// gap_i = e_i^2 - (shortest e)^2 and the largest t that puts it on the surface.
/// [Eberly, "Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid"]
Vector3 ellipsoid_foot(Vector3 y, const Vector3& e) {
  const int shortest = index_of_smallest(e);
  Vector3 gap;
  double t = 0;
  for (int i = 0; i < 3; ++i) {
    // Next to a symmetry plane Newton's method creeps, on it there is nothing to solve. The error is of this size.
    if (y[i] < 1e-12 * e[shortest]) y[i] = 0;
    gap[i] = (e[i] - e[shortest]) * (e[i] + e[shortest]);
    t = std::max(t, e[i] * y[i] - gap[i]);
  }
  Vector3 foot = {0, 0, 0};
  // Newton on 1 / sqrt(level) = 1, concave in t: monotone from the left, where level > 1.
  for (int iteration = 0; iteration < 120; ++iteration) {
    double level = 0, slope = 0;
    for (int i = 0; i < 3; ++i) {
      if (y[i] == 0) continue;
      foot[i] = y[i] * (e[i] * e[i] / (t + gap[i]));
      const double term = (foot[i] / e[i]) * (foot[i] / e[i]);
      level += term;
      slope += term / (t + gap[i]);
    }
    if (level < 1 && t == 0) foot[shortest] = e[shortest] * std::sqrt(1 - level);  // either side of the symmetry plane
    const double step = level > 1 ? level * (std::sqrt(level) - 1) / slope : 0;
    if (step <= 1e-14 * t) break;
    t += step;
  }
  return foot;
}

double ellipsoid_volume(const Vector3& e) { return 4 * k_pi / 3 * e[0] * e[1] * e[2]; }

// --- round bodies about an axis: a trapezoid in the plane of height along the axis and radius

struct Frustum {
  Point from;
  Vector3 axis;  ///< unit
  double height, from_radius, to_radius;
};

/// A point or direction in that plane: {along the axis, away from the axis, 0}.
using Profile = Vector3;

/// The face nearest to a point of the plane.
struct Nearest {
  Profile from_foot;  ///< from its nearest point to the point in question
  Profile normal;     ///< outwards, of any length
  bool inside;
};

Frustum frustum(const Point& from, const Point& to, double from_radius, double to_radius) {
  const double height = length(to - from);
  return {from, (1 / height) * (to - from), height, from_radius, to_radius};
}

Profile profile_of(const Frustum& f, const Point& x) {
  const double along = dot(x - f.from, f.axis);
  return {along, length(x - f.from - along * f.axis), 0};
}

Nearest nearest_face(const Frustum& f, const Profile& p) {
  const Profile from_edge = p - Profile{0, f.from_radius, 0};
  const Profile side = {f.height, f.to_radius - f.from_radius, 0};
  const Profile side_normal = {-side[1], side[0], 0};
  const bool inside = p[0] > 0 && p[0] < f.height && dot(from_edge, side_normal) < 0;

  const double share = std::clamp(dot(from_edge, side) / dot(side, side), 0.0, 1.0);
  Nearest nearest{from_edge - share * side, side_normal, inside};
  const auto keep_nearer = [&nearest](const Profile& from_foot, const Profile& normal) {
    if (dot(from_foot, from_foot) < dot(nearest.from_foot, nearest.from_foot)) nearest.from_foot = from_foot, nearest.normal = normal;
  };
  keep_nearer({p[0], std::max(p[1] - f.from_radius, 0.0), 0}, {-1, 0, 0});
  keep_nearer({p[0] - f.height, std::max(p[1] - f.to_radius, 0.0), 0}, {1, 0, 0});
  return nearest;
}

double frustum_distance(const Frustum& f, const Point& x) {
  const Nearest nearest = nearest_face(f, profile_of(f, x));
  return nearest.inside ? -length(nearest.from_foot) : length(nearest.from_foot);
}

Vector3 frustum_normal(const Frustum& f, const Point& x) {
  const Profile p = profile_of(f, x);
  const Nearest nearest = nearest_face(f, p);
  // Outside an edge the gradient points away from the edge; on the surface only the face has a direction.
  const bool beyond_edge = !nearest.inside && length(nearest.from_foot) > 1e-12 * f.height;
  const Profile gradient = unit(beyond_edge ? nearest.from_foot : nearest.normal);
  const Vector3 away = p[1] > 0 ? (1 / p[1]) * (x - f.from - p[0] * f.axis) : perpendicular(f.axis);
  return unit(gradient[0] * f.axis + gradient[1] * away);
}

Box3 frustum_bounds(const Frustum& f) {
  const Point to = f.from + f.height * f.axis;
  Box3 box;
  for (int i = 0; i < 3; ++i) {
    const double lean = std::sqrt(std::max(0.0, 1 - f.axis[i] * f.axis[i]));  // how far a disc of radius 1 reaches
    box.low[i] = std::min(f.from[i] - f.from_radius * lean, to[i] - f.to_radius * lean);
    box.high[i] = std::max(f.from[i] + f.from_radius * lean, to[i] + f.to_radius * lean);
  }
  return box;
}

double frustum_volume(double height, double from_radius, double to_radius) {
  return k_pi / 3 * height * (from_radius * from_radius + from_radius * to_radius + to_radius * to_radius);
}

// --- superellipsoid: N(y) = ((|y_x/a|^p + |y_y/b|^p)^(q/p) + |y_z/c|^q)^(1/q) is a norm, the surface is N = 1

struct Gauge {
  double value;      ///< N(y)
  Vector3 gradient;  ///< dN/dy, for y >= 0
};

Gauge superellipsoid_gauge(const Vector3& y, const Vector3& half, double p, double q) {
  Vector3 u = {y[0] / half[0], y[1] / half[1], y[2] / half[2]};
  const double scale = *std::max_element(u.begin(), u.end());
  if (scale == 0) {  // the centre: any direction will do; this takes that of the nearest face
    Vector3 gradient = {0, 0, 0};
    const int shortest = index_of_smallest(half);
    gradient[shortest] = 1 / half[shortest];
    return {0, gradient};
  }
  for (double& coordinate : u) coordinate /= scale;  // no overflow, however large the exponents
  const double plan = elementary::power(elementary::power(u[0], p) + elementary::power(u[1], p), 1 / p);
  const double all = elementary::power(elementary::power(plan, q) + elementary::power(u[2], q), 1 / q);
  const double by_plan = plan > 0 ? elementary::power(plan / all, q - 1) : 0;
  const auto in_plan = [&](int i) { return plan > 0 ? by_plan * elementary::power(u[i] / plan, p - 1) / half[i] : 0; };
  return {scale * all, {in_plan(0), in_plan(1), elementary::power(u[2] / all, q - 1) / half[2]}};
}

}  // namespace

Point Shape::normal(const Point& x) const {
  constexpr double k_step = 1e-7;  // [m]: balances rounding and curvature for things of millimetres to metres
  Vector3 gradient;
  for (int i = 0; i < 3; ++i) {
    Point ahead = x, behind = x;
    ahead[i] += k_step;
    behind[i] -= k_step;
    gradient[i] = distance(ahead) - distance(behind);
  }
  return unit(gradient);
}

double Box::distance(const Point& x) const { return box_distance(x - centre_m, half_extents_m); }
Point Box::normal(const Point& x) const { return box_normal(x - centre_m, half_extents_m); }
Box3 Box::bounds() const { return box_around(centre_m, half_extents_m); }
double Box::volume() const { return box_volume(half_extents_m); }

std::string RoundedBox::check() const {
  const double smallest = *std::min_element(half_extents_m.begin(), half_extents_m.end());
  return radius_m <= smallest ? "" : "radius_m is larger than the smallest of half_extents_m";
}
double RoundedBox::distance(const Point& x) const {
  return box_distance(x - centre_m, half_extents_m - Vector3{radius_m, radius_m, radius_m}) - radius_m;
}
Point RoundedBox::normal(const Point& x) const { return box_normal(x - centre_m, half_extents_m - Vector3{radius_m, radius_m, radius_m}); }
Box3 RoundedBox::bounds() const { return box_around(centre_m, half_extents_m); }
double RoundedBox::volume() const {  // the box within, its faces thickened, quarters of cylinders along its edges, a ball in its corners
  const double r = radius_m, a = half_extents_m[0] - r, b = half_extents_m[1] - r, c = half_extents_m[2] - r;
  return box_volume({a, b, c}) + 8 * r * (a * b + b * c + c * a) + 2 * k_pi * r * r * (a + b + c) + ellipsoid_volume({r, r, r});
}

double Sphere::distance(const Point& x) const { return length(x - centre_m) - radius_m; }
Point Sphere::normal(const Point& x) const { return unit(x - centre_m); }
Box3 Sphere::bounds() const { return box_around(centre_m, {radius_m, radius_m, radius_m}); }
double Sphere::volume() const { return ellipsoid_volume({radius_m, radius_m, radius_m}); }

double Ellipsoid::distance(const Point& x) const {
  const Vector3 y = magnitudes(x - centre_m);
  const Vector3& e = half_axes_m;
  const double distance = length(y - ellipsoid_foot(y, e));
  return length({y[0] / e[0], y[1] / e[1], y[2] / e[2]}) < 1 ? -distance : distance;
}
Point Ellipsoid::normal(const Point& x) const {
  const Vector3& e = half_axes_m;
  const Vector3 foot = ellipsoid_foot(magnitudes(x - centre_m), e);
  return unit(with_signs({foot[0] / (e[0] * e[0]), foot[1] / (e[1] * e[1]), foot[2] / (e[2] * e[2])}, x - centre_m));
}
Box3 Ellipsoid::bounds() const { return box_around(centre_m, half_axes_m); }
double Ellipsoid::volume() const { return ellipsoid_volume(half_axes_m); }

std::string Cylinder::check() const { return from_m != to_m ? "" : "from_m and to_m are the same point"; }
double Cylinder::distance(const Point& x) const { return frustum_distance(frustum(from_m, to_m, radius_m, radius_m), x); }
Point Cylinder::normal(const Point& x) const { return frustum_normal(frustum(from_m, to_m, radius_m, radius_m), x); }
Box3 Cylinder::bounds() const { return frustum_bounds(frustum(from_m, to_m, radius_m, radius_m)); }
double Cylinder::volume() const { return frustum_volume(length(to_m - from_m), radius_m, radius_m); }

std::string Cone::check() const {
  if (from_m == to_m) return "from_m and to_m are the same point";
  return from_radius_m > 0 || to_radius_m > 0 ? "" : "from_radius_m and to_radius_m are both 0";
}
double Cone::distance(const Point& x) const { return frustum_distance(frustum(from_m, to_m, from_radius_m, to_radius_m), x); }
Point Cone::normal(const Point& x) const { return frustum_normal(frustum(from_m, to_m, from_radius_m, to_radius_m), x); }
Box3 Cone::bounds() const { return frustum_bounds(frustum(from_m, to_m, from_radius_m, to_radius_m)); }
double Cone::volume() const { return frustum_volume(length(to_m - from_m), from_radius_m, to_radius_m); }

namespace {

Vector3 from_nearest_on_line(const Capsule& capsule, const Point& x) {
  const Vector3 line = capsule.to_m - capsule.from_m;
  const double square = dot(line, line);
  const double share = square > 0 ? std::clamp(dot(x - capsule.from_m, line) / square, 0.0, 1.0) : 0;
  return x - capsule.from_m - share * line;
}

}  // namespace

double Capsule::distance(const Point& x) const { return length(from_nearest_on_line(*this, x)) - radius_m; }
Point Capsule::normal(const Point& x) const { return unit(from_nearest_on_line(*this, x)); }
Box3 Capsule::bounds() const {
  Box3 box;
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::min(from_m[i], to_m[i]) - radius_m;
    box.high[i] = std::max(from_m[i], to_m[i]) + radius_m;
  }
  return box;
}
double Capsule::volume() const {
  return frustum_volume(length(to_m - from_m), radius_m, radius_m) + ellipsoid_volume({radius_m, radius_m, radius_m});
}

// N is homogeneous of degree 1, so (N - 1) / |grad N| is the distance of the plane that touches the surface on the ray
// from the centre to x: never more than the exact distance.
double Superellipsoid::distance(const Point& x) const {
  const auto [value, gradient] = superellipsoid_gauge(magnitudes(x - centre_m), half_axes_m, plan_exponent, profile_exponent);
  return (value - 1) / length(gradient);
}
Point Superellipsoid::normal(const Point& x) const {
  const Vector3 y = x - centre_m;
  return unit(with_signs(superellipsoid_gauge(magnitudes(y), half_axes_m, plan_exponent, profile_exponent).gradient, y));
}
Box3 Superellipsoid::bounds() const { return box_around(centre_m, half_axes_m); }
double Superellipsoid::volume() const {  // slices across z are scaled outlines, so beta functions give both integrals
  const double p = plan_exponent, q = profile_exponent, plan = std::tgamma(1 + 1 / p);
  return box_volume(half_axes_m) * plan * plan / std::tgamma(1 + 2 / p) * std::tgamma(1 + 2 / q) * std::tgamma(1 + 1 / q) /
         std::tgamma(1 + 3 / q);
}

std::string HalfSpace::check() const { return length(outward_normal) > 0 ? "" : "normal has length 0"; }
double HalfSpace::distance(const Point& x) const { return dot(x - point_m, unit(outward_normal)); }
Point HalfSpace::normal(const Point&) const { return unit(outward_normal); }
Box3 HalfSpace::bounds() const {
  Box3 box{{-k_infinity, -k_infinity, -k_infinity}, {k_infinity, k_infinity, k_infinity}};
  for (int i = 0; i < 3; ++i) {
    const bool along_axis = std::abs(outward_normal[i]) == length(outward_normal);
    if (along_axis && outward_normal[i] > 0) box.high[i] = point_m[i];
    if (along_axis && outward_normal[i] < 0) box.low[i] = point_m[i];
  }
  return box;
}

}  // namespace bake

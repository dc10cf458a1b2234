// SPDX-License-Identifier: MIT
// All shapes of scenes, and their combinations.
//
// A shape is a plain struct of its scene keys. `check()` tells in one clause why values that are each in range do not fit together. If it
// returns an empty text, the shape is valid; only then may the other functions be called.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "solver/boundary/shape.h"

namespace bake {

struct Box final : Shape {
  static constexpr const char* name = "box";
  static constexpr const char* meaning = "box with faces along the axes";
  Point centre_m = {0, 0, 0};
  Vector3 half_extents_m = {0, 0, 0};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"centre_m", &Box::centre_m, "m", any_number, "centre"},
        Parameter{"half_extents_m", &Box::half_extents_m, "m", positive, "half of its length along x, y, z", Presence::required},
    };
  }
  std::string check() const { return {}; }
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct RoundedBox final : Shape {
  static constexpr const char* name = "rounded_box";
  static constexpr const char* meaning = "box with faces along the axes and rounded edges and corners";
  Point centre_m = {0, 0, 0};
  Vector3 half_extents_m = {0, 0, 0};
  double radius_m = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"centre_m", &RoundedBox::centre_m, "m", any_number, "centre"},
        Parameter{"half_extents_m", &RoundedBox::half_extents_m, "m", positive, "half of its length along x, y, z, rounding included",
                  Presence::required},
        Parameter{"radius_m", &RoundedBox::radius_m, "m", non_negative, "radius of edges and corners; at most the smallest half extent",
                  Presence::required},
    };
  }
  std::string check() const;
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct Sphere final : Shape {
  static constexpr const char* name = "sphere";
  static constexpr const char* meaning = "ball";
  Point centre_m = {0, 0, 0};
  double radius_m = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"centre_m", &Sphere::centre_m, "m", any_number, "centre"},
        Parameter{"radius_m", &Sphere::radius_m, "m", positive, "radius", Presence::required},
    };
  }
  std::string check() const { return {}; }
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct Ellipsoid final : Shape {
  static constexpr const char* name = "ellipsoid";
  static constexpr const char* meaning = "ellipsoid with half axes along x, y, z";
  Point centre_m = {0, 0, 0};
  Vector3 half_axes_m = {0, 0, 0};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"centre_m", &Ellipsoid::centre_m, "m", any_number, "centre"},
        Parameter{"half_axes_m", &Ellipsoid::half_axes_m, "m", positive, "half axes along x, y, z", Presence::required},
    };
  }
  std::string check() const { return {}; }
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct Cylinder final : Shape {
  static constexpr const char* name = "cylinder";
  static constexpr const char* meaning = "cylinder between the centres of its flat ends";
  Point from_m = {0, 0, 0};
  Point to_m = {0, 0, 0};
  double radius_m = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"from_m", &Cylinder::from_m, "m", any_number, "centre of one flat end", Presence::required},
        Parameter{"to_m", &Cylinder::to_m, "m", any_number, "centre of the other flat end", Presence::required},
        Parameter{"radius_m", &Cylinder::radius_m, "m", positive, "radius", Presence::required},
    };
  }
  std::string check() const;
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct Capsule final : Shape {
  static constexpr const char* name = "capsule";
  static constexpr const char* meaning = "every point within a radius of a straight line: a cylinder with round ends";
  Point from_m = {0, 0, 0};
  Point to_m = {0, 0, 0};
  double radius_m = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"from_m", &Capsule::from_m, "m", any_number, "centre of one round end", Presence::required},
        Parameter{"to_m", &Capsule::to_m, "m", any_number, "centre of the other round end", Presence::required},
        Parameter{"radius_m", &Capsule::radius_m, "m", positive, "radius", Presence::required},
    };
  }
  std::string check() const { return {}; }
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct Cone final : Shape {
  static constexpr const char* name = "cone";
  static constexpr const char* meaning = "cone between the centres of its flat ends; a radius of 0 makes a tip, two radii a truncated cone";
  Point from_m = {0, 0, 0};
  Point to_m = {0, 0, 0};
  double from_radius_m = 0;
  double to_radius_m = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"from_m", &Cone::from_m, "m", any_number, "centre of one end", Presence::required},
        Parameter{"to_m", &Cone::to_m, "m", any_number, "centre of the other end", Presence::required},
        Parameter{"from_radius_m", &Cone::from_radius_m, "m", non_negative, "radius at from_m", Presence::required},
        Parameter{"to_radius_m", &Cone::to_radius_m, "m", non_negative, "radius at to_m"},
    };
  }
  std::string check() const;
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

/// (|x/a|^p + |y/b|^p)^(q/p) + |z/c|^q <= 1 with p = plan_exponent, q = profile_exponent. First-order distance.
struct Superellipsoid final : Shape {
  static constexpr const char* name = "superellipsoid";
  static constexpr const char* meaning = "between an ellipsoid (exponents 2) and a box (large exponents): a loaf";
  static constexpr Range exponents{1, 20, false, false, "a number from 1 to 20"};
  Point centre_m = {0, 0, 0};
  Vector3 half_axes_m = {0, 0, 0};
  double plan_exponent = 2;
  double profile_exponent = 2;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"centre_m", &Superellipsoid::centre_m, "m", any_number, "centre"},
        Parameter{"half_axes_m", &Superellipsoid::half_axes_m, "m", positive, "half of its length along x, y, z", Presence::required},
        Parameter{"plan_exponent", &Superellipsoid::plan_exponent, "1", exponents,
                  "p of |x/a|^p + |y/b|^p, its outline seen along z: 1 is a rhombus, 2 an ellipse, 20 nearly a rectangle"},
        Parameter{"profile_exponent", &Superellipsoid::profile_exponent, "1", exponents,
                  "q of the same rule between that outline and z, seen from the side"},
    };
  }
  std::string check() const { return {}; }
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
  double volume() const override;
};

struct HalfSpace final : Shape {
  static constexpr const char* name = "half_space";
  static constexpr const char* meaning = "everything on one side of a plane";
  Point point_m = {0, 0, 0};
  Vector3 outward_normal = {0, 0, 1};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"point_m", &HalfSpace::point_m, "m", any_number, "a point of the plane"},
        Parameter{"normal", &HalfSpace::outward_normal, "1", any_number, "direction out of the solid, of any length"},
    };
  }
  std::string check() const;
  double distance(const Point& x) const override;
  Point normal(const Point& x) const override;
  Box3 bounds() const override;
};

using AllShapes = std::tuple<Box, RoundedBox, Sphere, Ellipsoid, Cylinder, Capsule, Cone, Superellipsoid, HalfSpace>;

// Combinations. They throw std::invalid_argument for an empty list, a null shape or a scale that is not positive.

/// Inside any of them. The distance is exact outside if the parts' are, and may be too shallow inside.
ShapePtr make_union(std::vector<ShapePtr> parts);
/// Inside all of them. The distance is exact inside if the parts' are, and may be too small outside.
ShapePtr make_intersection(std::vector<ShapePtr> parts);
/// Inside `first` and in none of `cut`.
ShapePtr make_difference(ShapePtr first, std::vector<ShapePtr> cut);
/// The points R (scale X) + move_m of a shape's points X; `rotate_deg` is a rotation vector, axis times angle [degree].
ShapePtr make_transformed(ShapePtr shape, double scale, const Vector3& rotate_deg, const Vector3& move_m);

}  // namespace bake

// SPDX-License-Identifier: MIT
// A shape with prescribed motion that exists for a limited time: a collider or grip.
#pragma once

#include "solver/boundary/motion_path.h"
#include "solver/boundary/rotation.h"
#include "solver/boundary/shape.h"

namespace bake {

/// Call `path.at(t)` once per step for the pose, then ask for distances and normals at any number of points.
struct ScriptedShape {
  ShapePtr shape;  ///< in the frame it was drawn in
  RigidPath path;
  double from_s = -k_infinity;
  double until_s = k_infinity;

  bool present(double time_s) const { return time_s >= from_s && time_s < until_s; }
  double distance(const RigidState& pose, const Point& world) const { return shape->distance(pose.to_drawn(world)); }
  Vector3 normal(const RigidState& pose, const Point& world) const { return pose.turn(shape->normal(pose.to_drawn(world))); }
  /// A box that contains the moved shape; it is tight if the shape has not rotated.
  Box3 bounds(const RigidState& pose) const {
    const Box3 drawn = shape->bounds();
    const Box3 about_pivot = turned(pose.rotation, {drawn.low - pose.pivot, drawn.high - pose.pivot});
    return {about_pivot.low + pose.centre, about_pivot.high + pose.centre};
  }
};

}  // namespace bake

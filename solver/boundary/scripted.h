// SPDX-License-Identifier: MIT
// A shape that moves by a script and may be there only for a while: colliders and grips.
#pragma once

#include "solver/boundary/motion_path.h"
#include "solver/boundary/rotation.h"
#include "solver/boundary/shape.h"

namespace bake {

/// Ask `path.at(t)` for the pose once per step, then distances and normals for any number of world points.
struct ScriptedShape {
  ShapePtr shape;  ///< in the frame it was drawn in
  RigidPath path;
  double from_s = -k_infinity;
  double until_s = k_infinity;

  bool present(double time_s) const { return time_s >= from_s && time_s < until_s; }
  double distance(const RigidState& pose, const Point& world) const { return shape->distance(pose.to_drawn(world)); }
  Vector3 normal(const RigidState& pose, const Point& world) const { return pose.turn(shape->normal(pose.to_drawn(world))); }
  /// Box that holds the moved shape: tight if it has not turned.
  Box3 bounds(const RigidState& pose) const {
    const Box3 drawn = shape->bounds();
    const Box3 about_pivot = turned(pose.rotation, {drawn.low - pose.pivot, drawn.high - pose.pivot});
    return {about_pivot.low + pose.centre, about_pivot.high + pose.centre};
  }
};

}  // namespace bake

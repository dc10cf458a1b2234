// SPDX-License-Identifier: MIT
// Scripted rigid motion of colliders, grips and whatever else is moved by hand.
#pragma once

#include <vector>

#include "solver/boundary/shape.h"

namespace bake {

/// Position and orientation of a moving shape at one time. Positions are offsets from where the scene draws the
/// shape; rotations are about `RigidPath::pivot`.
struct Keyframe {
  double time_s = 0;
  Vector3 position_m = {0, 0, 0};
  Vector3 rotation_deg = {0, 0, 0};  ///< rotation vector: axis times angle [degree]
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"time_s", &Keyframe::time_s, "s", any_number, "time of this pose", Presence::required},
        Parameter{"position_m", &Keyframe::position_m, "m", any_number, "offset from the place the shape was drawn at"},
        Parameter{"rotation_deg", &Keyframe::rotation_deg, "deg", any_number, "rotation vector (axis times angle) about the pivot"},
    };
  }
};

/// Rigid pose x = R (X - pivot) + pivot + offset, and its velocity field v(x) = v_0 + omega x (x - centre).
struct RigidState {
  std::array<Vector3, 3> rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows of R
  Point centre = {0, 0, 0};         ///< where the pivot is now [m]
  Point pivot = {0, 0, 0};          ///< where the pivot was drawn [m]
  Vector3 velocity = {0, 0, 0};     ///< of the pivot [m/s]
  Vector3 spin = {0, 0, 0};         ///< angular velocity [rad/s]

  Point to_drawn(const Point& x) const;           ///< world point -> the frame the shape was drawn in
  Vector3 turn(const Vector3& drawn) const;       ///< direction in the drawn frame -> world
  Vector3 velocity_at(const Point& x) const;
};

/// Piecewise rigid motion through keyframes: offsets linear in time, rotations at constant angular velocity between
/// neighbouring keys (the shorter way), at rest before the first and after the last.
class RigidPath {
 public:
  RigidPath() = default;  ///< at rest where drawn
  RigidPath(std::vector<Keyframe> keys, const Point& pivot);  ///< throws std::invalid_argument if times do not rise
  RigidState at(double time_s) const;
  /// Largest speed of any point of `box` (drawn frame) over the whole path [m/s].
  double largest_speed(const Box3& box) const;
  bool moves() const { return keys_.size() > 1; }

 private:
  std::vector<Keyframe> keys_;
  Point pivot_ = {0, 0, 0};
};

}  // namespace bake

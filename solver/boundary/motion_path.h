// SPDX-License-Identifier: MIT
// Prescribed rigid motion of colliders and grips.
#pragma once

#include <vector>

#include "solver/boundary/rotation.h"
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
        Parameter{"position_m", &Keyframe::position_m, "m", any_number, "offset from the position in which the scene draws the shape"},
        Parameter{"rotation_deg", &Keyframe::rotation_deg, "deg", any_number, "rotation vector (axis times angle) about the pivot"},
    };
  }
};

/// Rigid pose x = R (X - pivot) + centre, and its velocity field v(x) = velocity + omega x (x - centre).
struct RigidState {
  Rotation rotation = k_no_rotation;     ///< rows of R
  Point centre = {0, 0, 0};              ///< where the pivot is now [m]
  Point pivot = {0, 0, 0};               ///< where the pivot was drawn [m]
  Vector3 velocity = {0, 0, 0};          ///< of the pivot [m/s]
  Vector3 angular_velocity = {0, 0, 0};  ///< omega [rad/s]

  Point to_drawn(const Point& x) const { return turn_back(rotation, x - centre) + pivot; }  ///< world -> drawn frame
  Point to_world(const Point& drawn) const { return rotation * (drawn - pivot) + centre; }
  Vector3 turn(const Vector3& drawn) const { return rotation * drawn; }  ///< direction in the drawn frame -> world
  Vector3 velocity_at(const Point& x) const { return velocity + cross(angular_velocity, x - centre); }
};

/// Piecewise rigid motion through keyframes: offsets linear in time, rotations at constant angular velocity, at rest
/// before the first and after the last. Between rotation vectors along one axis the shape rotates as written,
/// including whole turns ([0,0,0] to [0,0,720] turns twice); otherwise it takes the shorter way.
/// At a keyframe the velocity is that of the leg that begins there.
class RigidPath {
 public:
  RigidPath() = default;                                             ///< at rest where drawn
  RigidPath(const std::vector<Keyframe>& keys, const Point& pivot);  ///< throws std::invalid_argument if times do not rise
  RigidState at(double time_s) const;
  /// Bound on the speed over the whole path of any point of `box` (drawn frame) that is in `region` (world) at the time [m/s]. It is exact
  /// without rotation, and without translation if the box decides. Either may be infinite; if both are and the path turns, the bound is.
  double largest_speed(const Box3& box, const Box3& region) const;
  bool moves() const { return legs_.size() > 1; }

 private:
  /// From one key to the next; the last leg is at rest.
  struct Leg {
    double start_s = 0;
    Vector3 offset = {0, 0, 0};    ///< at the start
    Quaternion orientation;        ///< at the start
    Vector3 velocity = {0, 0, 0};  ///< of the pivot
    Vector3 angular_velocity = {0, 0, 0};
  };
  RigidState state(const Leg& leg, double since_s) const;

  std::vector<Leg> legs_;
  Point pivot_ = {0, 0, 0};
};

}  // namespace bake

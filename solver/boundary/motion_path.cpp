// SPDX-License-Identifier: MIT
#include "solver/boundary/motion_path.h"

#include <algorithm>
#include <stdexcept>

namespace bake {
namespace {

/// Rotation vector [rad] that turns orientation a into b, in the world frame.
Vector3 turn_between(const Keyframe& a, const Keyframe& b) {
  const Vector3 from = k_rad_per_deg * a.rotation_deg, to = k_rad_per_deg * b.rotation_deg;
  const bool same_axis = length(cross(from, to)) <= 1e-12 * length(from) * length(to);
  return same_axis ? to - from : rotation_vector(quaternion(to) * inverse(quaternion(from)));
}

bool finite(const Box3& box) {
  const auto is_finite = [](double coordinate) { return std::isfinite(coordinate); };
  return std::all_of(box.low.begin(), box.low.end(), is_finite) && std::all_of(box.high.begin(), box.high.end(), is_finite);
}

}  // namespace

RigidPath::RigidPath(const std::vector<Keyframe>& keys, const Point& pivot) : pivot_(pivot) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    Leg leg{keys[i].time_s, keys[i].position_m, quaternion(k_rad_per_deg * keys[i].rotation_deg)};
    if (i + 1 < keys.size()) {
      const double duration = keys[i + 1].time_s - keys[i].time_s;
      if (!(duration > 0)) throw std::invalid_argument("times of keyframes must rise");
      leg.velocity = (1 / duration) * (keys[i + 1].position_m - keys[i].position_m);
      leg.angular_velocity = (1 / duration) * turn_between(keys[i], keys[i + 1]);
    }
    legs_.push_back(leg);
  }
}

RigidState RigidPath::state(const Leg& leg, double since_s) const {
  RigidState state;
  state.rotation = matrix(quaternion(since_s * leg.angular_velocity) * leg.orientation);
  state.pivot = pivot_;
  state.centre = pivot_ + leg.offset + since_s * leg.velocity;
  state.velocity = leg.velocity;
  state.angular_velocity = leg.angular_velocity;
  return state;
}

RigidState RigidPath::at(double time_s) const {
  if (legs_.empty()) return state(Leg{}, 0);
  const auto next = std::upper_bound(legs_.begin(), legs_.end(), time_s, [](double t, const Leg& leg) { return t < leg.start_s; });
  if (next != legs_.begin()) return state(*(next - 1), time_s - (next - 1)->start_s);
  RigidState waiting = state(legs_.front(), 0);
  waiting.velocity = waiting.angular_velocity = {0, 0, 0};
  return waiting;
}

double RigidPath::largest_speed(const Box3& box, const Box3& region) const {
  double largest = 0;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const Leg& leg = legs_[i];
    double turning = 0;  // about the pivot
    if (length(leg.angular_velocity) > 0) {
      const auto fastest = [&](const Box3& corners, auto from_pivot) {
        double speed = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const Point x = {(corner & 1 ? corners.high : corners.low)[0], (corner & 2 ? corners.high : corners.low)[1],
                           (corner & 4 ? corners.high : corners.low)[2]};
          speed = std::max(speed, length(cross(leg.angular_velocity, from_pivot(x))));
        }
        return speed;
      };
      turning = k_infinity;
      if (finite(box)) turning = fastest(box, [&](const Point& x) { return matrix(leg.orientation) * (x - pivot_); });
      if (finite(region)) {  // the pivot goes straight, so that the distance to a corner is largest at an end of the leg
        const Vector3 end = i + 1 < legs_.size() ? legs_[i + 1].offset : leg.offset;
        const double there = std::max(fastest(region, [&](const Point& x) { return x - pivot_ - leg.offset; }),
                                      fastest(region, [&](const Point& x) { return x - pivot_ - end; }));
        turning = std::min(turning, there);
      }
    }
    largest = std::max(largest, length(leg.velocity) + turning);
  }
  return largest;
}

}  // namespace bake

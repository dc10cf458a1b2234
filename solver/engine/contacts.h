// SPDX-License-Identifier: MIT
// What touches the dough: colliders, grips and the faces of the domain, acting on the velocities of grid nodes.
#pragma once

#include <optional>
#include <vector>

#include "solver/boundary/obstacles.h"
#include "solver/boundary/scripted.h"
#include "solver/grid/grid.h"

namespace bake {

struct Scene;

/// Heat that a collider offers to the dough it touches.
struct ContactHeat {
  double heat_transfer_coefficient = 0;  ///< beta [W/(m^2 K)]
  double temperature = 0;                ///< theta [C]
  bool operator==(const ContactHeat&) const = default;
};

/// A temperature that a grip holds, and how far away [C, m].
struct HeldNear {
  double temperature, distance;
};

class Contacts final : public Obstacles {
 public:
  Contacts(const Scene& scene, const GridGeometry& geometry);

  /// Fixes all poses for a step that begins at `time`.
  void prepare(double time);
  /// Does anything touch the block or lie within `reach` of it?
  bool near(const BlockIndex& block, double reach) const;
  /// Is there something that expels particles within `reach` of the block?
  bool expels_near(const BlockIndex& block, double reach) const;
  bool push_out(Point& x, Vector3& v) const override;
  /// Applies every contact to a node: returns the velocity after contact.
  Vector3 velocity_after(const Point& x, Vector3 v) const;
  /// Does a solid stand within `reach` of a surface at `x`, in front of its outward normal `n` if that is known? Its heat, zero if
  /// it gives none.
  std::optional<ContactHeat> covering(const Point& x, const std::optional<Vector3>& n, double reach) const;
  /// The nearest grip that holds a temperature, if one is within `reach` of `x`; distances in it are negative.
  std::optional<HeldNear> held_near(const Point& x, double reach) const;
  bool holds_temperatures() const { return holds_temperatures_; }
  /// Fastest collider or grip at present [m/s].
  double largest_speed() const { return largest_speed_; }
  /// First time after `time` at which something appears or goes.
  double next_event(double time) const;

 private:
  enum class Rule { sticky, slip, separating, grip };
  struct Contacting {
    ScriptedShape scripted;
    Rule rule;
    double friction;
    bool expels;
    std::optional<Curve> temperature;
    double heat_transfer_coefficient;
    double speed;  ///< largest over its whole path [m/s]
  };
  struct Present {
    const Contacting* contact;
    RigidState pose;
    Box3 bounds;
    double temperature;
  };
  bool reaches(const Present& present, const BlockIndex& block, double reach) const;
  /// Is `x` in it, or no further away than `reach`?
  static bool reaches(const Present& present, const Point& x, double reach);
  Vector3 velocity_beside(const Present& present, const Point& x, const Vector3& v) const;
  /// A node this close to a solid is in it: faces are often drawn through nodes, whose positions are rounded [m].
  double touching() const { return 1e-6 * geometry_.dx(); }

  struct DomainFace {
    int axis;
    double sign;  ///< of the inward normal
    double at;    ///< [m]
    Rule rule;
  };

  std::vector<Contacting> all_;
  std::vector<Present> present_;
  std::vector<DomainFace> faces_;
  double face_friction_;
  const GridGeometry geometry_;
  bool holds_temperatures_ = false;
  double largest_speed_ = 0;
  bool expels_ = false;
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// What touches the dough: colliders, grips and the faces of the domain, acting on the velocities of grid nodes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "solver/boundary/obstacles.h"
#include "solver/boundary/scripted.h"
#include "solver/engine/engine_types.h"
#include "solver/engine/survey.h"
#include "solver/grid/grid.h"

namespace bake {

struct Scene;

/// Heat that a collider or a face of the domain offers to the dough it touches.
struct ContactHeat {
  double heat_transfer_coefficient = 0;  ///< beta [W/(m^2 K)]; infinite: the dough's surface has that temperature
  double temperature = 0;                ///< theta [C]
  double flux = 0;                       ///< that comes in whatever the temperatures are [W/m^2]
  int giver = -1;                        ///< number of who it is among givers_of(scene), if the ledger tells what it gives
  /// Whoever gives it.
  bool operator==(const ContactHeat& other) const {
    return heat_transfer_coefficient == other.heat_transfer_coefficient && temperature == other.temperature && flux == other.flux;
  }
};

/// Solids in front of a surface, and the share of its area that each has: 1 if it is alone. Of several each has what the surface shows it,
/// -n . n_s, over the sum of n_s . n_t over those that look the same way: walls at right angles have the area that a rounded edge of the
/// dough projects onto them, which is their own, and two solids side by side halve it.
struct Covers {
  static constexpr int k_most = 4;
  struct Solid {
    ContactHeat heat;
    Vector3 normal;
    double facing, share = 1;
  };
  int count = 0;
  std::array<Solid, k_most> solids;
  const Solid* begin() const { return solids.data(); }
  const Solid* end() const { return solids.data() + count; }
};

/// A temperature that a grip holds, and how far away [C, m].
struct HeldNear {
  double temperature, distance;
};

/// A node before contact.
struct NodeState {
  double mass = 0;  ///< [kg]
  Vector3 velocity{0, 0, 0};
};

/// The nodes along the axes through one node.
class NodesAround {
 public:
  virtual ~NodesAround() = default;
  /// Of the node that is `steps` node distances further along `axis`; without mass where there is none.
  virtual NodeState at(int axis, int steps) const = 0;
};

class Contacts final : public Obstacles {
 public:
  Contacts(const Scene& scene, const GridGeometry& geometry);

  /// Fixes all poses for a step that begins at `time`, and temperatures and fluxes, of which a step takes the mean over its `dt`;
  /// `at_rest`: as they are then, and none moves on.
  void prepare(double time, double dt = 0, bool at_rest = false);
  /// Finds what contact asks of the nodes of those blocks, where solids stand still and it is not known yet.
  void survey(const ActiveBlocks& active);
  /// Does anything touch the block or lie within `reach` of it?
  bool near(const BlockIndex& block, double reach) const;
  /// What the measure of a surface asks of all that covers it: poses, temperatures and fluxes, as of prepare(). Equal numbers give equal
  /// answers.
  const std::vector<double>& covers() const { return covers_; }
  /// Is there something that expels particles?
  bool expels() const { return expels_; }
  /// Does a collider lie within `reach` of the block?
  bool collider_near(const BlockIndex& block, double reach) const;
  /// The nodes of a block whose velocity contact may change.
  NodeBits nodes_touched(const BlockIndex& block) const;
  /// Does a collider that covers, or a face of the domain that passes heat, lie within `reach` of the block?
  bool cover_near(const BlockIndex& block, double reach) const;
  /// Is dough mirrored at that face of the domain (x_min, x_max, y_min, ...) when its surface is measured? Not where heat or all passes.
  bool is_mirror(int face) const { return is_mirror_[static_cast<std::size_t>(face)]; }
  /// Is there something that expels particles within `reach` of the block?
  bool expels_near(const BlockIndex& block, double reach) const;
  bool push_out(Point& x, Vector3& v, double mass) const override { return push_out(x, v, mass, nullptr); }
  bool holds_temperature(const Point& x) const override;
  /// Is there a grip that holds its temperature within `reach` of the block?
  bool holds_temperature_near(const BlockIndex& block, double reach) const;
  /// The same; adds to `given`, if not null, what each of givers_of(scene) gave.
  bool push_out(Point& x, Vector3& v, double mass, Given* given) const;
  /// Applies every contact to a node: returns the velocity after contact. `around`: the nodes around one that may be beside a collider
  /// (see reach_beside_colliders), before contact.
  ///
  /// A collider's face lies between nodes. Where dough touches it, the dough's velocity relative to it goes to zero at the face, in
  /// proportion to the distance d, and nodes on both sides have their place on that line: with v_k of the first node of the column along
  /// the axis nearest to the normal that is at least dx away, (d / d_k) v_k. The contact's rule acts on what departs from the line. Were
  /// only nodes inside moved, with the velocity of the collider, the last layer of dough, which nothing holds but the next node inside,
  /// would be squashed before the rest is pressed. Whether dough touches is known from the mass of the column's nodes beside that of node
  /// k.
  Vector3 velocity_after(const Place& at, Vector3 v, const NodesAround* around = nullptr) const {
    return after_all<false>(at, v, around, 0, nullptr);
  }
  /// The same of a node of the mass `mass`; adds to `given` what each of givers_of(scene) gave.
  Vector3 velocity_after(const Place& at, Vector3 v, const NodesAround* around, double mass, Given* given) const {
    return after_all<true>(at, v, around, mass, given);
  }
  /// All nodes that contact with a collider depends on are no further from it than this [m].
  double reach_beside_colliders() const { return 2.1 * geometry_.dx(); }
  /// The first solid that covers, or face that passes heat, within `reach` of a place: its heat, zero if it gives none.
  std::optional<ContactHeat> cover_within(const Place& at, double reach) const;
  /// Those of them that stand in front of a surface with the outward normal `n`: whose nearest face looks against n, or to which it is
  /// nearer by reach / 2 if one goes that far along n. Where several do, as where two walls meet, each has its part of the surface.
  Covers covering(const Place& at, const Vector3& n, double reach) const;
  /// The share that colliders which cover and faces that pass heat leave to the dough of what is averaged into phi~ there (surface.h): 1
  /// from 2.5 dx on, one half on the face of one, 0 inside. Grips take nothing, since they hold dough.
  double room(const Place& at) const;
  /// The nearest grip that holds a temperature, if one is within `reach`; distances in it are negative.
  std::optional<HeldNear> held_near(const Place& at, double reach) const;
  bool has_colliders() const { return has_colliders_; }
  bool holds_temperatures() const { return holds_now_; }  ///< as of prepare()
  /// Fastest collider or grip at present [m/s].
  double largest_speed() const { return largest_speed_; }
  /// First time after `time` at which something appears or goes.
  double next_event(double time) const;
  std::size_t bytes() const;

 private:
  enum class Rule { sticky, slip, separating, grip };
  struct Contacting {
    ScriptedShape scripted;
    Rule rule;
    double friction;
    bool expels;
    bool covers;  ///< shuts off the surface that it touches from the air
    std::optional<Curve> temperature;
    double heat_transfer_coefficient;
    double speed;  ///< largest in the domain over its whole path [m/s]
    int giver;     ///< its number among givers_of(scene), or -1
    Survey survey;
    /// Does its face lie between nodes for those beside it (see velocity_after)?
    bool has_columns() const { return rule != Rule::grip && !expels; }
    bool holds_temperature() const { return rule == Rule::grip && temperature; }
  };
  struct Present {
    Contacting* contact;
    RigidState pose;
    Box3 bounds;
    double temperature;
    bool stands;  ///< as in the step before
  };
  template <bool tells>
  Vector3 after_all(const Place& at, Vector3 v, const NodesAround* around, double mass, Given* given) const;
  static ContactHeat heat_of(const Present& present);
  bool reaches(const Present& present, const BlockIndex& block, double reach) const;
  bool face_near(const BlockIndex& block) const;
  /// Distance of a place from it, negative inside; none if that is more than `reach`.
  static std::optional<double> distance_within(const Present& present, const Place& at, double reach);
  /// `column`: of the place, if that is known. `line`: the velocity relative to the solid that dough has there which touches it.
  static Vector3 velocity_beside(const Present& present, const Point& x, const Vector3& v, const Column* column = nullptr,
                                 const Vector3& line = {0, 0, 0});
  /// That line at a node, none if no dough touches the collider there.
  std::optional<Vector3> line(const Present& present, const Point& x, const Column& column, const NodesAround& around) const;
  /// A node this close to a solid is in it: faces are often drawn through nodes, whose positions are rounded [m].
  double touching() const { return 1e-6 * geometry_.dx(); }

  struct FacePlane {
    int axis;
    double sign;                                                                                       ///< of the inward normal
    double at;                                                                                         ///< [m]
    double distance(const Point& x) const { return sign * (x[static_cast<std::size_t>(axis)] - at); }  ///< negative outside [m]
  };
  /// `face`: 0 to 5, as x_min, x_max, y_min, ...
  FacePlane plane_of(int face) const;
  struct FaceOfDomain : FacePlane {
    Rule rule;
    int giver;
  };

  /// A face of the domain that passes heat: for the measure of the surface a solid that fills the space beyond it.
  struct Wall : FacePlane {
    std::optional<Curve> temperature, flux;
    ContactHeat heat;  ///< at present
  };

  std::vector<Contacting> all_;
  std::vector<Present> present_;
  std::vector<FaceOfDomain> faces_;
  std::vector<Wall> walls_;
  std::array<bool, 6> is_mirror_{true, true, true, true, true, true};
  double face_friction_;
  const GridGeometry geometry_;
  std::vector<double> covers_;
  bool has_colliders_ = false, holds_temperatures_ = false;
  bool holds_now_ = false;  ///< not while the dough settles
  double largest_speed_ = 0;
  bool expels_ = false;
};

}  // namespace bake

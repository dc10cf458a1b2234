// SPDX-License-Identifier: MIT
#include "solver/engine/contacts.h"

#include <algorithm>

#include "solver/core/vector3.h"
#include "solver/scene/scene.h"

namespace bake {

namespace {

/// Velocity of dough that touches a surface with outward normal `n`, relative to the surface. Coulomb: friction takes as much
/// tangential speed as `friction` times the normal speed that the surface takes.
Vector3 contact(Vector3 relative, const Vector3& n, bool sticky, bool separating, double friction) {
  if (sticky) return {0, 0, 0};
  const double normal_speed = dot(relative, n);
  if (separating && normal_speed >= 0) return relative;
  Vector3 tangential = relative - normal_speed * n;
  const double speed = length(tangential);
  const double kept = speed > 0 ? std::max(0.0, 1 + friction * std::min(normal_speed, 0.0) / speed) : 0;
  return kept * tangential;
}

}  // namespace

Contacts::Contacts(const Scene& scene, const GridGeometry& geometry)
    : face_friction_(scene.domain.friction), geometry_(geometry), has_colliders_(!scene.colliders.empty()) {
  const Box3 domain{scene.domain.min_m, scene.domain.max_m};
  int givers = 0;
  for (const Collider& c : scene.colliders) {
    const Rule rule = c.contact == Contact::sticky ? Rule::sticky : c.contact == Contact::slip ? Rule::slip : Rule::separating;
    const RigidPath path(c.motion, c.pivot_m);
    all_.push_back({{c.shape, path, c.from_s, c.until_s},
                    rule,
                    c.friction,
                    c.expels,
                    c.covers,
                    c.temperature_C,
                    c.heat_transfer_coefficient_W_per_m2K,
                    path.moves() ? path.largest_speed(c.shape->bounds(), domain) : 0,
                    c.ledger ? givers++ : -1,
                    {}});
  }
  for (const Grip& g : scene.grips) {
    const RigidPath path(g.motion, g.pivot_m);
    all_.push_back({{g.shape, path, g.from_s, g.until_s},
                    Rule::grip,
                    0,
                    false,
                    false,
                    g.temperature_C,
                    0,
                    path.moves() ? path.largest_speed(g.shape->bounds(), domain) : 0,
                    g.ledger ? givers++ : -1,
                    {}});
    holds_temperatures_ |= g.temperature_C.has_value();
  }
  int giver_at[6] = {-1, -1, -1, -1, -1, -1};
  for (const DomainFace& f : scene.faces)
    if (f.ledger) giver_at[static_cast<int>(f.at)] = givers++;
  const Face faces[6] = {scene.domain.x_min, scene.domain.x_max, scene.domain.y_min,
                         scene.domain.y_max, scene.domain.z_min, scene.domain.z_max};
  for (int i = 0; i < 6; ++i) {
    if (faces[i] == Face::periodic) is_mirror_[static_cast<std::size_t>(i)] = false;
    if (faces[i] == Face::open || faces[i] == Face::periodic) continue;
    const Rule rule = faces[i] == Face::sticky ? Rule::sticky : faces[i] == Face::slip ? Rule::slip : Rule::separating;
    faces_.push_back({plane_of(i), rule, giver_at[i]});
  }
  for (const DomainFace& f : scene.faces) {
    if (!f.passes_heat()) continue;
    const int face = static_cast<int>(f.at);
    ContactHeat heat;
    if (f.temperature_C) heat.heat_transfer_coefficient = f.heat_transfer_coefficient_W_per_m2K.value_or(k_infinity);
    heat.giver = giver_at[face];
    walls_.push_back({plane_of(face), f.temperature_C, f.heat_flux_W_per_m2, heat});
    is_mirror_[static_cast<std::size_t>(face)] = false;
  }
}

Contacts::FacePlane Contacts::plane_of(int face) const {
  const int axis = face / 2;
  const bool is_high = face % 2 != 0;
  const double nodes = is_high ? geometry_.high_face(axis) : geometry_.low_face();
  return {axis, is_high ? -1.0 : 1.0, geometry_.origin({0, 0, 0})[static_cast<std::size_t>(axis)] + nodes * geometry_.dx()};
}

void Contacts::prepare(double time, double dt, bool at_rest) {
  const auto mean = [&](const Curve& curve) { return curve.mean(time, time + dt); };
  present_.clear();
  largest_speed_ = 0;
  expels_ = false;
  holds_now_ = holds_temperatures_ && !at_rest;
  covers_.clear();
  for (Wall& w : walls_) {
    if (w.temperature) w.heat.temperature = mean(*w.temperature);
    if (w.flux) w.heat.flux = mean(*w.flux);
    covers_.insert(covers_.end(), {w.heat.temperature, w.heat.flux});
  }
  for (Contacting& c : all_) {
    const bool present = c.scripted.present(time);
    if (c.covers) covers_.push_back(present);
    if (!present) continue;
    RigidState pose = c.scripted.path.at(time);
    if (at_rest) pose.velocity = pose.angular_velocity = {0, 0, 0};
    present_.push_back({&c, pose, c.scripted.bounds(pose), c.temperature ? mean(*c.temperature) : 0, c.survey.stands_at(pose)});
    largest_speed_ = std::max(largest_speed_, c.speed);
    expels_ |= c.expels;
    if (!c.covers) continue;
    for (const auto& row : pose.rotation) covers_.insert(covers_.end(), row.begin(), row.end());
    covers_.insert(covers_.end(), pose.centre.begin(), pose.centre.end());
    covers_.push_back(present_.back().temperature);
  }
}

void Contacts::survey(const ActiveBlocks& active) {
  for (const Present& p : present_)
    if (p.stands)
      p.contact->survey.add(p.contact->scripted, active, geometry_,
                            [&](const BlockIndex& block) { return reaches(p, block, Survey::k_reach * geometry_.dx()); });
}

bool Contacts::cover_near(const BlockIndex& block, double reach) const {
  if (std::any_of(present_.begin(), present_.end(),
                  [&](const Present& p) { return p.contact->covers && reaches(p, block, reach + touching()); }))
    return true;
  const Point low = geometry_.origin(block), high = low + (3 * geometry_.dx()) * Vector3{1, 1, 1};
  return std::any_of(walls_.begin(), walls_.end(),
                     [&](const Wall& w) { return std::min(w.distance(low), w.distance(high)) <= reach + touching(); });
}

/// As touching as for the block's nodes: the face may go through its last ones.
bool Contacts::face_near(const BlockIndex& block) const {
  const Point low = geometry_.origin(block);
  return std::any_of(faces_.begin(), faces_.end(), [&](const FaceOfDomain& f) {
    const double a = low[static_cast<std::size_t>(f.axis)];
    return f.sign > 0 ? a <= f.at + touching() : a + 3 * geometry_.dx() >= f.at - touching();
  });
}

bool Contacts::near(const BlockIndex& block, double reach) const {
  return face_near(block) ||
         std::any_of(present_.begin(), present_.end(), [&](const Present& p) { return reaches(p, block, reach + touching()); });
}

NodeBits Contacts::nodes_touched(const BlockIndex& block) const {
  if (face_near(block)) return k_all_nodes;
  NodeBits nodes = 0;
  for (const Present& p : present_) {
    if (p.stands)
      nodes |= p.contact->survey.near(geometry_.linear(block));
    else if (reaches(p, block, reach_beside_colliders()))
      nodes = k_all_nodes;
  }
  return nodes;
}

bool Contacts::collider_near(const BlockIndex& block, double reach) const {
  return std::any_of(present_.begin(), present_.end(),
                     [&](const Present& p) { return p.contact->rule != Rule::grip && reaches(p, block, reach + touching()); });
}

bool Contacts::expels_near(const BlockIndex& block, double reach) const {
  return expels_ && std::any_of(present_.begin(), present_.end(),
                                [&](const Present& p) { return p.contact->expels && reaches(p, block, reach + touching()); });
}

bool Contacts::holds_temperature(const Point& x) const {
  return std::any_of(present_.begin(), present_.end(),
                     [&](const Present& p) { return p.contact->holds_temperature() && p.contact->scripted.distance(p.pose, x) <= 0; });
}

bool Contacts::holds_temperature_near(const BlockIndex& block, double reach) const {
  return holds_now_ && std::any_of(present_.begin(), present_.end(), [&](const Present& p) {
           return p.contact->holds_temperature() && reaches(p, block, reach + touching());
         });
}

bool Contacts::reaches(const Present& p, const BlockIndex& block, double reach) const {
  if (p.stands && reach <= Survey::k_reach * geometry_.dx() && p.contact->survey.is_far(geometry_.linear(block))) return false;
  const Point low = geometry_.origin(block);
  const double side = 3 * geometry_.dx();
  for (std::size_t d = 0; d < 3; ++d)
    if (low[d] > p.bounds.high[d] + reach || low[d] + side < p.bounds.low[d] - reach) return false;
  const auto kept = p.stands ? p.contact->survey.distance_of_middle(geometry_.linear(block)) : std::nullopt;
  return (kept ? *kept : p.contact->scripted.distance(p.pose, middle_of(block, geometry_))) <= 0.87 * side + reach;
}

std::optional<double> Contacts::distance_within(const Present& p, const Place& at, double reach) {
  if (!is_within(p.bounds, at.x, reach)) return std::nullopt;  // first what costs little
  const auto kept = p.stands ? p.contact->survey.distance(at) : std::nullopt;
  const double distance = kept ? *kept : p.contact->scripted.distance(p.pose, at.x);
  return distance <= reach ? std::optional(distance) : std::nullopt;
}

Vector3 Contacts::velocity_beside(const Present& p, const Point& x, const Vector3& v, const Column* column, const Vector3& line) {
  const Vector3 wall = p.pose.velocity_at(x) + line;
  const Rule rule = p.contact->rule;
  if (rule == Rule::sticky || rule == Rule::grip) return wall;
  const bool separating = rule == Rule::separating;
  const Vector3 n = column ? column->normal : p.contact->scripted.normal(p.pose, x);
  return wall + contact(v - wall, n, false, separating, separating ? p.contact->friction : 0);
}

bool Contacts::push_out(Point& x, Vector3& v, double mass, Given* given) const {
  bool inside = false;
  for (const Present& p : present_) {
    if (!p.contact->expels) continue;
    const double distance = p.contact->scripted.distance(p.pose, x);
    if (distance >= 0) continue;
    inside = true;
    const Vector3 before = v;
    v = velocity_beside(p, x, v);
    if (given && p.contact->giver >= 0) given[p.contact->giver].impulse = given[p.contact->giver].impulse + mass * (v - before);
    // at most one node distance, so that it does not leave the block's reach in one step
    x = x + std::min(-distance, geometry_.dx()) * p.contact->scripted.normal(p.pose, x);
  }
  return inside;
}

std::optional<Vector3> Contacts::line(const Present& p, const Point& x, const Column& column, const NodesAround& around) const {
  const auto node = [&](int j) { return around.at(column.axis, j * column.outward); };
  if (column.free < 0) return std::nullopt;
  const NodeState free = node(column.free);
  if (!(free.mass > 0)) return std::nullopt;
  // what dough would leave of the column if it filled it, less what there is, in units of the mass of the free node
  double gap = 0;
  for (int i = 0; i < column.count; ++i)
    gap += column.filled[static_cast<std::size_t>(i)] - node(column.free - 1 - i).mass / free.mass * column.free_filled;
  constexpr double k_touching = 0.1, k_too_much = -0.55;  // of a node distance; more than fits: the free node is not within the dough
  if (!(gap < k_touching && gap > k_too_much)) return std::nullopt;
  Point place = x;
  place[static_cast<std::size_t>(column.axis)] += column.free * column.outward * geometry_.dx();
  return column.share * (free.velocity - p.pose.velocity_at(place));
}

template <bool tells>
Vector3 Contacts::after_all(const Place& at, Vector3 v, const NodesAround* around, [[maybe_unused]] double mass,
                            [[maybe_unused]] Given* given) const {
  [[maybe_unused]] const auto tell = [&](int giver, const Vector3& before) {
    if (giver >= 0) given[giver].impulse = given[giver].impulse + mass * (v - before);
  };
  for (const Present& p : present_) {
    const bool between_nodes = around && p.contact->has_columns();
    const auto d = distance_within(p, at, between_nodes ? (1 - 1e-6) * geometry_.dx() : touching());
    if (!d) continue;
    const Column* column = p.stands ? p.contact->survey.column(at) : nullptr;
    std::optional<Column> found;
    if (between_nodes && !column) column = &found.emplace(find_column(p.contact->scripted, p.pose, at.x, *d, geometry_.dx()));
    [[maybe_unused]] const Vector3 before = v;
    if (const auto on_line = between_nodes ? line(p, at.x, *column, *around) : std::nullopt)
      v = velocity_beside(p, at.x, v, column, *on_line);
    else if (*d <= touching())
      v = velocity_beside(p, at.x, v, column);
    if constexpr (tells) tell(p.contact->giver, before);
  }
  for (const FaceOfDomain& f : faces_) {
    if (f.distance(at.x) > touching()) continue;
    Vector3 n{0, 0, 0};
    n[static_cast<std::size_t>(f.axis)] = f.sign;
    [[maybe_unused]] const Vector3 before = v;
    v = contact(v, n, f.rule == Rule::sticky, f.rule == Rule::separating, f.rule == Rule::separating ? face_friction_ : 0);
    if constexpr (tells) tell(f.giver, before);
  }
  return v;
}
template Vector3 Contacts::after_all<false>(const Place&, Vector3, const NodesAround*, double, Given*) const;
template Vector3 Contacts::after_all<true>(const Place&, Vector3, const NodesAround*, double, Given*) const;

ContactHeat Contacts::heat_of(const Present& p) {
  if (!p.contact->temperature) return {};
  return {p.contact->heat_transfer_coefficient, p.temperature, 0, p.contact->giver};
}

std::optional<ContactHeat> Contacts::cover_within(const Place& at, double reach) const {
  for (const Present& p : present_)
    if (p.contact->covers && distance_within(p, at, reach)) return heat_of(p);
  for (const Wall& w : walls_)
    if (w.distance(at.x) <= reach) return w.heat;
  return std::nullopt;
}

Covers Contacts::covering(const Place& at, const Vector3& n, double reach) const {
  constexpr double k_ahead = 0.5, k_beside = 0.2;  // of `facing`: one must be ahead, the others count from much less on
  Covers found;
  bool any = false;
  const auto add = [&](const ContactHeat& heat, const Vector3& normal, double facing) {
    if (facing < k_beside || found.count == Covers::k_most) return;
    any |= facing >= k_ahead;
    found.solids[static_cast<std::size_t>(found.count++)] = {heat, normal, facing};
  };
  for (const Present& p : present_) {
    const auto d = p.contact->covers ? distance_within(p, at, reach) : std::nullopt;
    if (!d) continue;
    const Vector3* kept = p.stands ? p.contact->survey.normal(at) : nullptr;
    const Vector3 normal = kept ? *kept : p.contact->scripted.normal(p.pose, at.x);
    double facing = -dot(normal, n);
    if (facing < k_ahead) facing = std::max(facing, (*d - p.contact->scripted.distance(p.pose, at.x + reach * n)) / reach);
    add(heat_of(p), normal, facing);
  }
  for (const Wall& w : walls_) {
    if (w.distance(at.x) > reach) continue;
    Vector3 normal{0, 0, 0};
    normal[static_cast<std::size_t>(w.axis)] = w.sign;
    add(w.heat, normal, -dot(normal, n));
  }
  if (!any) found.count = 0;  // the surface looks elsewhere
  if (found.count < 2) return found;
  for (int s = 0; s < found.count; ++s) {
    Covers::Solid& solid = found.solids[static_cast<std::size_t>(s)];
    double alike = 0;
    for (const Covers::Solid& other : found) alike += std::max(dot(solid.normal, other.normal), 0.);
    solid.share = solid.facing / alike;
  }
  return found;
}

double Contacts::room(const Place& at) const {
  const auto left_at = [&](double distance) { return share_left(distance / geometry_.dx()); };
  double room = 1;
  for (const Present& p : present_) {
    if (!p.contact->covers || (p.stands && p.contact->survey.is_far(at))) continue;
    if (const auto kept = p.stands ? p.contact->survey.share_left(at) : std::nullopt)
      room *= *kept;
    else if (const auto distance = distance_within(p, at, Survey::k_reach * geometry_.dx()))
      room *= left_at(*distance);
  }
  for (const Wall& w : walls_) room *= left_at(w.distance(at.x));
  return room;
}

std::optional<HeldNear> Contacts::held_near(const Place& at, double reach) const {
  std::optional<HeldNear> nearest;
  for (const Present& p : present_) {
    if (!p.contact->holds_temperature()) continue;
    const auto distance = distance_within(p, at, reach + touching());
    if (distance && (!nearest || *distance < nearest->distance)) nearest = {p.temperature, *distance};
  }
  return nearest;
}

double Contacts::next_event(double time) const {
  double next = k_infinity;
  for (const Contacting& c : all_)
    for (const double t : {c.scripted.from_s, c.scripted.until_s})
      if (t > time) next = std::min(next, t);
  return next;
}

std::size_t Contacts::bytes() const {
  std::size_t bytes = 0;
  for (const Contacting& c : all_) bytes += c.survey.bytes();
  return bytes;
}

}  // namespace bake

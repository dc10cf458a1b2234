// SPDX-License-Identifier: MIT
// The grid update: from what particles scattered to what they will gather, and its books.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "solver/core/elementary.h"
#include "solver/core/parallel.h"
#include "solver/core/rows.h"
#include "solver/core/vector3.h"
#include "solver/effects/fields.h"
#include "solver/engine/engine.h"

namespace bake {

namespace {

void book_impulse(const Point& x, const Vector3& impulse, Budget& booked) {
  const Vector3 angular_impulse = cross(x, impulse);
  for (std::size_t d = 0; d < 3; ++d) {
    booked[k_impulse_entry + d] += impulse[d];
    booked[k_angular_impulse_entry + d] += angular_impulse[d];
  }
}

template <class Real>
struct NodeCoordinates {
  alignas(64) Real along[3][k_block_nodes];
  constexpr NodeCoordinates() : along() {
    for (int n = 0; n < k_block_nodes; ++n)
      for (std::size_t d = 0; d < 3; ++d) along[d][n] = static_cast<Real>(coordinates_in_block(n)[d]);
  }
};
template <class Real>
constexpr NodeCoordinates<Real> k_coordinates;

/// Impulses on the nodes of a block, and their angular impulse about its first node.
template <class Real>
struct Impulses {
  using V = Lanes<Real>;
  V sum[3] = {}, angular[3] = {};  ///< [kg m/s]; the angular impulse per node distance
  /// Of the nodes `first`, `first` + 1, ...
  BAKE_INLINE void add(int first, const V (&impulse)[3]) {
    for (int d = 0; d < 3; ++d) {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      const V &x_e = *reinterpret_cast<const V*>(k_coordinates<Real>.along[e] + first),
              &x_f = *reinterpret_cast<const V*>(k_coordinates<Real>.along[f] + first);
      sum[d] += impulse[d];
      angular[d] += x_e * impulse[f] - x_f * impulse[e];
    }
  }
  void book(const Point& origin, double dx, Budget& booked) const {
    const Vector3 total{sum_lanes(sum[0]), sum_lanes(sum[1]), sum_lanes(sum[2])};
    book_impulse(origin, total, booked);
    for (std::size_t d = 0; d < 3; ++d) booked[k_angular_impulse_entry + d] += dx * sum_lanes(angular[d]);
  }
};

template <class Real>
double sum_over_block(const Real* nodes) {
  Lanes<Real> sum{};
  for (int n = 0; n < k_block_nodes; n += k_width<Real>) sum += *reinterpret_cast<const Lanes<Real>*>(nodes + n);
  return sum_lanes(sum);
}

}  // namespace

template <class Real>
void Engine<Real>::update_grid() {
  const Step<Real> step = current_step();
  active_.find_touched(store_.blocks);
  contacts_.survey(active_);
  look_for_crumbs();
  Air air;
  if (physics_->needs_surface) {
    const auto now = [&](const Curve& curve) { return curve.mean(time_, time_ + baking_dt()); };
    air = {now(scene_.oven.heat_transfer_coefficient_W_per_m2K), now(scene_.oven.temperature_C), now(scene_.oven.equilibrium_saturation)};
    if (scene_.surface.form == Form::standard)
      measure_surface();
    else
      measure_published_surface(air);
  }
  const std::size_t blocks = active_.at.size(), nodes = blocks * k_block_nodes;
  gathered_.resize_and_forget(nodes * static_cast<std::size_t>(gathered_row()));
  const bool implicit = physics_->implicit_heat;
  if (implicit) heat_weight_.assign(nodes, Real(0)), heat_transfer_.assign(nodes, Real(0));
  block_budgets_.resize(blocks);
  if (!given_.empty()) block_given_.assign(blocks * given_.size(), {});
  contact_of_.assign(blocks, ContactOf::own);
  const bool keeps_sums = (physics_->moves && contacts_.has_colliders()) || (implicit && physics_->moves_mass);
  if (keeps_sums) sums_.resize(blocks * k_packs<Real>);
  for_each_parallel(blocks, 16, [&](std::size_t s) {
    block_budgets_[s] = {};
    if (active_.touched[s]) update_block(s, air, step, block_budgets_[s]);
  });
  touch_colliders();
  const auto taken_up = [&](double transfer, double source, double theta, double change) {
    return physics_->printed_heat_transfer ? transfer * (theta - change) - source : source - transfer * theta;
  };
  if (implicit) {
    // conduction changes theta and with it what the surroundings give
    tell_heat([&](double transfer, double source, double theta, double change) {
      return taken_up(transfer, source, theta, change) + transfer * theta;
    });
    booked_[static_cast<std::size_t>(physics_->heat_entry)] +=
        implicit_heat_.solve(work(step), colours_.columns(), heat_weight_, heat_transfer_, baking_dt(),
                             static_cast<std::size_t>(gathered_row()), gathered_.data());
    if (physics_->moves_mass)
      for (std::size_t s = 0; s < blocks; ++s)
        if (active_.touched[s])
          book_moved_heat(
              &sums_[s * k_packs<Real>], [&](int pack) { return temperatures(s, pack); }, block_budgets_[s]);
  }
  booked_[k_area_entry] = booked_[k_contact_area_entry] = 0;  // of this step, not a sum
  for (const Budget& b : block_budgets_) add_to(booked_, b);
  tell_heat([&](double transfer, double source, double theta, double change) {
    return implicit ? -transfer * theta : taken_up(transfer, source, theta, change);
  });
  if (!given_.empty()) sum_given(block_given_);
  if (skins_) book_weight_of_skins();
}

/// Anew only where it may have changed: dough that moves a hundredth of a cell a step has the same surface for several.
template <class Real>
void Engine<Real>::measure_surface() {
  const typename FreeSurfaceMeasure<Real>::Rows rows{scattered_.data(), scattered_row(), physics_->volume_channel,
                                                     physics_->conductivity_channel};
  if (surface_travel_ <= scene_.surface.keep_dx && surface_covers_ == contacts_.covers()) return surface_.follow(rows, active_);
  surface_.measure(rows, physics_->surface_layer, physics_->surface_rounding, active_, geometry_, contacts_);
  surface_travel_ = 0;
  surface_covers_ = contacts_.covers();
  if (keeps_surface()) surface_volumes_ = surface_.volumes();
}

/// From scattered to gathered rows. A block found empty is no longer `touched`.
template <class Real>
void Engine<Real>::update_block(std::size_t s, const Air& air, const Step<Real>& step, Budget& booked) {
  constexpr int W = k_width<Real>;
  const auto RS = static_cast<std::size_t>(scattered_row()), RG = static_cast<std::size_t>(gathered_row());
  Real* from = scattered_.data() + s * k_block_nodes * RS;
  Real* rows = gathered_.data() + s * k_block_nodes * RG;
  if (is_empty(from)) {
    std::memset(rows, 0, k_block_nodes * RG * sizeof(Real));
    std::memset(from, 0, k_block_nodes * RS * sizeof(Real));
    active_.touched[s] = 0;
    return;
  }
  const bool at_contact = (physics_->moves || contacts_.holds_temperatures()) &&
                          contacts_.near(active_.at[s], contacts_.holds_temperatures() ? 1.5 * geometry_.dx() : 0);
  BlockSurroundings<Real> surface;
  const bool has_surface = physics_->needs_surface && surface_.surround(s, air, surface);
  Lanes<Real> in[k_most_channels], dv[3];
  find_fall(dv);
  Lanes<Real> out[k_packs<Real>][k_most_channels];
  NodeSums<Real> sums[k_packs<Real>];
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    const std::size_t n = static_cast<std::size_t>(pack) * W;
    prefetch_rows(from + (k_block_nodes + n) * RS, W * RS);  // of the next block
    kernel_->take_nodes(from + n * RS, in);
    Surroundings<Real> around = surroundings(pack, has_surface ? &surface : nullptr, air);
    if (at_contact && contacts_.holds_temperatures()) hold_temperatures(s, static_cast<int>(n), in, around);
    physics_->update_nodes(in, out[pack], sums[pack], around, step, booked);
    for (int c = physics_->gather_channels; c < gathered_row(); ++c) out[pack][c] = Lanes<Real>{};
    if (physics_->moves)
      for (int d = 0; d < 3; ++d) out[pack][d] += sums[pack].inertia > 0 ? dv[d] : 0 * dv[d];
    if (physics_->implicit_heat) {
      const std::size_t node = s * k_block_nodes + n;
      std::memcpy(&heat_weight_[node], &sums[pack].heat_weight, sizeof(Lanes<Real>));
      std::memcpy(&heat_transfer_[node], &around.heat_transfer, sizeof(Lanes<Real>));
    }
  }
  if (force_)
    change_velocities(s, sums, out, booked, k_all_nodes, [&](int, const Point& x, const Vector3& v) { return force_(x, v, time_, dt_); });
  if (settling_.now) damp(s, sums, out, booked);
  const bool beside_collider = physics_->moves && contacts_.collider_near(active_.at[s], contacts_.reach_beside_colliders());
  const NodeBits may_touch = physics_->moves && (at_contact || beside_collider) ? contacts_.nodes_touched(active_.at[s]) : 0;
  contact_of_[s] = !beside_collider ? ContactOf::own : may_touch ? ContactOf::later : ContactOf::asked;
  if (!beside_collider)
    change_velocities(s, sums, out, booked, may_touch,
                      [&](int n, const Point&, const Vector3& v) { return touched(s, n, sums, v, nullptr); });
  for (std::size_t pack = 0; pack < k_packs<Real>; ++pack) kernel_->put_nodes(out[pack], rows + pack * W * RG);
  if (physics_->moves && contact_of_[s] != ContactOf::later) book_momentum(s, sums, out, dv, booked);
  if (beside_collider || (physics_->implicit_heat && physics_->moves_mass))
    std::copy(sums, sums + k_packs<Real>, &sums_[s * k_packs<Real>]);
  if (physics_->temperature_channel >= 0 && physics_->moves_mass && !physics_->implicit_heat)
    book_moved_heat(
        sums, [&](int pack) { return out[pack][physics_->temperature_channel]; }, booked);
  if (has_surface) {
    booked[k_area_entry] += sum_over_block(surface.area);
    booked[k_contact_area_entry] += sum_over_block(surface.contact_area);
  }
}

/// The velocity of a node after contact. What its givers gave is noted, if the ledger wants to know.
template <class Real>
Vector3 Engine<Real>::touched(std::size_t slot, int node, const NodeSums<Real>* sums, const Vector3& v, const NodesAround* around) {
  const Place at(geometry_, active_.at[slot], node);
  if (given_.empty()) return contacts_.velocity_after(at, v, around);
  const Real mass = sums[node / k_width<Real>].inertia[node % k_width<Real>];
  return contacts_.velocity_after(at, v, around, static_cast<double>(mass), given_in(slot));
}

/// Heat of the givers: power(transfer, its source, theta, its change in this step) [W] at each node before them. Where a grip holds the
/// temperature, all heat is the grip's.
template <class Real>
template <class Power>
void Engine<Real>::tell_heat(Power power) {
  if (given_.empty() || settling_.now || physics_->temperature_channel < 0 || !physics_->needs_surface) return;
  const auto RG = static_cast<std::size_t>(gathered_row());
  for_each_parallel(active_.at.size(), 16, [&](std::size_t s) {
    if (!active_.touched[s]) return;
    const Real* rows = gathered_.data() + s * k_block_nodes * RG + physics_->temperature_channel;
    surface_.tell(s, active_, [&](int giver, int node, double transfer, double source) {
      if (is_held(s, node)) return;
      const Real* theta = rows + static_cast<std::size_t>(node) * RG;
      given_in(s)[giver].heat += dt_ * power(transfer, source, static_cast<double>(theta[0]), static_cast<double>(theta[-1]));
    });
  });
}

/// What gravity adds to velocities.
template <class Real>
void Engine<Real>::find_fall(Lanes<Real> (&dv)[3]) const {
  const Vector3 g = gravity_from(time_);
  for (std::size_t d = 0; d < 3; ++d) dv[d] = lanes<Real>(static_cast<Real>(dt_ * g[d] / physics_->inertia_scale));
}

/// While the dough settles, velocities decay. What that takes is booked.
template <class Real>
void Engine<Real>::damp(std::size_t slot, const NodeSums<Real>* sums, Lanes<Real> (*nodes)[k_most_channels], Budget& booked) const {
  using V = Lanes<Real>;
  const auto kept = static_cast<Real>(elementary::exp(-physics_->settling.damping * dt_));
  Impulses<Real> impulses;
  V taken{};
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    V impulse[3];
    for (int d = 0; d < 3; ++d) {
      const V before = nodes[pack][d], after = kept * before;
      nodes[pack][d] = after;
      impulse[d] = sums[pack].inertia * (after - before);
      taken += Real(0.5) * sums[pack].inertia * (before * before - after * after);
    }
    impulses.add(pack * k_width<Real>, impulse);
  }
  impulses.book(geometry_.origin(active_.at[slot]), geometry_.dx(), booked);
  booked[static_cast<std::size_t>(physics_->settling.damped_entry)] += sum_lanes(taken);
}

/// The nodes around one of a block beside a collider, before contact.
template <class Real>
class Engine<Real>::Around final : public NodesAround {
 public:
  Around(const Engine& engine, std::size_t slot, int node) : engine_(engine), block_(engine.active_.at[slot]), node_(node) {}
  NodeState at(int axis, int steps) const override {
    auto c = coordinates_in_block(node_);
    BlockIndex block = block_;
    int* const b[3] = {&block.x, &block.y, &block.z};
    const int along = c[static_cast<std::size_t>(axis)] + steps;
    *b[axis] += along >> 2;
    c[static_cast<std::size_t>(axis)] = along & 3;
    const std::int32_t found = engine_.active_.slot_at(block, engine_.geometry_);
    if (found < 0 || engine_.contact_of_[static_cast<std::size_t>(found)] == ContactOf::own) return {};
    const auto slot = static_cast<std::size_t>(found);
    const int node = node_in_block(c[0], c[1], c[2]);
    const Real* v = engine_.gathered_.data() +
                    (slot * k_block_nodes + static_cast<std::size_t>(node)) * static_cast<std::size_t>(engine_.gathered_row());
    const NodeSums<Real>& sums = engine_.sums_[slot * k_packs<Real> + static_cast<std::size_t>(node / k_width<Real>)];
    return {double(sums.inertia[node % k_width<Real>]), {double(v[0]), double(v[1]), double(v[2])}};
  }

 private:
  const Engine& engine_;
  BlockIndex block_;
  int node_;
};

/// Contact of the blocks at colliders: all velocities after it depend on those before it only.
template <class Real>
void Engine<Real>::touch_colliders() {
  constexpr std::size_t W = k_width<Real>;
  const auto RG = static_cast<std::size_t>(gathered_row());
  std::vector<std::size_t> slots;
  for (std::size_t s = 0; s < contact_of_.size(); ++s)
    if (contact_of_[s] == ContactOf::later) slots.push_back(s);
  if (slots.empty()) return;
  std::vector<std::array<Real, 3 * k_block_nodes>> after(slots.size());
  const auto rows_of = [&](std::size_t s) { return gathered_.data() + s * k_block_nodes * RG; };
  for_each_parallel(slots.size(), 4, [&](std::size_t i) {
    const std::size_t s = slots[i];
    Lanes<Real> nodes[k_packs<Real>][k_most_channels], dv[3];
    for (std::size_t n = 0; n < k_block_nodes; ++n)
      for (std::size_t d = 0; d < 3; ++d) nodes[n / W][d][n % W] = rows_of(s)[n * RG + d];
    const NodeSums<Real>* sums = &sums_[s * k_packs<Real>];
    change_velocities(s, sums, nodes, block_budgets_[s], contacts_.nodes_touched(active_.at[s]),
                      [&](int n, const Point&, const Vector3& v) {
                        const Around around(*this, s, n);
                        return touched(s, n, sums, v, &around);
                      });
    find_fall(dv);
    book_momentum(s, sums, nodes, dv, block_budgets_[s]);
    for (std::size_t n = 0; n < k_block_nodes; ++n)
      for (std::size_t d = 0; d < 3; ++d) after[i][3 * n + d] = nodes[n / W][d][n % W];
  });
  for_each_parallel(slots.size(), 16, [&](std::size_t i) {
    for (std::size_t n = 0; n < k_block_nodes; ++n)
      for (std::size_t d = 0; d < 3; ++d) rows_of(slots[i])[n * RG + d] = after[i][3 * n + d];
  });
}

template <class Real>
bool Engine<Real>::is_empty(const Real* scattered) const {
  const auto RS = static_cast<std::size_t>(scattered_row()), filled = static_cast<std::size_t>(physics_->filled_channel);
  for (std::size_t n = 0; n < k_block_nodes; ++n)
    if (scattered[n * RS + filled] != 0) return false;
  return true;
}

/// `surface`: of the block, null where there is none.
template <class Real>
Surroundings<Real> Engine<Real>::surroundings(int pack, const BlockSurroundings<Real>* surface, const Air& air) {
  const int first = pack * k_width<Real>;
  Surroundings<Real> around{};
  around.saturation = lanes<Real>(static_cast<Real>(air.saturation));
  if (surface) {
    around.area = *reinterpret_cast<const Lanes<Real>*>(surface->area + first);
    around.heat_transfer = *reinterpret_cast<const Lanes<Real>*>(surface->heat_transfer + first);
    around.heat_transfer_source = *reinterpret_cast<const Lanes<Real>*>(surface->heat_transfer_source + first);
  }
  return around;
}

/// A grip holds the temperature of nodes in it. Were that all, the face would seem to lie where the first of them is, up to dx further out,
/// and d_0 = 0.11 dx (cubic: 0.15) more, since particles between it and the next node see its temperature and not the line continued (by
/// measurement, for faces through nodes; 0.05 dx less on others). The next node, s dx outside of the grip, would be heated by
/// kappa V_i / dx^2, as if through dx; for a face where the grip's is, that must be 1 / (s - d_0), so that (1 + d_0 - s) / (s - d_0) is
/// added.
template <class Real>
double Engine<Real>::face_beyond_grip() const {
  return physics_->conductivity_channel < 0 ? 0 : scene_.grid.kernel == KernelOrder::quadratic ? 0.11 : 0.15;
}

/// Does a grip hold the node's temperature?
template <class Real>
bool Engine<Real>::is_held(std::size_t slot, int node) const {
  if (!contacts_.holds_temperatures()) return false;
  const double reach = (face_beyond_grip() + 1e-6) * geometry_.dx();
  const auto held = contacts_.held_near(Place(geometry_, active_.at[slot], node), reach);
  return held && held->distance <= reach;
}

template <class Real>
void Engine<Real>::hold_temperatures(std::size_t slot, int first, const Lanes<Real>* scattered, Surroundings<Real>& around) const {
  const bool conducts = physics_->conductivity_channel >= 0;
  const double dx = geometry_.dx(), d_0 = face_beyond_grip();
  for (int l = 0; l < k_width<Real>; ++l) {
    const auto held = contacts_.held_near(Place(geometry_, active_.at[slot], first + l), conducts ? (1 + d_0) * dx : 0);
    if (!held) continue;
    const double s = held->distance / dx;
    if (s <= d_0 + 1e-6) {
      around.is_held[l] = -1;
      around.held[l] = static_cast<Real>(held->temperature);
      continue;
    }
    const double conductance = static_cast<double>(scattered[physics_->conductivity_channel][l]) / (dx * dx) * (1 + d_0 - s) / (s - d_0);
    around.heat_transfer[l] += static_cast<Real>(conductance);
    around.heat_transfer_source[l] += static_cast<Real>(conductance * held->temperature);
  }
}

/// What gravity gives, what mass takes along that leaves the nodes, and what moves between nodes against what moves between particles
/// (which the effect books). With the step's final velocities.
template <class Real>
void Engine<Real>::book_momentum(std::size_t slot, const NodeSums<Real>* sums, const Lanes<Real> (*nodes)[k_most_channels],
                                 const Lanes<Real> (&dv)[3], Budget& booked) const {
  using V = Lanes<Real>;
  Impulses<Real> impulses;
  V moved[3] = {};
  const auto inertia = static_cast<Real>(physics_->inertia_scale);
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    V impulse[3];
    for (int d = 0; d < 3; ++d) {
      impulse[d] = sums[pack].inertia * dv[d] - inertia * sums[pack].evaporated * nodes[pack][d];
      moved[d] += sums[pack].moved * nodes[pack][d];
    }
    impulses.add(pack * k_width<Real>, impulse);
  }
  impulses.book(geometry_.origin(active_.at[slot]), geometry_.dx(), booked);
  if (!physics_->moves_mass) return;
  for (std::size_t d = 0; d < 3; ++d)
    booked[static_cast<std::size_t>(physics_->moved_momentum_entry) + d] -= physics_->inertia_scale * sum_lanes(moved[d]);
}

/// The same of heat, with the step's final temperatures: theta(pack) are those of W nodes.
template <class Real>
template <class Theta>
void Engine<Real>::book_moved_heat(const NodeSums<Real>* sums, Theta theta, Budget& booked) const {
  Lanes<Real> moved{}, vapour{};  // [kg C]
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    moved += sums[pack].moved * theta(pack);
    vapour += sums[pack].evaporated * theta(pack);
  }
  booked[static_cast<std::size_t>(physics_->left_heat_entry)] += physics_->moved_specific_heat * sum_lanes(vapour);
  booked[static_cast<std::size_t>(physics_->moved_heat_entry)] -= physics_->moved_specific_heat * sum_lanes(moved);
}

template <class Real>
void Engine<Real>::measure_published_surface(const Air& air) {
  const auto measure = [&]<KernelOrder order>() {
    surface_.template measure_published<order>(store_, scattered_.data(), scattered_row(), physics_->volume_channel,
                                               physics_->column_of(field::VolumeRatio::name),
                                               physics_->column_of(field::InitialVolume::name), active_, geometry_, contacts_, air);
  };
  if (scene_.grid.kernel == KernelOrder::quadratic)
    measure.template operator()<KernelOrder::quadratic>();
  else
    measure.template operator()<KernelOrder::cubic>();
}

/// Those of W nodes, read from the gathered rows.
template <class Real>
Lanes<Real> Engine<Real>::temperatures(std::size_t slot, int pack) const {
  const auto RG = static_cast<std::size_t>(gathered_row());
  const Real* theta = gathered_.data() + (slot * k_block_nodes + static_cast<std::size_t>(pack * k_width<Real>)) * RG;
  Lanes<Real> result;
  for (int l = 0; l < k_width<Real>; ++l)
    result[l] = theta[static_cast<std::size_t>(l) * RG + static_cast<std::size_t>(physics_->temperature_channel)];
  return result;
}

/// Those of the nodes that have mass get the velocity `after`(number, place, velocity); the impulse is booked.
template <class Real>
template <class After>
void Engine<Real>::change_velocities(std::size_t slot, const NodeSums<Real>* sums, Lanes<Real> (*nodes)[k_most_channels], Budget& booked,
                                     NodeBits which, After after) const {
  const Point origin = geometry_.origin(active_.at[slot]);
  for (; which != 0; which &= which - 1) {
    const int n = std::countr_zero(which);
    const int pack = n / k_width<Real>, lane = n % k_width<Real>;
    const Real mass = sums[pack].inertia[lane];
    if (!(mass > 0)) continue;
    Lanes<Real>* v_i = nodes[pack];
    const Vector3 v{double(v_i[0][lane]), double(v_i[1][lane]), double(v_i[2][lane])};
    const Point x = node_position(origin, geometry_.dx(), n);
    const Vector3 changed = after(n, x, v);
    if (changed == v) continue;
    for (std::size_t d = 0; d < 3; ++d) v_i[d][lane] = static_cast<Real>(changed[d]);
    book_impulse(x, double(mass) * (changed - v), booked);
  }
}

// All of them: the extern template of the class keeps a compiler from making one where it is called.
#define BAKE_INSTANTIATE(Real)                                                                                          \
  template void Engine<Real>::update_grid();                                                                            \
  template void Engine<Real>::measure_surface();                                                                        \
  template void Engine<Real>::update_block(std::size_t, const Air&, const Step<Real>&, Budget&);                        \
  template void Engine<Real>::touch_colliders();                                                                        \
  template void Engine<Real>::find_fall(Lanes<Real>(&)[3]) const;                                                       \
  template void Engine<Real>::damp(std::size_t, const NodeSums<Real>*, Lanes<Real>(*)[k_most_channels], Budget&) const; \
  template Vector3 Engine<Real>::touched(std::size_t, int, const NodeSums<Real>*, const Vector3&, const NodesAround*);  \
  template double Engine<Real>::face_beyond_grip() const;                                                               \
  template bool Engine<Real>::is_held(std::size_t, int) const;                                                          \
  template bool Engine<Real>::is_empty(const Real*) const;                                                              \
  template Surroundings<Real> Engine<Real>::surroundings(int, const BlockSurroundings<Real>*, const Air&);              \
  template void Engine<Real>::hold_temperatures(std::size_t, int, const Lanes<Real>*, Surroundings<Real>&) const;       \
  template void Engine<Real>::book_momentum(std::size_t, const NodeSums<Real>*, const Lanes<Real>(*)[k_most_channels],  \
                                            const Lanes<Real>(&)[3], Budget&) const;                                    \
  template void Engine<Real>::measure_published_surface(const Air&);                                                    \
  template Lanes<Real> Engine<Real>::temperatures(std::size_t, int) const;
BAKE_INSTANTIATE(float)
BAKE_INSTANTIATE(double)
#undef BAKE_INSTANTIATE

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/baker/engine.h"

#include <fmt/format.h>
#include <omp.h>

#include <cstring>

#include "solver/boundary/vector3.h"
#include "solver/core/parallel.h"
#include "solver/core/rows.h"
#include "solver/effects/heat.h"
#include "solver/effects/motion.h"
#include "solver/effects/water.h"
#include "solver/io/progress.h"
#include "solver/particles/fields.h"

namespace bake {

namespace {

void add_to(Bookings& sum, const Bookings& part) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
}

void book_impulse(const Point& x, const Vector3& impulse, Bookings& booked) {
  const Vector3 twist = cross(x, impulse);
  for (std::size_t d = 0; d < 3; ++d) {
    booked[static_cast<std::size_t>(Entry::impulse_x) + d] += impulse[d];
    booked[static_cast<std::size_t>(Entry::twist_x) + d] += twist[d];
  }
}

template <class Real>
struct NodeCoordinates {
  alignas(64) Real along[3][k_block_nodes];
  constexpr NodeCoordinates() : along() {
    for (int n = 0; n < k_block_nodes; ++n)
      along[0][n] = static_cast<Real>(n / 16), along[1][n] = static_cast<Real>(n / 4 % 4), along[2][n] = static_cast<Real>(n % 4);
  }
};
template <class Real>
constexpr NodeCoordinates<Real> k_coordinates;

/// Impulses on the nodes of a block, and their twist about its first node.
template <class Real>
struct Impulses {
  using V = Lanes<Real>;
  V sum[3] = {}, twist[3] = {};  ///< [kg m/s]; the twist per node distance
  /// Of the nodes `first`, `first` + 1, ...
  BAKE_INLINE void add(int first, const V (&impulse)[3]) {
    for (int d = 0; d < 3; ++d) {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      const V &x_e = *reinterpret_cast<const V*>(k_coordinates<Real>.along[e] + first),
              &x_f = *reinterpret_cast<const V*>(k_coordinates<Real>.along[f] + first);
      sum[d] += impulse[d];
      twist[d] += x_e * impulse[f] - x_f * impulse[e];
    }
  }
  void book(const Point& origin, double dx, Bookings& booked) const {
    const Vector3 total{sum_lanes(sum[0]), sum_lanes(sum[1]), sum_lanes(sum[2])};
    book_impulse(origin, total, booked);
    for (int d = 0; d < 3; ++d) booked[static_cast<std::size_t>(static_cast<int>(Entry::twist_x) + d)] += dx * sum_lanes(twist[d]);
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
Engine<Real>::Engine(const Scene& scene)
    : scene_(scene),
      gravity_(scene.of<Motion>().gravity_m_per_s2),
      inertia_scale_(scene.of<Motion>().inertia_scale),
      water_specific_heat_(scene.of<Heat>().water_specific_heat_J_per_kgK),
      lattice_(scene.domain, scene.dx()),
      physics_(make_physics<Real>(scene)),
      kernel_(make_block_kernel<Real>(scene.grid.kernel, *physics_)),
      contacts_(scene, lattice_),
      limits_(scene),
      scratch_(static_cast<std::size_t>(omp_get_max_threads())) {
  store_.columns = spare_.columns = physics_->column_count;
  const auto nonzero = [](const Curve& curve) {
    return std::any_of(curve.points.begin(), curve.points.end(), [](const Curve::Point& p) { return p.value != 0; });
  };
  bool exchanges = nonzero(scene.oven.exchange_W_per_m2K);
  for (const Collider& c : scene.colliders) exchanges |= c.exchange_W_per_m2K != 0;
  bool evaporates = false;
  for (const Material& m : scene.materials) evaporates |= of<Water>(m).evaporation_kg_per_m2sK != 0;
  has_surface_ = (physics_->has_heat && exchanges) || (physics_->has_water && evaporates);
}

template <class Real>
Step<Real> Engine<Real>::current_step() const {
  const double dx = lattice_.dx();
  const double inverse_d = scene_.grid.kernel == KernelOrder::quadratic ? 4 : 3;
  return {static_cast<Real>(dt_), static_cast<Real>(dt_), static_cast<Real>(dx), static_cast<Real>(inverse_d / (dx * dx)), time_};
}

template <class Real>
BlockWork<Real> Engine<Real>::work(const Step<Real>& step) {
  BlockWork<Real> w;
  w.store = &store_;
  w.physics = physics_.get();
  w.contacts = &contacts_;
  w.gathered = gathered_.data();
  w.scattered = scattered_.data();
  w.step = step;
  const Point origin = lattice_.origin({0, 0, 0});
  const Face low[3] = {scene_.domain.x_min, scene_.domain.y_min, scene_.domain.z_min};
  const Face high[3] = {scene_.domain.x_max, scene_.domain.y_max, scene_.domain.z_max};
  for (int d = 0; d < 3; ++d) {
    w.origin[d] = static_cast<Real>(origin[static_cast<std::size_t>(d)]);
    w.low_face[d] = static_cast<Real>(lattice_.low_face());
    w.high_face[d] = static_cast<Real>(lattice_.high_face(d));
    w.open_low[d] = low[d] == Face::open;
    w.open_high[d] = high[d] == Face::open;
  }
  return w;
}

template <class Real>
void Engine<Real>::report_broken(const Escape<Real>& escape) const {
  const auto* columns = store_.tile(static_cast<std::size_t>(escape.tile));
  for (const auto& column : physics_->columns)
    for (int c = column.first; c < column.first + column.width; ++c)
      if (c != k_identity_column && !std::isfinite(columns[c][escape.lane]))
        throw RunError("particle " + std::to_string(identity_of<Real>(columns, escape.lane)) + ": " + column.name +
                       " is not finite in step " + std::to_string(counters_.steps) + " at t = " + std::to_string(time_) +
                       " s (dt = " + std::to_string(dt_) + " s)");
  throw RunError("a particle's state is not finite in step " + std::to_string(counters_.steps));
}

// ---------------------------------------------------------------- the step

template <class Real>
double Engine<Real>::next_step(double from, double target, double next_target) {
  const StepLimit limit = limits_.largest(extremes_, contacts_.largest_speed());
  const bool reached = from >= target;
  const double left = (reached ? next_target : target) - from;
  if (limit.dt < scene_.time.smallest_step_s)
    throw RunError(fmt::format("stability asks for a step of {:.3g} s ({}), below time.smallest_step_s, in step {} at t = {:.6g} s",
                               limit.dt, limit.reason, counters_.steps, time_));
  if (!(left > 0)) return 0;
  if (!(limit.dt < left)) return left;
  return left / std::ceil(left / limit.dt);  // equal steps up to the target
}

template <class Real>
void Engine<Real>::start(double first_target) {
  contacts_.prepare(time_);
  update_grid();
  pass(next_step(time_, first_target, first_target), true);
}

template <class Real>
void Engine<Real>::step(double target, double next_target) {
  const double began = steady_seconds();
  contacts_.prepare(time_);
  update_grid();
  const double updated = steady_seconds(), ordered = phases_.ordering;
  const double after = time_ + dt_;
  const bool reaches = after >= target - 1e-9 * dt_;
  pass(next_step(reaches ? target : after, target, next_target), reaches);
  time_ = reaches ? target : after;
  ++counters_.steps;
  counters_.particle_steps += static_cast<std::int64_t>(particle_count_);
  phases_.grid += updated - began;
  phases_.transfer += steady_seconds() - updated - (phases_.ordering - ordered);
}

template <class Real>
void Engine<Real>::pass(double next_dt, bool sample) {
  Step<Real> step = current_step();
  step.dt_next = static_cast<Real>(next_dt);
  BlockWork<Real> w = work(step);
  velocity_.resize_and_forget(0);
  if (sample && physics_->moves) {
    velocity_.resize_and_forget(store_.tiles.size() * 3 * k_width<Real>);
    w.velocity = velocity_.data();
  }
  results_.resize(store_.blocks.size());
  for (const auto& columns : colours_.columns)
    for_each_parallel(columns.size(), 1, [&](std::size_t c) {
      Scratch<Real>& scratch = scratch_[static_cast<std::size_t>(omp_get_thread_num())];
      for (std::int32_t b = columns[c].first; b < columns[c].second; ++b)
        kernel_->advance(w, b, scratch, results_[static_cast<std::size_t>(b)], sample);
    });
  dt_ = next_dt;
  extremes_ = {};
  if (sample) totals_ = {}, temperature_low_ = 1e30, temperature_high_ = -1e30;
  reduce(results_);
  std::vector<Escape<Real>> escapes;
  for (auto& r : results_)
    for (auto& e : r.escapes) escapes.push_back(std::move(e));
  if (!escapes.empty()) settle(escapes);
}

template <class Real>
void Engine<Real>::reduce(const std::vector<BlockResult<Real>>& results) {
  for (const BlockResult<Real>& r : results) {
    add_to(booked_, r.booked);
    for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i] += r.totals[i], retired_[i] += r.retired[i];
    extremes_.speed2 = std::max(extremes_.speed2, r.speed2);
    extremes_.wave2 = std::max(extremes_.wave2, r.wave2);
    extremes_.heat = std::max(extremes_.heat, r.heat);
    extremes_.water = std::max(extremes_.water, r.water);
    extremes_.deformation2 = std::max(extremes_.deformation2, r.deformation2);
    temperature_low_ = std::min(temperature_low_, r.temperature_low);
    temperature_high_ = std::max(temperature_high_, r.temperature_high);
    counters_.clamped += r.clamped;
  }
}

// ---------------------------------------------------------------- the grid update

template <class Real>
void Engine<Real>::update_grid() {
  const Step<Real> step = current_step();
  active_.find_touched(store_.blocks);
  Air air;
  if (has_surface_) {
    air = {scene_.oven.exchange_W_per_m2K(time_), scene_.oven.temperature_C(time_), scene_.oven.equilibrium_saturation(time_)};
    if (scene_.surface.form == Form::standard)
      surface_.measure(scattered_.data(), scattered_row(), physics_->volume_channel, active_, lattice_, contacts_);
    else
      measure_published_surface(air);
  }
  const std::size_t blocks = active_.at.size(), nodes = blocks * k_block_nodes;
  gathered_.resize_and_forget(nodes * static_cast<std::size_t>(gathered_row()));
  const bool implicit = physics_->implicit_heat;
  if (implicit) heat_weight_.assign(nodes, Real(0)), exchange_.assign(nodes, Real(0));
  if (implicit && physics_->has_water) sums_.resize(blocks * k_packs<Real>);
  block_bookings_.resize(blocks);
  for_each_parallel(blocks, 16, [&](std::size_t s) {
    block_bookings_[s] = {};
    if (active_.touched[s]) update_block(s, air, step, block_bookings_[s]);
  });
  if (implicit) {
    const BlockWork<Real> w = work(step);
    booked_[static_cast<std::size_t>(Entry::exchanged)] +=
        implicit_heat_.solve(*kernel_, w, colours_.columns, scratch_, heat_weight_, exchange_, physics_->temperature_channel, dt_,
                             scene_.of<Heat>().tolerance, gathered_);
    if (physics_->has_water)
      for (std::size_t s = 0; s < blocks; ++s)
        if (active_.touched[s])
          book_warmth(
              &sums_[s * k_packs<Real>], [&](int pack) { return temperatures(s, pack); }, block_bookings_[s]);
  }
  booked_[static_cast<std::size_t>(Entry::area)] = booked_[static_cast<std::size_t>(Entry::contact_area)] = 0;  // of this step, not a sum
  for (const Bookings& b : block_bookings_) add_to(booked_, b);
}

/// From scattered to gathered rows. A block found empty is no longer `touched`.
template <class Real>
void Engine<Real>::update_block(std::size_t s, const Air& air, const Step<Real>& step, Bookings& booked) {
  constexpr int W = k_width<Real>;
  const auto RS = static_cast<std::size_t>(scattered_row()), RG = static_cast<std::size_t>(gathered_row());
  Real* from = scattered_.data() + s * k_block_nodes * RS;
  Real* rows = gathered_.data() + s * k_block_nodes * RG;
  bool empty = true;
  for (std::size_t n = 0; n < k_block_nodes && empty; ++n) empty = from[n * RS + static_cast<std::size_t>(physics_->filled_channel)] == 0;
  if (empty) {
    std::memset(rows, 0, k_block_nodes * RG * sizeof(Real));
    std::memset(from, 0, k_block_nodes * RS * sizeof(Real));
    active_.touched[s] = 0;
    return;
  }
  const bool at_contact = physics_->moves && contacts_.near(active_.at[s], 0);
  const bool at_grip = contacts_.holds_temperatures() && contacts_.near(active_.at[s], 0);
  BlockSurroundings<Real> surface;
  const bool has_surface = has_surface_ && surface_.surround(s, active_, air, surface);
  Lanes<Real> in[k_most_channels], dv[3];
  for (std::size_t d = 0; d < 3; ++d) dv[d] = lanes<Real>(static_cast<Real>(dt_ * gravity_[d] / inertia_scale_));
  Lanes<Real> out[k_packs<Real>][k_most_channels];
  NodeSums<Real> sums[k_packs<Real>];
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    const int first = pack * W;
    const auto n = static_cast<std::size_t>(first);
    prefetch_rows(from + (k_block_nodes + n) * RS, W * RS);  // of the next block
    kernel_->take_nodes(from + n * RS, in);
    Surroundings<Real> around{};
    around.saturation = lanes<Real>(static_cast<Real>(air.saturation));
    if (has_surface) {
      around.area = *reinterpret_cast<const Lanes<Real>*>(surface.area + first);
      around.exchange = *reinterpret_cast<const Lanes<Real>*>(surface.exchange + first);
      around.exchange_source = *reinterpret_cast<const Lanes<Real>*>(surface.exchange_source + first);
    }
    if (at_grip) hold_temperatures(s, first, around);
    physics_->update_nodes(in, out[pack], sums[pack], around, step, booked);
    for (int c = physics_->gather_channels; c < gathered_row(); ++c) out[pack][c] = Lanes<Real>{};
    if (physics_->moves)
      for (int d = 0; d < 3; ++d) out[pack][d] += sums[pack].inertia > 0 ? dv[d] : 0 * dv[d];
    if (physics_->implicit_heat) {
      const std::size_t node = s * k_block_nodes + n;
      std::memcpy(&heat_weight_[node], &sums[pack].heat_weight, sizeof(Lanes<Real>));
      std::memcpy(&exchange_[node], &around.exchange, sizeof(Lanes<Real>));
    }
  }
  if (force_) change_velocities(s, sums, out, booked, [&](const Point& x, const Vector3& v) { return force_(x, v, time_, dt_); });
  if (at_contact) change_velocities(s, sums, out, booked, [&](const Point& x, const Vector3& v) { return contacts_.velocity_after(x, v); });
  for (std::size_t pack = 0; pack < k_packs<Real>; ++pack) kernel_->put_nodes(out[pack], rows + pack * W * RG);
  if (physics_->moves) book_momentum(s, sums, out, dv, booked);
  if (physics_->has_heat && physics_->has_water) {
    if (physics_->implicit_heat)
      std::copy(sums, sums + k_packs<Real>, &sums_[s * k_packs<Real>]);  // until the temperatures are known
    else
      book_warmth(
          sums, [&](int pack) { return out[pack][physics_->temperature_channel]; }, booked);
  }
  if (has_surface) {
    booked[static_cast<std::size_t>(Entry::area)] += sum_over_block(surface.area);
    booked[static_cast<std::size_t>(Entry::contact_area)] += sum_over_block(surface.contact_area);
  }
}
/// What gravity gives, what evaporating water takes along, and what moves between nodes against what moves between particles
/// (Water::gather). With the step's final velocities.
template <class Real>
void Engine<Real>::book_momentum(std::size_t slot, const NodeSums<Real>* sums, const Lanes<Real> (*nodes)[k_most_channels],
                                 const Lanes<Real> (&dv)[3], Bookings& booked) const {
  using V = Lanes<Real>;
  Impulses<Real> impulses;
  V moved[3] = {};
  const auto inertia = static_cast<Real>(inertia_scale_);
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    V impulse[3];
    for (int d = 0; d < 3; ++d) {
      impulse[d] = sums[pack].inertia * dv[d] - inertia * sums[pack].evaporated * nodes[pack][d];
      moved[d] += sums[pack].moved * nodes[pack][d];
    }
    impulses.add(pack * k_width<Real>, impulse);
  }
  impulses.book(lattice_.origin(active_.at[slot]), lattice_.dx(), booked);
  for (std::size_t d = 0; d < 3; ++d) booked[static_cast<std::size_t>(Entry::remapped_x) + d] -= inertia_scale_ * sum_lanes(moved[d]);
}

/// The same of heat, with the step's final temperatures: theta(pack) are those of W nodes.
template <class Real>
template <class Theta>
void Engine<Real>::book_warmth(const NodeSums<Real>* sums, Theta theta, Bookings& booked) const {
  Lanes<Real> moved{}, vapour{};  // [kg C]
  for (int pack = 0; pack < k_packs<Real>; ++pack) {
    moved += sums[pack].moved * theta(pack);
    vapour += sums[pack].evaporated * theta(pack);
  }
  booked[static_cast<std::size_t>(Entry::vapour_heat)] += water_specific_heat_ * sum_lanes(vapour);
  booked[static_cast<std::size_t>(Entry::remapped_heat)] -= water_specific_heat_ * sum_lanes(moved);
}

template <class Real>
void Engine<Real>::measure_published_surface(const Air& air) {
  const auto measure = [&]<KernelOrder order>() {
    surface_.template measure_published<order>(store_, scattered_.data(), scattered_row(), physics_->volume_channel,
                                               physics_->column_of(field::VolumeRatio::name),
                                               physics_->column_of(field::InitialVolume::name), active_, lattice_, contacts_, air);
  };
  if (scene_.grid.kernel == KernelOrder::quadratic)
    measure.template operator()<KernelOrder::quadratic>();
  else
    measure.template operator()<KernelOrder::cubic>();
}

/// Nodes that a grip holds at its temperature.
template <class Real>
void Engine<Real>::hold_temperatures(std::size_t slot, int first, Surroundings<Real>& around) const {
  for (int l = 0; l < k_width<Real>; ++l)
    if (const auto held = contacts_.held_temperature(node_position(lattice_.origin(active_.at[slot]), lattice_.dx(), first + l))) {
      around.is_held[l] = -1;
      around.held[l] = static_cast<Real>(*held);
    }
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

/// Every node with mass gets the velocity `after`(its place, its velocity); the impulse is booked.
template <class Real>
template <class After>
void Engine<Real>::change_velocities(std::size_t slot, const NodeSums<Real>* sums, Lanes<Real> (*nodes)[k_most_channels], Bookings& booked,
                                     After after) const {
  const Point origin = lattice_.origin(active_.at[slot]);
  for (int n = 0; n < k_block_nodes; ++n) {
    const int pack = n / k_width<Real>, lane = n % k_width<Real>;
    const Real mass = sums[pack].inertia[lane];
    if (!(mass > 0)) continue;
    Lanes<Real>* v_i = nodes[pack];
    const Vector3 v{double(v_i[0][lane]), double(v_i[1][lane]), double(v_i[2][lane])};
    const Point x = node_position(origin, lattice_.dx(), n);
    const Vector3 changed = after(x, v);
    if (changed == v) continue;
    for (std::size_t d = 0; d < 3; ++d) v_i[d][lane] = static_cast<Real>(changed[d]);
    book_impulse(x, double(mass) * (changed - v), booked);
  }
}

template <class Real>
std::size_t Engine<Real>::bytes() const {
  return store_.data.bytes() + spare_.data.bytes() + scattered_.bytes() + spare_rows_.bytes() + gathered_.bytes() + velocity_.bytes() +
         (store_.tiles.capacity() + spare_.tiles.capacity()) * sizeof(Tile) +
         (store_.blocks.capacity() + spare_.blocks.capacity()) * sizeof(HomeBlock) + active_.slot_of.capacity() * sizeof(std::int32_t) +
         surface_.bytes();
}

template class Engine<float>;
template class Engine<double>;

}  // namespace bake

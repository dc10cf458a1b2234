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

/// Every node with mass gets m dv; the sum acts at the block's centre of mass.
template <class Real>
void book_gravity(const Real* mass, const Point& origin, double dx, const Vector3& dv, Bookings& booked) {
  double planes[3][4] = {};  // mass by x, y and z
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) {
      double line[4];
      for (int z = 0; z < 4; ++z) {
        line[z] = static_cast<double>(mass[node_in_block(x, y, z)]);
        planes[2][z] += line[z];
      }
      const double sum = (line[0] + line[1]) + (line[2] + line[3]);
      planes[0][x] += sum;
      planes[1][y] += sum;
    }
  const double m = (planes[2][0] + planes[2][1]) + (planes[2][2] + planes[2][3]);
  Vector3 first;
  for (std::size_t d = 0; d < 3; ++d) first[d] = planes[d][1] + 2 * planes[d][2] + 3 * planes[d][3];
  if (m > 0) book_impulse(origin + (dx / m) * first, m * dv, booked);
}

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
  if (physics_->has_water) moved_water_.resize(nodes), evaporated_water_.resize(nodes);
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
        if (active_.touched[s]) book_water(s, block_bookings_[s]);
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
  alignas(64) Real mass[k_block_nodes];
  alignas(64) Lanes<Real> in[k_most_channels], out[k_most_channels] = {};
  for (int first = 0; first < k_block_nodes; first += W) {
    const auto n = static_cast<std::size_t>(first), node = s * k_block_nodes + n;
    NodeSums<Real> sums;
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
    physics_->update_nodes(in, out, sums, around, step, booked);
    if (physics_->moves) {
      for (std::size_t d = 0; d < 3; ++d)
        out[d] += sums.inertia > 0 ? lanes<Real>(static_cast<Real>(dt_ * gravity_[d] / inertia_scale_)) : 0 * sums.inertia;
      *reinterpret_cast<Lanes<Real>*>(mass + first) = sums.inertia;
    }
    kernel_->put_nodes(out, rows + n * RG);
    if (physics_->implicit_heat) {
      std::memcpy(&heat_weight_[node], &sums.heat_weight, sizeof(sums.heat_weight));
      std::memcpy(&exchange_[node], &around.exchange, sizeof(around.exchange));
    }
    if (physics_->has_water) {
      std::memcpy(&moved_water_[node], &sums.moved, sizeof(sums.moved));
      std::memcpy(&evaporated_water_[node], &sums.evaporated, sizeof(sums.evaporated));
    }
  }
  if (physics_->moves) {
    book_gravity(mass, lattice_.origin(active_.at[s]), lattice_.dx(), (dt_ / inertia_scale_) * gravity_, booked);
    if (force_) change_velocities(s, mass, rows, booked, [&](const Point& x, const Vector3& v) { return force_(x, v, time_, dt_); });
    if (at_contact)
      change_velocities(s, mass, rows, booked, [&](const Point& x, const Vector3& v) { return contacts_.velocity_after(x, v); });
  }
  if (physics_->has_water && !physics_->implicit_heat) book_water(s, booked);
  if (has_surface) {
    booked[static_cast<std::size_t>(Entry::area)] += sum_over_block(surface.area);
    booked[static_cast<std::size_t>(Entry::contact_area)] += sum_over_block(surface.contact_area);
  }
}

/// What evaporates takes its momentum and heat along; what moves between nodes is booked against what moves between particles
/// (Water::gather). All with the step's final velocities and temperatures.
template <class Real>
void Engine<Real>::book_water(std::size_t slot, Bookings& booked) const {
  const bool moves = physics_->moves, has_heat = physics_->has_heat;
  const auto RG = static_cast<std::size_t>(gathered_row());
  const Real *row = gathered_.data() + slot * k_block_nodes * RG, *temperature = row + (has_heat ? physics_->temperature_channel : 0);
  const Real *moved = &moved_water_[slot * k_block_nodes], *evaporated = &evaporated_water_[slot * k_block_nodes];
  const Point origin = lattice_.origin(active_.at[slot]);
  double moved_warmth = 0, vapour_warmth = 0;  // [kg C]
  Vector3 moved_momentum{0, 0, 0};
  for (int n = 0; n < k_block_nodes; ++n, row += RG, temperature += RG) {
    const auto m = static_cast<double>(moved[n]), lost = static_cast<double>(evaporated[n]);
    if (has_heat) {
      moved_warmth += m * static_cast<double>(*temperature);
      vapour_warmth += lost * static_cast<double>(*temperature);
    }
    if (moves) {
      const Vector3 v{double(row[0]), double(row[1]), double(row[2])};
      moved_momentum = moved_momentum + m * v;
      if (lost != 0) book_impulse(node_position(origin, lattice_.dx(), n), -inertia_scale_ * lost * v, booked);
    }
  }
  const auto add = [&](Entry entry, double amount) { booked[static_cast<std::size_t>(entry)] += amount; };
  add(Entry::vapour_heat, water_specific_heat_ * vapour_warmth);
  add(Entry::remapped_heat, -water_specific_heat_ * moved_warmth);
  add(Entry::remapped_x, -inertia_scale_ * moved_momentum[0]);
  add(Entry::remapped_y, -inertia_scale_ * moved_momentum[1]);
  add(Entry::remapped_z, -inertia_scale_ * moved_momentum[2]);
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

/// Every node with mass gets the velocity `after`(its place, its velocity); the impulse is booked.
template <class Real>
template <class After>
void Engine<Real>::change_velocities(std::size_t slot, const Real* mass, Real* rows, Bookings& booked, After after) const {
  const Point origin = lattice_.origin(active_.at[slot]);
  const int RG = gathered_row();
  for (int n = 0; n < k_block_nodes; ++n) {
    if (!(mass[n] > 0)) continue;
    Real* row = rows + n * RG;
    const Vector3 v{double(row[0]), double(row[1]), double(row[2])};
    const Point x = node_position(origin, lattice_.dx(), n);
    const Vector3 changed = after(x, v);
    for (std::size_t d = 0; d < 3; ++d) row[d] = static_cast<Real>(changed[d]);
    book_impulse(x, double(mass[n]) * (changed - v), booked);
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

// SPDX-License-Identifier: MIT
#include "solver/engine/engine.h"

#include <fmt/format.h>
#include <omp.h>

#include <cmath>

#include "solver/core/parallel.h"
#include "solver/effects/fields.h"
#include "solver/engine/spring_back.h"
#include "solver/io/progress.h"
#include "solver/scene/givers.h"

namespace bake {

template <class Real>
Engine<Real>::Engine(const Scene& scene)
    : scene_(scene),
      geometry_(scene.domain.min_m, scene.domain.max_m, scene.dx(),
                {scene.domain.is_periodic(0), scene.domain.is_periodic(1), scene.domain.is_periodic(2)}),
      physics_(make_physics_with_skins<Real>(scene)),
      kernel_(make_block_kernel<Real>(scene.grid.kernel, *physics_)),
      contacts_(scene, geometry_),
      scratch_(static_cast<std::size_t>(omp_get_max_threads())),
      implicit_heat_(scene.grid.kernel) {
  store_.columns = physics_->column_count;
  given_.resize(givers_of(scene).size());
}

template <class Real>
Step<Real> Engine<Real>::current_step() const {
  const double dx = geometry_.dx();
  const double inverse_d = scene_.grid.kernel == KernelOrder::quadratic ? 4 : 3;
  const Real dt = static_cast<Real>(dt_), baking = static_cast<Real>(baking_dt());
  return {dt, dt, baking, baking, static_cast<Real>(dx), static_cast<Real>(inverse_d / (dx * dx))};
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
  const Point origin = geometry_.origin({0, 0, 0});
  const Face low[3] = {scene_.domain.x_min, scene_.domain.y_min, scene_.domain.z_min};
  const Face high[3] = {scene_.domain.x_max, scene_.domain.y_max, scene_.domain.z_max};
  for (int d = 0; d < 3; ++d) {
    w.origin[d] = static_cast<Real>(origin[static_cast<std::size_t>(d)]);
    const bool is_periodic = geometry_.is_periodic(d);  // then nothing is held or lost
    w.low_face[d] = static_cast<Real>(is_periodic ? -k_infinity : geometry_.low_face());
    w.high_face[d] = static_cast<Real>(is_periodic ? k_infinity : geometry_.high_face(d));
    w.open_low[d] = low[d] == Face::open;
    w.open_high[d] = high[d] == Face::open;
  }
  return w;
}

template <class Real>
void Engine<Real>::report_broken(const Migrant<Real>& migrant) const {
  const auto* columns = store_.tile(static_cast<std::size_t>(migrant.tile));
  std::string names;  // one number that is none spoils others in the same step
  for (const auto& column : physics_->columns)
    for (int c = column.first; c < column.first + column.width; ++c)
      if (c != k_identity_column && !std::isfinite(columns[c][migrant.lane])) {
        names += (names.empty() ? "" : ", ") + column.name;
        break;
      }
  throw RunError("particle " + std::to_string(identity_of<Real>(columns, migrant.lane)) + ": " + names + " not finite in step " +
                 std::to_string(counters_.steps) + " at t = " + std::to_string(time_) + " s (dt = " + std::to_string(dt_) + " s)");
}

// ---------------------------------------------------------------- the step

template <class Real>
double Engine<Real>::next_step(double from, double target, double next_target) {
  const StepLimit limit = largest_step(scene_, *physics_, bounds_, contacts_.largest_speed(), alone());
  const bool reached = from >= target;
  const double left = (reached ? next_target : target) - from;
  if (!(from + limit.dt > from))
    throw RunError(fmt::format("stability asks for a step of {:.3g} s ({}), by which time does not advance, in step {} at t = {:.6g} s",
                               limit.dt, limit.reason, counters_.steps, time_));
  // more than 1e8 steps to the next frame, or the end: no run is meant to take years
  const double smallest =
      scene_.time.smallest_step_s > 0 ? scene_.time.smallest_step_s : 1e-8 * std::min(1 / scene_.run.frame_rate_per_s, scene_.run.end_s);
  if (limit.dt < smallest)
    throw RunError(
        fmt::format("stability asks for a step of {:.3g} s ({}), below time.smallest_step_s = {:.3g} s, in step {} at t = {:.6g} s",
                    limit.dt, limit.reason, smallest, counters_.steps, time_));
  if (!(left > 0)) return 0;
  if (!(limit.dt < left)) return left;
  return left / std::ceil(left / limit.dt);  // equal steps up to the target
}

template <class Real>
void Engine<Real>::start(double first_target) {
  const bool settles = physics_->settling.damping > 0;
  contacts_.prepare(time_, 0, settles);
  update_grid();
  pass(time_, settles ? next_settling_step() : next_step(time_, first_target, first_target), settles, true);
  surface_travel_ = k_infinity;  // the pass has summed the volumes in another order
}

template <class Real>
double Engine<Real>::alone() const {
  return crumbs_travel_ <= k_crumbs_move_dx && counters_.steps - crumbs_looked_ <= k_most_steps_per_look ? crumbs_share_ : 1;
}

/// Where the step would be longer if it were known that no particle is alone, finds out. The next limit is that of the last pass's maxima.
template <class Real>
void Engine<Real>::look_for_crumbs() {
  constexpr double k_margin = 1.05;  // eigenvalues were up to 1.3 times what is found here; the limit takes 0.9 of the step
  const double own = physics_->moves ? bounds_[static_cast<std::size_t>(physics_->own_bound)] : 0;
  if (scene_.grid.kernel != KernelOrder::quadratic || !(own > 0 && own < k_infinity) || alone() < 1) return;
  if (counters_.steps - crumbs_looked_ < k_fewest_steps_per_look) return;
  const auto longest = [&](double share) { return largest_step(scene_, *physics_, bounds_, contacts_.largest_speed(), share).dt; };
  if (!(longest(0) > longest(1))) return;
  crumbs_share_ = std::min(
      k_margin * spring_back(scene_.grid.kernel, store_, *physics_, geometry_.dx(), colours_.columns(), active_.at.size()) / own, 1.0);
  crumbs_travel_ = 0;
  crumbs_looked_ = counters_.steps;
}

/// Equal steps up to the end of settling.
template <class Real>
double Engine<Real>::next_settling_step() {
  return next_step(settling_.time, physics_->settling.longest, physics_->settling.longest);
}

/// Adds the step that is taken to the time of settling. Returns whether another follows.
template <class Real>
bool Engine<Real>::settle_on() {
  const SettlingRule& rule = physics_->settling;
  settling_.time += dt_;
  const bool slow = bounds_[static_cast<std::size_t>(physics_->speed_bound)] <= rule.slow * rule.slow;  // false if that is no number
  settling_.still_for = slow ? settling_.still_for + dt_ : 0;
  settling_.is_still = settling_.still_for * rule.damping >= 1;
  return !settling_.is_still && settling_.time < rule.longest - 1e-9 * dt_;
}

template <class Real>
void Engine<Real>::step(double target, double next_target) {
  const double began = steady_seconds();
  contacts_.prepare(time_, baking_dt(), settling_.now);
  update_grid();
  const double updated = steady_seconds(), ordered = phases_.ordering;
  const bool reaches = !settling_.now && time_ + dt_ >= target - 1e-9 * dt_;
  const double after = settling_.now ? time_ : reaches ? target : time_ + dt_;
  const bool settles_on = settling_.now && settle_on();
  pass(after, settles_on ? next_settling_step() : next_step(after, target, next_target), settles_on, reaches);
  time_ = after;
  ++counters_.steps;
  counters_.particle_steps += static_cast<std::int64_t>(particle_count_);
  phases_.grid += updated - began;
  phases_.transfer += steady_seconds() - updated - (phases_.ordering - ordered);
}

/// `after`: when the next step begins, which takes `next_dt` and may belong to settling.
template <class Real>
void Engine<Real>::pass(double after, double next_dt, bool next_settles, bool sample) {
  Step<Real> step = current_step();
  step.dt_next = static_cast<Real>(next_dt);
  step.baking_dt_next = next_settles ? Real(0) : step.dt_next;
  BlockWork<Real> w = work(step);
  sampled_ = {};  // its memory, too: frames are rare
  if (sample && physics_->moves) {
    sampled_.resize(static_cast<std::size_t>(next_identity_) * static_cast<std::size_t>(physics_->sampled()));
    w.sampled = sampled_.data();
  }
  results_.resize(store_.blocks.size());
  if (!given_.empty()) {
    home_given_.assign(store_.blocks.size() * given_.size(), {});
    w.given = home_given_.data();
    w.givers = given_.size();
  }
  colours_.for_each([&](std::int32_t b) {
    kernel_->advance(w, b, scratch_[static_cast<std::size_t>(omp_get_thread_num())], results_[static_cast<std::size_t>(b)], sample);
  });
  const double done = dt_;
  dt_ = next_dt;
  settling_.now = next_settles;
  bounds_ = {};
  if (sample) {
    totals_ = {};
    highest_.fill(k_lowest);
  }
  reduce(results_);
  const double travel = travelled(done);
  surface_travel_ += travel;
  crumbs_travel_ += travel;
  if (!given_.empty()) sum_given(home_given_);
  std::vector<Migrant<Real>> migrants;
  for (auto& r : results_)
    for (auto& e : r.migrants) migrants.push_back(std::move(e));
  const bool is_stale = physics_->moves && counters_.steps - last_sorted_ >= k_most_steps_unsorted;
  if (!migrants.empty() || is_stale) migrate_particles(migrants);
  if (skins_) pull_skins(after, sample);
}

/// How far a particle may have moved, and how much of its size changed, in a step that is done [dx].
template <class Real>
double Engine<Real>::travelled(double dt) const {
  if (!physics_->moves || !(dt > 0)) return 0;
  if (contacts_.expels()) return k_infinity;  // pushed out, particles jump
  const auto largest = [&](int bound) { return std::sqrt(bounds_[static_cast<std::size_t>(bound)]); };
  return dt * (largest(physics_->speed_bound) / geometry_.dx() + largest(physics_->rate_bound));
}

template <class Real>
void Engine<Real>::reduce(const std::vector<BlockResult<Real>>& results) {
  for (const BlockResult<Real>& r : results) {
    add_to(booked_, r.booked);
    for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i] += r.totals[i], retired_[i] += r.retired[i];
    raise_to(bounds_, r.bounds);
    raise_to(highest_, r.highest);
    counters_.clamped += r.clamped;
  }
}

/// In the order of the blocks.
template <class Real>
void Engine<Real>::sum_given(const std::vector<Given>& of_blocks) {
  for (std::size_t i = 0; i < of_blocks.size(); ++i) {
    Given& sum = given_[i % given_.size()];
    sum.impulse = sum.impulse + of_blocks[i].impulse;
    sum.heat += of_blocks[i].heat;
  }
}

template <class Real>
std::size_t Engine<Real>::bytes() const {
  return store_.data.bytes() + scattered_.bytes() + gathered_.bytes() + sampled_.capacity() * sizeof(Real) +
         store_.tiles.capacity() * sizeof(Tile) + store_.blocks.capacity() * sizeof(HomeBlock) +
         active_.slot_of.capacity() * sizeof(std::int32_t) + surface_.bytes() + surface_volumes_.capacity() * sizeof(surface_volumes_[0]) +
         contacts_.bytes();
}

template class Engine<float>;
template class Engine<double>;

}  // namespace bake

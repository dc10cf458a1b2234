// SPDX-License-Identifier: MIT
#include "solver/baker/engine.h"

#include <omp.h>

#include <bit>
#include <cstring>

#include "solver/boundary/vector3.h"
#include "solver/particles/fields.h"
#include "solver/particles/order.h"

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
  double m = 0;
  Vector3 first{0, 0, 0};
  for (int n = 0; n < k_block_nodes; ++n) {
    const auto m_n = static_cast<double>(mass[n]);
    m += m_n;
    first[0] += m_n * (n / 16);
    first[1] += m_n * (n / 4 % 4);
    first[2] += m_n * (n % 4);
  }
  if (m > 0) book_impulse(origin + (dx / m) * first, m * dv, booked);
}

/// First column of a field, -1 if the model has it not.
template <class Real>
int column_of(const Physics<Real>& physics, std::string_view name) {
  for (const auto& column : physics.columns)
    if (column.name == name) return column.first;
  return -1;
}

template <class V>
std::size_t identity_of(const V* columns, int lane) {
  const auto bits = columns[k_identity_column][lane];
  if constexpr (sizeof(bits) == 4) return static_cast<std::size_t>(std::bit_cast<std::int32_t>(bits));
  return static_cast<std::size_t>(bits);
}

/// Mass of one particle [kg].
template <class Real>
double particle_mass(const Physics<Real>& physics, const Lanes<Real>* columns, int lane) {
  double mass = 0;
  for (const auto& column : physics.columns)
    if (column.name == field::SolidMass::name || column.name == field::WaterMass::name)
      mass += static_cast<double>(columns[column.first][lane]);
  return mass;
}

}  // namespace

template <class Real>
Engine<Real>::Engine(const Scene& scene)
    : scene_(scene),
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
  w.gathered = grid_.data();
  w.scattered = other_.data();
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

// ---------------------------------------------------------------- particles come and go

template <class Real>
void Engine<Real>::add(const std::vector<NewParticle>& particles, bool poured) {
  constexpr int W = k_width<Real>;
  if (particles.empty()) return;
  // a store of its own: one tile per run of particles with the same home and material, in the order given
  ParticleStore<Real> fresh;
  fresh.columns = physics_->column_count;
  std::vector<std::size_t> tile_first;
  std::vector<Home<Real>> homes;
  homes.reserve(particles.size());
  for (const NewParticle& p : particles) {
    BlockIndex block;
    int* at[3] = {&block.x, &block.y, &block.z};
    Real x[3];
    for (int d = 0; d < 3; ++d) {
      const double nodes = lattice_.in_nodes(p.x[static_cast<std::size_t>(d)], d);
      if (!(nodes >= lattice_.low_face() && nodes <= lattice_.high_face(d)))
        throw InputError(scene_.file.string() + ": domain: a particle at (" + std::to_string(p.x[0]) + ", " + std::to_string(p.x[1]) +
                         ", " + std::to_string(p.x[2]) + ") m lies outside the domain, allowed: bodies and emitters inside it");
      *at[d] = static_cast<int>(nodes - 0.5) >> 2;
      x[d] = static_cast<Real>(nodes - 4 * *at[d]);
    }
    homes.push_back(find_home(block, x));
  }
  std::vector<std::uint32_t> order(particles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t i) { return std::pair(lattice_.linear(homes[i].block), particles[i].material); };
    return key(a) < key(b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& home = homes[order[i]];
    if (fresh.blocks.empty() || !(fresh.blocks.back().at == home.block)) {
      HomeBlock block{};
      block.at = home.block;
      block.first_tile = static_cast<std::int32_t>(fresh.tiles.size());
      fresh.blocks.push_back(block);
    }
    HomeBlock& block = fresh.blocks.back();
    const std::int32_t material = particles[order[i]].material;
    if (block.tiles == 0 || fresh.tiles.back().material != material || fresh.tiles.back().count == W) {
      fresh.tiles.push_back({material, 0});
      tile_first.push_back(i);
      ++block.tiles;
    }
    ++fresh.tiles.back().count;
  }
  fresh.data.resize_and_forget(fresh.tiles.size() * fresh.tile_size());
  std::vector<Real> start(fresh.tiles.size() * 12 * W);  // velocity and affine velocity
  const int velocity_column = column_of(*physics_, field::Velocity::name);
  for (std::size_t t = 0; t < fresh.tiles.size(); ++t)
    for (int l = 0; l < W; ++l) {
      const std::size_t i = order[tile_first[t] + static_cast<std::size_t>(std::min(l, fresh.tiles[t].count - 1))];
      const NewParticle& p = particles[i];
      auto* columns = fresh.tile(t);
      for (int d = 0; d < 3; ++d) columns[k_position_column + d][l] = homes[i].x[d];
      const auto identity = static_cast<std::int32_t>(next_identity_ + static_cast<std::int64_t>(i));
      if constexpr (sizeof(Real) == 4)
        columns[k_identity_column][l] = std::bit_cast<float>(identity);
      else
        columns[k_identity_column][l] = static_cast<double>(identity);
      physics_->fill(columns, l, p.material, p.volume, *p.body);
      if (velocity_column >= 0)  // FLIP keeps it
        for (int d = 0; d < 3; ++d) columns[velocity_column + d][l] = static_cast<Real>(p.velocity[static_cast<std::size_t>(d)]);
      Real* s = start.data() + t * 12 * W + l;
      for (int d = 0; d < 3; ++d) s[d * W] = static_cast<Real>(p.velocity[static_cast<std::size_t>(d)]);
      const double C[9] = {0, -p.spin[2], p.spin[1], p.spin[2], 0, -p.spin[0], -p.spin[1], p.spin[0], 0};
      for (int c = 0; c < 9; ++c) s[(3 + c) * W] = static_cast<Real>(C[c]);
    }
  next_identity_ += static_cast<std::int64_t>(particles.size());

  if (poured)
    for (std::size_t t = 0; t < fresh.tiles.size(); ++t)
      for (int l = 0; l < fresh.tiles[t].count; ++l) counters_.emitted_mass += particle_mass(*physics_, fresh.tile(t), l);

  order_particles<Real>(store_, &fresh, lattice_, nullptr, spare_);
  std::swap(store_, spare_);
  const ActiveBlocks before = active_;
  after_ordering();
  rehome_grid(before);
  carry_velocity(spare_, particles);
  scatter_new(fresh, start);
}

template <class Real>
void Engine<Real>::scatter_new(const ParticleStore<Real>& fresh, const std::vector<Real>& start) {
  constexpr int W = k_width<Real>;
  const auto rows_per_particle = static_cast<std::size_t>(4 * kernel_->row_size());
  const Step<Real> step = current_step();
  BlockWork<Real> w = work(step);
  w.scattered = grid_.data();
  AlignedBuffer<Real> scattered, rows, columns;
  scattered.resize_and_forget(rows_per_particle * W);
  rows.resize_and_forget(rows_per_particle * W);
  columns.resize_and_forget(fresh.tile_size());
  std::vector<BlockResult<Real>> results(fresh.blocks.size());
  for (std::size_t b = 0; b < fresh.blocks.size(); ++b) {
    const HomeBlock& block = fresh.blocks[b];
    const std::int32_t home = home_of(block.at);
    Report<Real> report;
    const Point origin = lattice_.origin(block.at);
    for (int d = 0; d < 3; ++d) report.origin[d] = static_cast<Real>(origin[static_cast<std::size_t>(d)]);
    for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t) {
      const auto at = static_cast<std::size_t>(t);
      const int count = fresh.tiles[at].count;
      for (int l = 0; l < W; ++l) report.alive[l] = l < count;
      std::memcpy(columns.data(), fresh.tile(at), fresh.tile_size() * sizeof(Real));
      auto* lanes_of = reinterpret_cast<Lanes<Real>*>(columns.data());
      const Lanes<Real> x[3] = {lanes_of[0], lanes_of[1], lanes_of[2]};
      std::memset(scattered.data(), 0, scattered.size() * sizeof(Real));
      alignas(64) Lanes<Real> motion[12];
      std::memcpy(motion, start.data() + at * 12 * W, sizeof(motion));
      physics_->start(lanes_of, fresh.tiles[at].material, motion, motion + 3, reinterpret_cast<Lanes<Real>*>(scattered.data()),
                      kernel_->row_size(), step, report);
      kernel_->to_rows(*physics_, x, reinterpret_cast<Lanes<Real>*>(scattered.data()), rows.data());
      for (int l = 0; l < count; ++l)
        kernel_->scatter_rows(w, home, {x[0][l], x[1][l], x[2][l]}, rows.data() + static_cast<std::size_t>(l) * rows_per_particle);
    }
    collect(report, results[b]);
  }
  reduce(results);
}

template <class Real>
std::int32_t Engine<Real>::home_of(const BlockIndex& block) const {
  const std::size_t wanted = lattice_.linear(block);
  const auto found = std::lower_bound(store_.blocks.begin(), store_.blocks.end(), wanted,
                                      [&](const HomeBlock& b, std::size_t linear) { return lattice_.linear(b.at) < linear; });
  return static_cast<std::int32_t>(found - store_.blocks.begin());
}

template <class Real>
void Engine<Real>::after_ordering() {
  ++counters_.orderings;
  particle_count_ = store_.particles();
  active_.surround(store_.blocks, lattice_);
  for (auto& columns : colours_.columns) columns.clear();
  for (std::size_t i = 0; i < store_.blocks.size(); ++i) {
    const BlockIndex& b = store_.blocks[i].at;
    const bool same = i > 0 && store_.blocks[i - 1].at.x == b.x && store_.blocks[i - 1].at.y == b.y;
    auto& columns = colours_.columns[(b.x & 1) * 2 + (b.y & 1)];
    if (same)
      columns.back().second = static_cast<std::int32_t>(i) + 1;
    else
      columns.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(i) + 1});
  }
}

/// Moves the scattered rows to the slots that their blocks have now; new blocks are empty.
template <class Real>
void Engine<Real>::rehome_grid(const ActiveBlocks& before) {
  const std::size_t block_size = static_cast<std::size_t>(k_block_nodes) * static_cast<std::size_t>(row_size());
  const std::size_t needed = active_.at.size() * block_size;
  other_.resize_and_forget(needed);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < active_.at.size(); ++i) {
    const std::size_t linear = lattice_.linear(active_.at[i]);
    const std::int32_t old = before.slot_of.empty() ? -1 : before.slot_of[linear];
    if (old >= 0)
      std::memcpy(other_.data() + i * block_size, grid_.data() + static_cast<std::size_t>(old) * block_size, block_size * sizeof(Real));
    else
      std::memset(other_.data() + i * block_size, 0, block_size * sizeof(Real));
  }
  grid_.swap(other_);
  other_.resize_and_forget(needed);
}

/// Particles that drifted out of their blocks: retire or order them, then scatter what they owe.
template <class Real>
void Engine<Real>::settle(std::vector<Escape<Real>>& escapes) {
  for (const Escape<Real>& e : escapes)
    if (e.broken) report_broken(e);
  std::vector<std::pair<std::int32_t, std::int32_t>> retired;
  std::vector<Home<Real>> homes(escapes.size());
  for (std::size_t i = 0; i < escapes.size(); ++i) {
    Escape<Real>& e = escapes[i];
    const HomeBlock& block = store_.blocks[static_cast<std::size_t>(e.home)];
    auto* columns = store_.tile(static_cast<std::size_t>(e.tile));
    Real x[3];
    const int corner[3] = {4 * block.at.x, 4 * block.at.y, 4 * block.at.z};
    const BlockWork<Real> w = work(current_step());
    for (int d = 0; d < 3; ++d) {  // a particle so fast that it jumped over the blocks at the face
      x[d] = columns[k_position_column + d][e.lane];
      const Real low = w.low_face[d] - Real(corner[d]), high = w.high_face[d] - Real(corner[d]);
      if (x[d] < low || x[d] > high) {
        e.retired |= x[d] < low ? w.open_low[d] : w.open_high[d];
        ++counters_.clamped;
        x[d] = std::clamp(x[d], low, high);
        columns[k_position_column + d][e.lane] = x[d];
      }
    }
    homes[i] = find_home(block.at, x);
    if (e.retired) {
      retired.push_back({e.tile, e.lane});
      ++counters_.retired;
      counters_.retired_mass += particle_mass(*physics_, columns, e.lane);
    }
  }
  std::sort(retired.begin(), retired.end());
  const auto leave_out = [&](std::int32_t tile, std::int32_t lane) {
    return std::binary_search(retired.begin(), retired.end(), std::pair(tile, lane));
  };
  order_particles<Real>(store_, nullptr, lattice_, retired.empty() ? std::function<bool(std::int32_t, std::int32_t)>() : leave_out, spare_);
  std::swap(store_, spare_);
  const ActiveBlocks before = active_;
  after_ordering();
  rehome_grid(before);
  carry_velocity(spare_, {});
  BlockWork<Real> w = work(current_step());
  w.scattered = grid_.data();
  for (std::size_t i = 0; i < escapes.size(); ++i)
    if (!escapes[i].retired) kernel_->scatter_rows(w, home_of(homes[i].block), homes[i].x, escapes[i].rows.data());
}

/// Sampled velocities follow their particles from the order `before` into the present one; those just added have their own.
template <class Real>
void Engine<Real>::carry_velocity(const ParticleStore<Real>& before, const std::vector<NewParticle>& added) {
  constexpr int W = k_width<Real>;
  if (velocity_.size() == 0) return;
  std::vector<std::array<Real, 3>> of(static_cast<std::size_t>(next_identity_));
  for (std::size_t t = 0; t < before.tiles.size(); ++t)
    for (int l = 0; l < before.tiles[t].count; ++l)
      for (std::size_t d = 0; d < 3; ++d)
        of[identity_of(before.tile(t), l)][d] = velocity_.data()[(t * 3 + d) * W + static_cast<std::size_t>(l)];
  for (std::size_t i = 0; i < added.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d) of[of.size() - added.size() + i][d] = static_cast<Real>(added[i].velocity[d]);
  velocity_.resize_and_forget(store_.tiles.size() * 3 * W);
  for (std::size_t t = 0; t < store_.tiles.size(); ++t)
    for (int l = 0; l < W; ++l)
      for (std::size_t d = 0; d < 3; ++d)
        velocity_.data()[(t * 3 + d) * W + static_cast<std::size_t>(l)] = of[identity_of(store_.tile(t), l)][d];
}

template <class Real>
void Engine<Real>::report_broken(const Escape<Real>& escape) const {
  const auto* columns = store_.tile(static_cast<std::size_t>(escape.tile));
  for (const auto& column : physics_->columns)
    for (int c = column.first; c < column.first + column.width; ++c)
      if (c != k_identity_column && !std::isfinite(columns[c][escape.lane]))
        throw RunError("particle " + std::to_string(identity_of(columns, escape.lane)) + ": " + column.name + " is not finite in step " +
                       std::to_string(counters_.steps) + " at t = " + std::to_string(time_) + " s (dt = " + std::to_string(dt_) + " s)");
  throw RunError("a particle's state is not finite in step " + std::to_string(counters_.steps));
}

// ---------------------------------------------------------------- the step

template <class Real>
double Engine<Real>::next_step(double from, double target, double next_target) {
  const StepLimit limit = limits_.largest(extremes_, contacts_.largest_speed());
  const bool reached = from >= target;
  const double left = (reached ? next_target : target) - from;
  if (limit.dt < scene_.time.smallest_step_s)
    throw RunError("stability asks for a step of " + std::to_string(limit.dt) + " s (" + limit.reason +
                   "), below time.smallest_step_s, in step " + std::to_string(counters_.steps) + " at t = " + std::to_string(time_) + " s");
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
  contacts_.prepare(time_);
  update_grid();
  const double after = time_ + dt_;
  const bool reaches = after >= target - 1e-9 * dt_;
  pass(next_step(reaches ? target : after, target, next_target), reaches);
  time_ = reaches ? target : after;
  ++counters_.steps;
  counters_.particle_steps += static_cast<std::int64_t>(particle_count_);
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
  const std::size_t numbers = other_.size();
#pragma omp parallel
  {
    const auto threads = static_cast<std::size_t>(omp_get_num_threads()), me = static_cast<std::size_t>(omp_get_thread_num());
    const std::size_t first = numbers * me / threads, last = numbers * (me + 1) / threads;
    if (last > first) std::memset(other_.data() + first, 0, (last - first) * sizeof(Real));
  }
  std::vector<BlockResult<Real>> results(store_.blocks.size());
  for (const auto& columns : colours_.columns) {
    const auto count = static_cast<std::int64_t>(columns.size());
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t c = 0; c < count; ++c)
      for (std::int32_t b = columns[static_cast<std::size_t>(c)].first; b < columns[static_cast<std::size_t>(c)].second; ++b)
        kernel_->advance(w, b, scratch_[static_cast<std::size_t>(omp_get_thread_num())], results[static_cast<std::size_t>(b)], sample);
  }
  grid_.swap(other_);
  dt_ = next_dt;
  extremes_ = {};
  if (sample) totals_ = {}, temperature_low_ = 1e30, temperature_high_ = -1e30;
  reduce(results);
  std::vector<Escape<Real>> escapes;
  for (auto& r : results)
    for (auto& e : r.escapes) escapes.push_back(std::move(e));
  if (!escapes.empty()) settle(escapes);
}

template <class Real>
void Engine<Real>::reduce(const std::vector<BlockResult<Real>>& results) {
  for (const BlockResult<Real>& r : results) {
    add_to(booked_, r.booked);
    for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i] += r.totals[i];
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
  constexpr int W = k_width<Real>;
  const int RS = row_size();
  const Step<Real> step = current_step();
  Air air;
  if (has_surface_) {
    air = {scene_.oven.exchange_W_per_m2K(time_), scene_.oven.temperature_C(time_), scene_.oven.equilibrium_saturation(time_)};
    if (scene_.surface.form == Form::standard)
      surface_.measure(grid_.data(), RS, physics_->volume_channel, active_, lattice_, contacts_, air);
    else
      surface_.measure_published(store_, grid_.data(), RS, physics_->volume_channel, column_of(*physics_, field::VolumeRatio::name),
                                 column_of(*physics_, field::InitialVolume::name), active_, lattice_, contacts_, air);
  }
  const Vector3 g = physics_->moves ? scene_.of<Motion>().gravity_m_per_s2 : Vector3{0, 0, 0};
  const double inertia = scene_.of<Motion>().inertia_scale;
  const bool implicit = physics_->implicit_heat;
  const auto blocks = static_cast<std::int64_t>(active_.at.size());
  if (implicit) heat_weight_.assign(active_.at.size() * k_block_nodes, Real(0));
  std::vector<Bookings> booked(active_.at.size());

#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t i = 0; i < blocks; ++i) {
    const auto s = static_cast<std::size_t>(i);
    Real* rows = grid_.data() + s * k_block_nodes * static_cast<std::size_t>(RS);
    bool empty = true;
    for (int n = 0; n < k_block_nodes && empty; ++n) empty = rows[n * RS + physics_->filled_channel] == 0;
    if (empty) continue;
    const bool at_contact = physics_->moves && contacts_.near(active_.at[s], 0);
    const bool at_grip = contacts_.holds_temperatures() && contacts_.near(active_.at[s], 0);
    alignas(64) Real mass[k_block_nodes];
    for (int first = 0; first < k_block_nodes; first += W) {
      alignas(64) Lanes<Real> in[16], out[16] = {}, moving{}, weight{};
      for (int c = 0; c < physics_->scatter_channels; ++c)
        for (int l = 0; l < W; ++l) in[c][l] = rows[(first + l) * RS + c];
      Surroundings<Real> around{};
      load_surroundings(s, first, at_grip, around);
      around.saturation = lanes<Real>(static_cast<Real>(air.saturation));
      physics_->update_nodes(in, out, &moving, &weight, around, step, booked[s]);
      if (physics_->moves) {
        for (int d = 0; d < 3; ++d)
          out[d] += moving > 0 ? lanes<Real>(static_cast<Real>(dt_ * g[static_cast<std::size_t>(d)] / inertia)) : 0 * moving;
        *reinterpret_cast<Lanes<Real>*>(mass + first) = moving;
      }
      for (int c = 0; c < physics_->gather_channels; ++c)
        for (int l = 0; l < W; ++l) rows[(first + l) * RS + c] = out[c][l];
      if (implicit)
        for (int l = 0; l < W; ++l) heat_weight_[s * k_block_nodes + static_cast<std::size_t>(first + l)] = weight[l];
    }
    if (physics_->moves) {
      book_gravity(mass, lattice_.origin(active_.at[s]), lattice_.dx(), (dt_ / inertia) * g, booked[s]);
      if (at_contact) touch_contacts(s, mass, rows, booked[s]);
    }
    if (has_surface_ && surface_.has_surface(s)) {
      const BlockSurroundings<Real>& around = surface_.at(s);
      for (int n = 0; n < k_block_nodes; ++n) {
        booked[s][static_cast<std::size_t>(Entry::area)] += static_cast<double>(around.area[n]);
        booked[s][static_cast<std::size_t>(Entry::contact_area)] += static_cast<double>(around.contact_area[n]);
      }
    }
  }
  booked_[static_cast<std::size_t>(Entry::area)] = booked_[static_cast<std::size_t>(Entry::contact_area)] = 0;  // of this step, not a sum
  for (const Bookings& b : booked) add_to(booked_, b);
  if (implicit) {
    const auto exchange_at = [&](std::size_t slot, int node) {
      return has_surface_ && surface_.has_surface(slot) ? surface_.at(slot).exchange[node] : Real(0);
    };
    const BlockWork<Real> w = work(step);
    booked_[static_cast<std::size_t>(Entry::exchanged)] +=
        implicit_heat_.solve(*kernel_, w, colours_.columns, scratch_, heat_weight_, exchange_at, physics_->temperature_channel, dt_,
                             scene_.of<Heat>().tolerance, grid_);
  }
}

template <class Real>
void Engine<Real>::load_surroundings(std::size_t slot, int first, bool at_grip, Surroundings<Real>& around) const {
  if (has_surface_ && surface_.has_surface(slot)) {
    const BlockSurroundings<Real>& s = surface_.at(slot);
    around.area = *reinterpret_cast<const Lanes<Real>*>(s.area + first);
    around.exchange = *reinterpret_cast<const Lanes<Real>*>(s.exchange + first);
    around.exchange_source = *reinterpret_cast<const Lanes<Real>*>(s.exchange_source + first);
  }
  if (at_grip)
    for (int l = 0; l < k_width<Real>; ++l) {
      const int n = first + l;
      const Point x = lattice_.origin(active_.at[slot]) + lattice_.dx() * Vector3{double(n / 16), double(n / 4 % 4), double(n % 4)};
      if (const auto held = contacts_.held_temperature(x)) {
        around.is_held[l] = -1;
        around.held[l] = static_cast<Real>(*held);
      }
    }
}

template <class Real>
void Engine<Real>::touch_contacts(std::size_t slot, const Real* mass, Real* rows, Bookings& booked) const {
  const Point origin = lattice_.origin(active_.at[slot]);
  for (int n = 0; n < k_block_nodes; ++n) {
    if (!(mass[n] > 0)) continue;
    Real* row = rows + n * row_size();
    const Vector3 v{double(row[0]), double(row[1]), double(row[2])};
    const Point x = origin + lattice_.dx() * Vector3{double(n / 16), double(n / 4 % 4), double(n % 4)};
    const Vector3 after = contacts_.velocity_after(x, v);
    for (std::size_t d = 0; d < 3; ++d) row[d] = static_cast<Real>(after[d]);
    book_impulse(x, double(mass[n]) * (after - v), booked);
  }
}

// ---------------------------------------------------------------- stop and go on

template <class Real>
std::size_t Engine<Real>::bytes() const {
  return store_.data.bytes() + spare_.data.bytes() + grid_.bytes() + other_.bytes() + velocity_.bytes() +
         (store_.tiles.capacity() + spare_.tiles.capacity()) * sizeof(Tile) +
         (store_.blocks.capacity() + spare_.blocks.capacity()) * sizeof(HomeBlock) + active_.slot_of.capacity() * sizeof(std::int32_t) +
         surface_.bytes();
}

template <class Real>
void Engine<Real>::write(CheckpointWriter& out) const {
  std::vector<std::int32_t> blocks, tiles;
  for (const HomeBlock& b : store_.blocks) {
    for (const int i : {b.at.x, b.at.y, b.at.z, int(b.first_tile), int(b.tiles), int(b.at_face)}) blocks.push_back(i);
    for (int d = 0; d < 3; ++d) blocks.push_back(b.low[d]), blocks.push_back(b.high[d]);
  }
  for (const Tile& t : store_.tiles) tiles.push_back(t.material), tiles.push_back(t.count);
  out.add("blocks", std::span<const std::int32_t>(blocks));
  out.add("tiles", std::span<const std::int32_t>(tiles));
  out.add("particles", std::span<const Real>(store_.data.data(), store_.data.size()));
  out.add("grid", std::span<const Real>(grid_.data(), grid_.size()));
  const double numbers[] = {time_,
                            dt_,
                            extremes_.speed2,
                            extremes_.wave2,
                            extremes_.heat,
                            extremes_.water,
                            extremes_.deformation2,
                            counters_.retired_mass,
                            counters_.emitted_mass,
                            temperature_low_,
                            temperature_high_};
  out.add("numbers", std::span<const double>(numbers));
  out.add("booked", std::span<const double>(booked_));
  out.add("totals", std::span<const double>(totals_));
  const std::int64_t counts[] = {counters_.steps,   counters_.particle_steps, counters_.orderings,
                                 counters_.clamped, counters_.retired,        next_identity_};
  out.add("counts", std::span<const std::int64_t>(counts));
}

template <class Real>
void Engine<Real>::read(const CheckpointReader& in) {
  const auto blocks = in.array<std::int32_t>("blocks"), tiles = in.array<std::int32_t>("tiles");
  const auto particles = in.array<Real>("particles"), grid = in.array<Real>("grid");
  const auto numbers = in.array<double>("numbers"), booked = in.array<double>("booked"), totals = in.array<double>("totals");
  const auto counts = in.array<std::int64_t>("counts");
  const auto expect = [](bool fits) {
    if (!fits)
      throw InputError("the checkpoint's arrays do not fit this program's layout, allowed: a checkpoint written by the same version");
  };
  expect(blocks.size() % 12 == 0 && tiles.size() % 2 == 0 && numbers.size() == 11 && booked.size() == booked_.size() &&
         totals.size() == totals_.size() && counts.size() == 6);
  store_.blocks.resize(blocks.size() / 12);
  for (std::size_t i = 0; i < store_.blocks.size(); ++i) {
    const std::int32_t* b = &blocks[12 * i];
    HomeBlock& block = store_.blocks[i];
    block = {};
    block.at = {b[0], b[1], b[2]};
    block.first_tile = b[3];
    block.tiles = b[4];
    block.at_face = b[5] != 0;
    for (int d = 0; d < 3; ++d)
      block.low[d] = static_cast<std::int8_t>(b[6 + 2 * d]), block.high[d] = static_cast<std::int8_t>(b[7 + 2 * d]);
    for (int d = 0; d < 3; ++d) expect(b[d] > 0 && b[d] < lattice_.blocks(d) - 1);
  }
  store_.tiles.resize(tiles.size() / 2);
  for (std::size_t i = 0; i < store_.tiles.size(); ++i) store_.tiles[i] = {tiles[2 * i], tiles[2 * i + 1]};
  expect(particles.size() == store_.tiles.size() * store_.tile_size());
  store_.data.resize_and_forget(particles.size());
  std::copy(particles.begin(), particles.end(), store_.data.data());
  after_ordering();
  expect(grid.size() == active_.at.size() * k_block_nodes * static_cast<std::size_t>(row_size()));
  grid_.resize_and_forget(grid.size());
  other_.resize_and_forget(grid.size());
  std::copy(grid.begin(), grid.end(), grid_.data());
  std::copy(booked.begin(), booked.end(), booked_.begin());
  std::copy(totals.begin(), totals.end(), totals_.begin());
  time_ = numbers[0], dt_ = numbers[1];
  extremes_ = {numbers[2], numbers[3], numbers[4], numbers[5], numbers[6]};
  counters_ = {counts[0], counts[1], counts[2], counts[3], counts[4], numbers[7], numbers[8]};
  temperature_low_ = numbers[9], temperature_high_ = numbers[10];
  next_identity_ = counts[5];
}

template class Engine<float>;
template class Engine<double>;

}  // namespace bake

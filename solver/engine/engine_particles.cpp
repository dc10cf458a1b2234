// SPDX-License-Identifier: MIT
// Particles come and go: bodies and pouring, those that leave their block or the domain.
#include <algorithm>
#include <cstring>
#include <utility>

#include "solver/effects/fields.h"
#include "solver/engine/engine.h"
#include "solver/grid/sort_particles.h"
#include "solver/io/progress.h"

namespace bake {

template <class Real>
void Engine<Real>::reserve(std::size_t more) {
  store_.data.reserve((store_.tiles.size() + more / k_width<Real>)*store_.tile_size());
}

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
      const double nodes = geometry_.in_nodes(p.x[static_cast<std::size_t>(d)], d);
      *at[d] = static_cast<int>(nodes - 0.5) >> 2;
      x[d] = static_cast<Real>(nodes - 4 * *at[d]);
    }
    homes.push_back(find_home(block, x));
    homes.back().block = geometry_.wrapped(homes.back().block);
  }
  std::vector<std::uint32_t> order(particles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t i) { return std::pair(geometry_.linear(homes[i].block), particles[i].material); };
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
  std::vector<Real> start(fresh.tiles.size() * 12 * W);                  // velocity and affine velocity
  const int kept_velocity = physics_->column_of(field::Velocity::name);  // FLIP
  for (std::size_t t = 0; t < fresh.tiles.size(); ++t)
    for (int l = 0; l < W; ++l) {
      const std::size_t i = order[tile_first[t] + static_cast<std::size_t>(std::min(l, fresh.tiles[t].count - 1))];
      const NewParticle& p = particles[i];
      auto* columns = fresh.tile(t);
      for (int d = 0; d < 3; ++d) columns[k_position_column + d][l] = homes[i].x[d];
      columns[k_identity_column][l] = identity_bits<Real>(next_identity_ + static_cast<std::int64_t>(i));
      physics_->fill(columns, l, p.material, p.volume, *p.body);
      if (kept_velocity >= 0)
        for (int d = 0; d < 3; ++d) columns[kept_velocity + d][l] = static_cast<Real>(p.velocity[static_cast<std::size_t>(d)]);
      Real* s = start.data() + t * 12 * W + l;
      for (int d = 0; d < 3; ++d) s[d * W] = static_cast<Real>(p.velocity[static_cast<std::size_t>(d)]);
      const double C[9] = {0, -p.angular_velocity[2], p.angular_velocity[1],  p.angular_velocity[2],
                           0, -p.angular_velocity[0], -p.angular_velocity[1], p.angular_velocity[0],
                           0};
      for (int c = 0; c < 9; ++c) s[(3 + c) * W] = static_cast<Real>(C[c]);
    }
  next_identity_ += static_cast<std::int64_t>(particles.size());

  sort_particles<Real>(store_, &fresh, geometry_, nullptr);
  const ActiveBlocks before = active_;
  after_sorting();
  remap_blocks(before);
  sample_new(particles);
  scatter_new(fresh, start, poured);
  surface_travel_ = crumbs_travel_ = k_infinity;
}

template <class Real>
void Engine<Real>::scatter_new(const ParticleStore<Real>& fresh, const std::vector<Real>& start, bool poured) {
  constexpr int W = k_width<Real>;
  const auto rows_per_particle = static_cast<std::size_t>(kernel_->particle_rows());
  const Step<Real> step = current_step();
  BlockWork<Real> w = work(step);
  AlignedBuffer<Real> scattered, rows, columns;
  scattered.resize_and_forget(4 * static_cast<std::size_t>(scattered_row()) * W);
  rows.resize_and_forget(rows_per_particle * W);
  columns.resize_and_forget(fresh.tile_size());
  std::vector<BlockResult<Real>> results(fresh.blocks.size());
  for (std::size_t b = 0; b < fresh.blocks.size(); ++b) {
    const HomeBlock& block = fresh.blocks[b];
    const std::int32_t home = home_of(block.at);
    Report<Real> report;
    report.totals_wanted = poured;
    const Point origin = geometry_.origin(block.at);
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
                      scattered_row(), step, report);
      kernel_->to_rows(*physics_, x, reinterpret_cast<Lanes<Real>*>(scattered.data()), rows.data());
      for (int l = 0; l < count; ++l)
        kernel_->scatter_rows(w, home, {x[0][l], x[1][l], x[2][l]}, rows.data() + static_cast<std::size_t>(l) * rows_per_particle);
    }
    collect(report, results[b]);
    for (std::size_t i = 0; i < emitted_.size(); ++i) emitted_[i] += results[b].totals[i];
  }
  reduce(results);
}

template <class Real>
std::int32_t Engine<Real>::home_of(const BlockIndex& block) const {
  const std::size_t wanted = geometry_.linear(block);
  const auto found = std::lower_bound(store_.blocks.begin(), store_.blocks.end(), wanted,
                                      [&](const HomeBlock& b, std::size_t linear) { return geometry_.linear(b.at) < linear; });
  return static_cast<std::int32_t>(found - store_.blocks.begin());
}

template <class Real>
void Engine<Real>::after_sorting() {
  ++counters_.orderings;
  last_sorted_ = counters_.steps;
  particle_count_ = store_.particles();
  if (skins_) {
    skins_->find_vertices(store_);
    particle_count_ -= skins_->vertices_left();
  }
  active_.surround(store_.blocks, geometry_);
  colours_.find(store_.blocks, geometry_);
}

/// Moves the scattered rows to the slots that their blocks have now; new blocks are empty.
template <class Real>
void Engine<Real>::remap_blocks(const ActiveBlocks& before) {
  const std::size_t block_size = static_cast<std::size_t>(k_block_nodes) * static_cast<std::size_t>(scattered_row());
  AlignedBuffer<Real> rows;
  rows.resize_and_forget(active_.at.size() * block_size);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < active_.at.size(); ++i) {
    const std::size_t linear = geometry_.linear(active_.at[i]);
    const std::int32_t old = before.slot_of.empty() ? -1 : before.slot_of[linear];
    if (old < 0) continue;
    std::memcpy(rows.data() + i * block_size, scattered_.data() + static_cast<std::size_t>(old) * block_size, block_size * sizeof(Real));
  }
  scattered_.swap(rows);
  if (active_.at != before.at) surface_travel_ = k_infinity;
}

/// Retires or sorts particles that drifted out of their blocks, and all others with them, then scatters what the former owe.
template <class Real>
void Engine<Real>::migrate_particles(std::vector<Migrant<Real>>& migrants) {
  const double began = steady_seconds();
  for (const Migrant<Real>& e : migrants)
    if (e.broken) report_broken(e);
  std::vector<std::pair<std::int32_t, std::int32_t>> retired;
  const BlockWork<Real> faces = work(current_step());
  std::vector<Home<Real>> homes(migrants.size());
  for (std::size_t i = 0; i < migrants.size(); ++i) {
    const Migrant<Real>& e = migrants[i];
    const HomeBlock& block = store_.blocks[static_cast<std::size_t>(e.home)];
    auto* columns = store_.tile(static_cast<std::size_t>(e.tile));
    if (e.retired) {
      retired.push_back({e.tile, e.lane});
      ++counters_.retired;
      continue;
    }
    Real x[3];
    const int corner[3] = {4 * block.at.x, 4 * block.at.y, 4 * block.at.z};
    for (int d = 0; d < 3; ++d) {  // a particle may be so fast that it jumped over the blocks at the face
      const Real x_d = columns[k_position_column + d][e.lane];
      const Real inside = std::clamp(x_d, faces.low_face[d] - Real(corner[d]), faces.high_face[d] - Real(corner[d]));
      if (inside != x_d) ++counters_.clamped;
      x[d] = columns[k_position_column + d][e.lane] = inside;
    }
    homes[i] = find_home(block.at, x);
    homes[i].block = geometry_.wrapped(homes[i].block);
  }
  std::sort(retired.begin(), retired.end());
  if (!retired.empty()) surface_travel_ = k_infinity;
  const auto leave_out = [&](std::int32_t tile, std::int32_t lane) {
    return std::binary_search(retired.begin(), retired.end(), std::pair(tile, lane));
  };
  sort_particles<Real>(store_, nullptr, geometry_, retired.empty() ? std::function<bool(std::int32_t, std::int32_t)>() : leave_out);
  const ActiveBlocks before = active_;
  after_sorting();
  remap_blocks(before);
  BlockWork<Real> w = work(current_step());
  for (std::size_t i = 0; i < migrants.size(); ++i)
    if (!migrants[i].retired) kernel_->scatter_rows(w, home_of(homes[i].block), homes[i].x, migrants[i].rows.data());
  phases_.ordering += steady_seconds() - began;
}

/// Beside what was sampled of the others, the velocity of those that have just been added; they have the last identities.
template <class Real>
void Engine<Real>::sample_new(const std::vector<NewParticle>& added) {
  if (sampled_.empty()) return;
  for (const NewParticle& p : added) {
    sampled_.insert(sampled_.end(), p.velocity.begin(), p.velocity.end());
    sampled_.resize(sampled_.size() + static_cast<std::size_t>(physics_->sampled()) - p.velocity.size());
  }
}

#define BAKE_INSTANTIATE(Real)                                                                         \
  template void Engine<Real>::reserve(std::size_t);                                                    \
  template void Engine<Real>::add(const std::vector<NewParticle>&, bool);                              \
  template void Engine<Real>::scatter_new(const ParticleStore<Real>&, const std::vector<Real>&, bool); \
  template std::int32_t Engine<Real>::home_of(const BlockIndex&) const;                                \
  template void Engine<Real>::after_sorting();                                                         \
  template void Engine<Real>::remap_blocks(const ActiveBlocks&);                                       \
  template void Engine<Real>::migrate_particles(std::vector<Migrant<Real>>&);                          \
  template void Engine<Real>::sample_new(const std::vector<NewParticle>&);
BAKE_INSTANTIATE(float)
BAKE_INSTANTIATE(double)
#undef BAKE_INSTANTIATE

}  // namespace bake

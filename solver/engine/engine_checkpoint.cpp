// SPDX-License-Identifier: MIT
// What a checkpoint holds: particles, the scattered grid, and the sums so far.
#include <algorithm>
#include <cmath>

#include "solver/engine/engine.h"
#include "solver/grid/sort_particles.h"

namespace bake {
namespace {

void expect(bool fits) {
  if (!fits)
    throw InputError("the checkpoint's arrays do not fit together, allowed: a checkpoint written by the same version for this scene");
}

/// Infinite are only bounds and the like; nothing is NaN.
void expect_numbers(const std::vector<double>& numbers, bool infinite_allowed) {
  expect(std::all_of(numbers.begin(), numbers.end(), [&](double x) { return infinite_allowed ? !std::isnan(x) : std::isfinite(x); }));
}

/// Blocks lie within the domain in their order, each with the tiles behind those of the block before it, all with particles of a material.
template <class Real>
void check_blocks(const ParticleStore<Real>& store, const GridGeometry& geometry, std::size_t materials) {
  std::int64_t next_tile = 0;
  for (std::size_t i = 0; i < store.blocks.size(); ++i) {
    const HomeBlock& block = store.blocks[i];
    const int at[3] = {block.at.x, block.at.y, block.at.z};
    for (int d = 0; d < 3; ++d) expect(at[d] > 0 && at[d] < geometry.blocks(d) - 1);
    for (int d = 0; d < 3; ++d) expect(block.low[d] >= 0 && block.high[d] >= 0 && block.high[d] < k_tile_side);
    expect(geometry.wrapped(block.at) == block.at);
    expect(i == 0 || geometry.linear(store.blocks[i - 1].at) < geometry.linear(block.at));
    expect(block.first_tile == next_tile && block.tiles >= 0 && block.at_face == may_reach_face(block.at, geometry));
    next_tile += block.tiles;
  }
  expect(next_tile == static_cast<std::int64_t>(store.tiles.size()));
  for (const Tile& tile : store.tiles)
    expect(tile.count >= 0 && tile.count <= k_width<Real> && tile.material >= 0 && tile.material < static_cast<std::int64_t>(materials));
}

/// Each particle has an identity of its own among those that were given.
template <class Real>
void check_identities(const ParticleStore<Real>& store, std::int64_t given, std::int64_t retired) {
  expect(retired >= 0 && given >= 0 && given - retired == static_cast<std::int64_t>(store.particles()));
  expect(given < std::int64_t{1} << 32);
  std::vector<std::int64_t> identities;
  for (std::size_t t = 0; t < store.tiles.size(); ++t)
    for (int l = 0; l < store.tiles[t].count; ++l) identities.push_back(identity_of<Real>(store.tile(t), l));
  std::sort(identities.begin(), identities.end());
  expect(std::adjacent_find(identities.begin(), identities.end()) == identities.end());
  expect(identities.empty() || (identities.front() >= 0 && identities.back() < given));
}

}  // namespace

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
  out.add("grid", std::span<const Real>(scattered_.data(), scattered_.size()));
  const double numbers[] = {time_, dt_, crumbs_share_, crumbs_travel_};
  out.add("numbers", std::span<const double>(numbers));
  out.add("booked", std::span<const double>(booked_));
  out.add("totals", std::span<const double>(totals_));
  out.add("bounds", std::span<const double>(bounds_));
  out.add("highest", std::span<const double>(highest_));
  out.add("retired", std::span<const double>(retired_));
  out.add("emitted", std::span<const double>(emitted_));
  const std::int64_t counts[] = {counters_.steps,   counters_.particle_steps, counters_.orderings, counters_.clamped,
                                 counters_.retired, next_identity_,           last_sorted_,        crumbs_looked_};
  out.add("counts", std::span<const std::int64_t>(counts));
  std::vector<double> given;
  for (const Given& g : given_) given.insert(given.end(), {g.impulse[0], g.impulse[1], g.impulse[2], g.heat});
  if (!given.empty()) out.add("given", std::span<const double>(given));
  if (skins_) skins_->write(out);
  if (keeps_surface()) write_surface(out);
  if (!(physics_->settling.damping > 0)) return;
  const double settling[] = {double(settling_.now), settling_.time, settling_.still_for, double(settling_.is_still)};
  out.add("settling", std::span<const double>(settling));
}

template <class Real>
void Engine<Real>::read(const CheckpointReader& in) {
  const auto blocks = in.array<std::int32_t>("blocks"), tiles = in.array<std::int32_t>("tiles");
  const auto particles = in.array<Real>("particles"), grid = in.array<Real>("grid");
  const auto numbers = in.array<double>("numbers"), booked = in.array<double>("booked"), totals = in.array<double>("totals"),
             retired = in.array<double>("retired"), emitted = in.array<double>("emitted"), bounds = in.array<double>("bounds"),
             highest = in.array<double>("highest");
  const auto counts = in.array<std::int64_t>("counts");
  expect(blocks.size() % 12 == 0 && tiles.size() % 2 == 0 && numbers.size() == 4 && booked.size() == booked_.size() &&
         totals.size() == totals_.size() && retired.size() == totals.size() && emitted.size() == totals.size() &&
         bounds.size() == bounds_.size() && highest.size() == highest_.size() && counts.size() == 8);
  for (const auto* sums : {&booked, &totals, &retired, &emitted}) expect_numbers(*sums, false);
  for (const auto* largest : {&numbers, &bounds, &highest}) expect_numbers(*largest, true);
  expect(numbers[0] >= 0 && numbers[1] >= 0 && std::isfinite(numbers[0]) && std::isfinite(numbers[1]));
  expect(numbers[2] >= 0 && numbers[2] <= 1 && numbers[3] >= 0);
  for (std::size_t i = 0; i < 7; ++i) expect(counts[i] >= 0);
  expect(counts[7] >= -k_fewest_steps_per_look && counts[7] <= counts[0]);
  expect(counts[6] <= counts[0]);  // sorted last in a step that was done
  store_.blocks.resize(blocks.size() / 12);
  for (std::size_t i = 0; i < store_.blocks.size(); ++i) {
    const std::int32_t* b = &blocks[12 * i];
    HomeBlock& block = store_.blocks[i];
    block = {};
    block.at = {b[0], b[1], b[2]};
    block.first_tile = b[3];
    block.tiles = b[4];
    block.at_face = b[5] != 0;
    for (int k = 6; k < 12; ++k) expect(b[k] >= 0 && b[k] <= k_tile_side);
    for (int d = 0; d < 3; ++d)
      block.low[d] = static_cast<std::int8_t>(b[6 + 2 * d]), block.high[d] = static_cast<std::int8_t>(b[7 + 2 * d]);
  }
  store_.tiles.resize(tiles.size() / 2);
  for (std::size_t i = 0; i < store_.tiles.size(); ++i) store_.tiles[i] = {tiles[2 * i], tiles[2 * i + 1]};
  check_blocks(store_, geometry_, scene_.materials.size() + scene_.skins.size());  // skins are materials behind the others
  expect(particles.size() == store_.tiles.size() * store_.tile_size());
  store_.data.resize_and_forget(particles.size());
  std::copy(particles.begin(), particles.end(), store_.data.data());
  const Real drift = scene_.grid.kernel == KernelOrder::quadratic ? Real(0.5) : Real(0);  // as far as the block's tile of nodes reaches
  for (std::size_t t = 0; t < store_.tiles.size(); ++t)
    for (int d = 0; d < 3; ++d)
      for (int l = 0; l < k_width<Real>; ++l) {
        const Real x = store_.tile(t)[k_position_column + d][l];
        expect(x >= -drift && x < 5 + drift);
      }
  for (std::size_t t = 0; t < store_.tiles.size(); ++t)  // a step checks what it leaves: no run has written any of these
    for (const auto& column : physics_->columns)
      for (int c = column.first; c < column.first + column.width; ++c)
        for (int l = 0; l < store_.tiles[t].count; ++l)
          if (c != k_identity_column && !std::isfinite(store_.tile(t)[c][l]))
            throw InputError("the checkpoint's particle " + std::to_string(identity_of<Real>(store_.tile(t), l)) + ": found " +
                             column.name + " that is not finite, allowed: numbers");
  check_identities(store_, counts[5], counts[4]);
  if (!scene_.skins.empty()) take_skins(Sheets<Real>::read(scene_, in));
  after_sorting();
  if (skins_) skins_->find_forces(store_, geometry_, false);
  expect(grid.size() == active_.at.size() * k_block_nodes * static_cast<std::size_t>(scattered_row()));
  expect(std::all_of(grid.begin(), grid.end(), [](Real x) { return std::isfinite(x); }));
  scattered_.resize_and_forget(grid.size());
  std::copy(grid.begin(), grid.end(), scattered_.data());
  std::copy(booked.begin(), booked.end(), booked_.begin());
  std::copy(totals.begin(), totals.end(), totals_.begin());
  std::copy(retired.begin(), retired.end(), retired_.begin());
  std::copy(emitted.begin(), emitted.end(), emitted_.begin());
  if (!given_.empty()) {
    const auto given = in.array<double>("given");
    expect(given.size() == 4 * given_.size());
    expect_numbers(given, false);
    for (std::size_t i = 0; i < given_.size(); ++i) given_[i] = {{given[4 * i], given[4 * i + 1], given[4 * i + 2]}, given[4 * i + 3]};
  }
  time_ = numbers[0], dt_ = numbers[1], crumbs_share_ = numbers[2], crumbs_travel_ = numbers[3];
  std::copy(bounds.begin(), bounds.end(), bounds_.begin());
  std::copy(highest.begin(), highest.end(), highest_.begin());
  counters_ = {counts[0], counts[1], counts[2], counts[3], counts[4]};
  next_identity_ = counts[5];
  last_sorted_ = counts[6];
  crumbs_looked_ = counts[7];
  if (physics_->settling.damping > 0) {
    const auto settling = in.array<double>("settling");
    expect(settling.size() == 4 && settling[1] >= 0 && settling[2] >= 0);
    expect_numbers(settling, false);
    settling_ = {settling[0] != 0, settling[1], settling[2], settling[3] != 0};
    expect(!settling_.now || time_ == 0);
  }
  if (keeps_surface()) read_surface(in);
}

/// The volumes that the surface was measured from, and since when: it is measured from them again.
template <class Real>
void Engine<Real>::write_surface(CheckpointWriter& out) const {
  const Real* numbers = surface_volumes_.empty() ? nullptr : surface_volumes_.front().data();
  out.add("surface_volumes", std::span<const Real>(numbers, surface_volumes_.size() * k_block_nodes));
  std::vector<double> kept{surface_travel_};
  kept.insert(kept.end(), surface_covers_.begin(), surface_covers_.end());
  out.add("surface_kept", std::span<const double>(kept));
}

template <class Real>
void Engine<Real>::read_surface(const CheckpointReader& in) {
  const auto numbers = in.array<Real>("surface_volumes");
  const auto kept = in.array<double>("surface_kept");
  expect(!kept.empty() && kept[0] >= 0);
  expect_numbers(kept, true);
  surface_travel_ = kept[0];
  surface_covers_.assign(kept.begin() + 1, kept.end());
  contacts_.prepare(time_, baking_dt(), settling_.now);
  if (!(surface_travel_ <= scene_.surface.keep_dx) || surface_covers_ != contacts_.covers()) return;  // it will be measured anew
  expect(numbers.size() == active_.at.size() * k_block_nodes);
  expect(std::all_of(numbers.begin(), numbers.end(), [](Real x) { return std::isfinite(x) && x >= 0; }));
  surface_volumes_.resize(active_.at.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) surface_volumes_[i / k_block_nodes][i % k_block_nodes] = numbers[i];
  active_.find_touched(store_.blocks);
  contacts_.survey(active_);
  surface_.measure_again(surface_volumes_, physics_->surface_layer, physics_->surface_rounding, active_, geometry_, contacts_);
}

template void Engine<float>::write(CheckpointWriter&) const;
template void Engine<double>::write(CheckpointWriter&) const;
template void Engine<float>::read(const CheckpointReader&);
template void Engine<double>::read(const CheckpointReader&);

}  // namespace bake

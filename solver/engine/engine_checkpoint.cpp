// SPDX-License-Identifier: MIT
// What a checkpoint holds: particles, the scattered grid, and the sums so far.
#include <cmath>

#include "solver/engine/engine.h"

namespace bake {

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
  const double numbers[] = {time_, dt_};
  out.add("numbers", std::span<const double>(numbers));
  out.add("booked", std::span<const double>(booked_));
  out.add("totals", std::span<const double>(totals_));
  out.add("bounds", std::span<const double>(bounds_));
  out.add("highest", std::span<const double>(highest_));
  out.add("retired", std::span<const double>(retired_));
  out.add("emitted", std::span<const double>(emitted_));
  const std::int64_t counts[] = {counters_.steps,   counters_.particle_steps, counters_.orderings, counters_.clamped,
                                 counters_.retired, next_identity_,           last_sorted_};
  out.add("counts", std::span<const std::int64_t>(counts));
  if (skins_) skins_->write(out);
}

template <class Real>
void Engine<Real>::read(const CheckpointReader& in) {
  const auto blocks = in.array<std::int32_t>("blocks"), tiles = in.array<std::int32_t>("tiles");
  const auto particles = in.array<Real>("particles"), grid = in.array<Real>("grid");
  const auto numbers = in.array<double>("numbers"), booked = in.array<double>("booked"), totals = in.array<double>("totals"),
             retired = in.array<double>("retired"), emitted = in.array<double>("emitted"), bounds = in.array<double>("bounds"),
             highest = in.array<double>("highest");
  const auto counts = in.array<std::int64_t>("counts");
  const auto expect = [](bool fits) {
    if (!fits)
      throw InputError("the checkpoint's arrays do not fit this program's layout, allowed: a checkpoint written by the same version");
  };
  expect(blocks.size() % 12 == 0 && tiles.size() % 2 == 0 && numbers.size() == 2 && booked.size() == booked_.size() &&
         totals.size() == totals_.size() && retired.size() == totals.size() && emitted.size() == totals.size() &&
         bounds.size() == bounds_.size() && highest.size() == highest_.size() && counts.size() == 7);
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
    for (int d = 0; d < 3; ++d) expect(b[d] > 0 && b[d] < geometry_.blocks(d) - 1);
  }
  store_.tiles.resize(tiles.size() / 2);
  for (std::size_t i = 0; i < store_.tiles.size(); ++i) store_.tiles[i] = {tiles[2 * i], tiles[2 * i + 1]};
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
  if (!scene_.skins.empty()) take_skins(Sheets<Real>::read(scene_, in));
  after_sorting();
  if (skins_) skins_->find_forces(store_, geometry_, false);
  expect(grid.size() == active_.at.size() * k_block_nodes * static_cast<std::size_t>(scattered_row()));
  scattered_.resize_and_forget(grid.size());
  std::copy(grid.begin(), grid.end(), scattered_.data());
  std::copy(booked.begin(), booked.end(), booked_.begin());
  std::copy(totals.begin(), totals.end(), totals_.begin());
  std::copy(retired.begin(), retired.end(), retired_.begin());
  std::copy(emitted.begin(), emitted.end(), emitted_.begin());
  time_ = numbers[0], dt_ = numbers[1];
  std::copy(bounds.begin(), bounds.end(), bounds_.begin());
  std::copy(highest.begin(), highest.end(), highest_.begin());
  counters_ = {counts[0], counts[1], counts[2], counts[3], counts[4]};
  next_identity_ = counts[5];
  last_sorted_ = counts[6];
}

template void Engine<float>::write(CheckpointWriter&) const;
template void Engine<double>::write(CheckpointWriter&) const;
template void Engine<float>::read(const CheckpointReader&);
template void Engine<double>::read(const CheckpointReader&);

}  // namespace bake

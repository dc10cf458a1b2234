// SPDX-License-Identifier: MIT
// Where the nodes of a home block's tile are in the grid, and copies to and fro.
#pragma once

#include "solver/core/rows.h"
#include "solver/grid/grid.h"
#include "solver/grid/particle_store.h"
#include "solver/grid/tile.h"

namespace bake {

/// Row number of a block's node, coordinates -4..7 around the block.
BAKE_INLINE std::size_t grid_row(const HomeBlock& block, int x, int y, int z) {
  x += 4, y += 4, z += 4;
  const int slot = block.neighbour[(x >> 2) * 9 + (y >> 2) * 3 + (z >> 2)];
  return static_cast<std::size_t>(slot) * k_block_nodes + node_in_block(x & 3, y & 3, z & 3);
}

/// Calls visit(tile row, grid row, count) for runs of nodes along z in the touched range of a block.
template <class Visit>
BAKE_INLINE void for_each_run(const HomeBlock& block, Visit visit) {
  for (int x = block.low[0]; x <= block.high[0]; ++x)
    for (int y = block.low[1]; y <= block.high[1]; ++y) {
      const std::size_t tile_row = static_cast<std::size_t>(x * k_tile_plane + y * k_tile_side);
      const auto grid = [&](int z) { return grid_row(block, x - 1, y - 1, z - 1); };
      if (block.low[2] == 0) visit(tile_row, grid(0), 1);
      visit(tile_row + 1, grid(1), 4);
      if (block.high[2] > 4) visit(tile_row + 5, grid(5), block.high[2] - 4);
    }
}

/// Copies a block's nodes from grid rows of `row` numbers into the tile of a Gather.
template <class FromTile, int row, class Real>
void load_tile(const Real* grid, const HomeBlock& block, Real* tile) {
  for_each_run(block, [&](std::size_t tile_row, std::size_t grid_row, int count) {
    for (int i = 0; i < count; ++i) FromTile::load(grid + (grid_row + i) * row, tile + (tile_row + i) * FromTile::k_row);
  });
}

/// Adds a tile of scattered rows of `row` numbers to the grid and clears it.
template <int row, class Real>
void flush_tile(Real* grid, const HomeBlock& block, Real* tile) {
  using R = Row<Real, row>;
  for_each_run(block, [&](std::size_t tile_row, std::size_t grid_row, int count) {
    for (int i = 0; i < count; ++i) {
      R sum = R::load(grid + (grid_row + i) * row);
      sum.add(R::load(tile + (tile_row + i) * row), 1);
      sum.store(grid + (grid_row + i) * row);
      R::zero().store(tile + (tile_row + i) * row);
    }
  });
}

}  // namespace bake

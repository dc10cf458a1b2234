// SPDX-License-Identifier: MIT
// A tile: a copy of the 8x8x8 nodes -1..6 around a block, small enough for the first-level cache.
#pragma once

#include "solver/grid/kernel.h"

namespace bake {

inline constexpr int k_tile_side = 8;
/// Rows from one plane of a tile to the next: more than 64, so that planes do not share the sets of the first-level cache.
inline constexpr int k_tile_plane = 70;
inline constexpr int k_tile_nodes = k_tile_side * k_tile_plane;

/// For W stencils: where the row of their first node starts in a tile with `row` numbers per node.
template <class Real, KernelOrder order>
BAKE_INLINE void first_nodes(const Stencil<Real, order>& s, int row, std::int32_t* node) {
  const Lanes<Real> first = ((s.base[0] + 1) * Real(k_tile_plane) + (s.base[1] + 1) * Real(k_tile_side) + (s.base[2] + 1)) * Real(row);
  const auto whole = __builtin_convertvector(first, LaneMask<Real>);
  for (int l = 0; l < k_width<Real>; ++l) node[l] = static_cast<std::int32_t>(whole[l]);
}

}  // namespace bake

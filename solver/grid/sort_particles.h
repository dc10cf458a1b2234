// SPDX-License-Identifier: MIT
// Sorting: particles go to their home blocks, and are sorted within a block by material and cell.
#pragma once

#include <functional>
#include <vector>

#include "solver/grid/grid.h"
#include "solver/grid/particle_store.h"

namespace bake {

/// Sorts the particles of `store` and, behind them, of `more` (may be null), leaving out those for which `leave_out(tile, lane)` holds
/// (asked of `store` only). Stable: particles of one cell keep their order. Positions must lie inside the geometry. In place, where the
/// buffer's capacity allows: particles hardly move, so that the part of the store that is read and written at a time is small. Same result
/// for any number of threads.
template <class Real>
void sort_particles(ParticleStore<Real>& store, const ParticleStore<Real>* more, const GridGeometry& geometry,
                    const std::function<bool(std::int32_t tile, std::int32_t lane)>& leave_out);

/// Whether particles at home in this block may reach a face of the domain before they are sorted again.
bool may_reach_face(const BlockIndex& block, const GridGeometry& geometry);

/// The home block of a position that may have left `block`, and the position in it.
template <class Real>
struct Home {
  BlockIndex block;
  Real x[3];
  int cell;  ///< 0..63
};
template <class Real>
Home<Real> find_home(const BlockIndex& block, const Real (&x)[3]);

extern template void sort_particles(ParticleStore<float>&, const ParticleStore<float>*, const GridGeometry&,
                                    const std::function<bool(std::int32_t, std::int32_t)>&);
extern template void sort_particles(ParticleStore<double>&, const ParticleStore<double>*, const GridGeometry&,
                                    const std::function<bool(std::int32_t, std::int32_t)>&);

}  // namespace bake

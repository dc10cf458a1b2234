// SPDX-License-Identifier: MIT
#include "solver/engine/spring_back.h"

#include <algorithm>

#include "solver/core/parallel.h"
#include "solver/engine/block_tile.h"
#include "solver/grid/gather.h"
#include "solver/grid/scatter.h"

namespace bake {

namespace {

constexpr int k_row = 4;  ///< x, y, z and the mass

/// A home block's particles, and its nodes in a tile.
template <class Real, KernelOrder order>
class Block {
  using V = Lanes<Real>;
  using S = Stencil<Real, order>;
  using FromTile = Gather<Real, order, k_row>;
  using ToTile = Scatter<Real, order, k_row>;
  static constexpr int W = k_width<Real>;

 public:
  Block(const ParticleStore<Real>& store, std::int32_t index) : store_(store), block_(store.blocks[static_cast<std::size_t>(index)]) {}

  /// Adds V_0 K D^-1 w r / dx [N/m] and w m [kg].
  void scatter(const Physics<Real>& physics, double dx, Real* grid) const {
    const auto per_area = static_cast<Real>(Kernel<order>::inverse_d / (dx * dx));
    alignas(64) Real tile[k_tile_nodes * k_row] = {};
    for_each_tile([&](const V* columns, const S& stencil, int material, int count) {
      alignas(64) V coefficients[4 * k_row] = {};
      V stiffness;
      physics.find_springs(columns, material, coefficients[3], stiffness);
      for (int d = 0; d < 3; ++d) coefficients[(1 + d) * k_row + d] = per_area * stiffness;
      alignas(64) Real rows[W * ToTile::k_particle];
      ToTile::coefficients_to_rows(stencil, coefficients, 3, rows);
      ToTile::particles(stencil, rows, LaneMask<Real>{}, count, tile);
    });
    flush_tile<k_row>(grid, block_, tile);
  }

  /// The largest tr C(a).
  Real gather(const Real* grid) const {
    alignas(64) Real tile[k_tile_nodes * FromTile::k_row] = {};
    load_tile<FromTile, k_row>(grid, block_, tile);
    V most{};
    for_each_tile([&](const V*, const S& stencil, int, int) {  // lanes beyond the last repeat it
      V gathered[4 * k_row];
      FromTile::particles(tile, stencil, Real(1), gathered, [](int) {});
      most = max(most, gathered[k_row] + gathered[2 * k_row + 1] + gathered[3 * k_row + 2]);
    });
    return largest_lane(most);
  }

 private:
  template <class Visit>
  void for_each_tile(Visit visit) const {
    for (std::int32_t t = block_.first_tile; t < block_.first_tile + block_.tiles; ++t) {
      const auto at = static_cast<std::size_t>(t);
      const V* columns = store_.tile(at);
      const V x[3] = {columns[k_position_column], columns[k_position_column + 1], columns[k_position_column + 2]};
      visit(columns, S(x), store_.tiles[at].material, store_.tiles[at].count);
    }
  }

  const ParticleStore<Real>& store_;
  const HomeBlock& block_;
};

template <class Real, KernelOrder order>
double spring_back(const ParticleStore<Real>& store, const Physics<Real>& physics, double dx, const std::vector<BlockColumns>& colours,
                   std::size_t blocks) {
  const std::size_t row_of_block = k_block_nodes * k_row;
  AlignedBuffer<Real> rows;  // of each node: force over dx and then acceleration over dx, and mass
  rows.resize_and_forget(blocks * row_of_block);
  for (const BlockColumns& columns : colours)
    for_each_parallel(columns.size(), 1, [&](std::size_t c) {
      for (std::int32_t b = columns[c].first; b < columns[c].second; ++b) Block<Real, order>(store, b).scatter(physics, dx, rows.data());
    });
  for_each_parallel(blocks, 16, [&](std::size_t s) {
    for (Real* node = rows.data() + s * row_of_block; node < rows.data() + (s + 1) * row_of_block; node += k_row) {
      const Real per_mass = node[3] > 0 ? 1 / node[3] : Real(0);
      for (int d = 0; d < 3; ++d) node[d] *= per_mass;
    }
  });
  std::vector<Real> of_block(store.blocks.size());
  for_each_parallel(of_block.size(), 4,
                    [&](std::size_t b) { of_block[b] = Block<Real, order>(store, static_cast<std::int32_t>(b)).gather(rows.data()); });
  Real most = 0;
  for (const Real of : of_block) most = std::max(most, of);
  return static_cast<double>(most);
}

}  // namespace

template <class Real>
double spring_back(KernelOrder order, const ParticleStore<Real>& store, const Physics<Real>& physics, double dx,
                   const std::vector<BlockColumns>& colours, std::size_t blocks) {
  const auto one = order == KernelOrder::quadratic ? spring_back<Real, KernelOrder::quadratic> : spring_back<Real, KernelOrder::cubic>;
  return one(store, physics, dx, colours, blocks);
}

template double spring_back(KernelOrder, const ParticleStore<float>&, const Physics<float>&, double, const std::vector<BlockColumns>&,
                            std::size_t);
template double spring_back(KernelOrder, const ParticleStore<double>&, const Physics<double>&, double, const std::vector<BlockColumns>&,
                            std::size_t);

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/grid/sort_particles.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "tests/support/threads_restored.h"

namespace bake {
namespace {

/// One particle, wherever it is.
struct Seen {
  std::array<double, 3> x;  ///< from the grid's first node
  BlockIndex home;
  std::array<int, 3> cell;
  int material;
  double keepsake;
};

template <class Real>
class Ordering : public testing::Test {
 protected:
  static constexpr int W = k_width<Real>;
  static constexpr int k_columns = 5;  // position, identity, a keepsake
  static constexpr int k_most_tiles = 7;

  GridGeometry geometry{{0, 0, 0}, {1, 1, 1}, 1.0 / 24};

  /// Blocks of tiles with particles that have drifted up to a cell out of their blocks.
  ParticleStore<Real> drifted(int seed, int first_identity) const {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> uniform(-0.45, 5.45);
    ParticleStore<Real> store;
    store.columns = k_columns;
    for (const BlockIndex at : {BlockIndex{3, 3, 3}, BlockIndex{3, 3, 4}, BlockIndex{4, 3, 3}, BlockIndex{5, 5, 5}}) {
      HomeBlock block{};
      block.at = at;
      block.first_tile = static_cast<std::int32_t>(store.tiles.size());
      block.tiles = 1 + static_cast<std::int32_t>(random() % k_most_tiles);
      for (int t = 0; t < block.tiles; ++t)
        store.tiles.push_back({static_cast<std::int32_t>(random() % 3), 1 + static_cast<std::int32_t>(random() % W)});
      store.blocks.push_back(block);
    }
    store.data.resize_and_forget(store.tiles.size() * store.tile_size());
    int identity = first_identity;
    for (std::size_t t = 0; t < store.tiles.size(); ++t)
      for (int l = 0; l < W; ++l) {
        for (int d = 0; d < 3; ++d) store.tile(t)[d][l] = static_cast<Real>(uniform(random));
        if (l < store.tiles[t].count) ++identity;
        store.tile(t)[k_identity_column][l] = static_cast<Real>(identity);
        store.tile(t)[4][l] = static_cast<Real>(1000 + identity);
      }
    return store;
  }

  /// All particles by identity; repeated lanes of a tile are none.
  static std::map<int, Seen> census(const ParticleStore<Real>& store) {
    std::map<int, Seen> all;
    for (const HomeBlock& block : store.blocks)
      for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t)
        for (int l = 0; l < store.tiles[static_cast<std::size_t>(t)].count; ++l) {
          const auto* columns = store.tile(static_cast<std::size_t>(t));
          Seen seen{{}, block.at, {}, store.tiles[static_cast<std::size_t>(t)].material, static_cast<double>(columns[4][l])};
          const int first[3] = {4 * block.at.x, 4 * block.at.y, 4 * block.at.z};
          for (std::size_t d = 0; d < 3; ++d) {
            seen.x[d] = first[d] + static_cast<double>(columns[d][l]);
            seen.cell[d] = static_cast<int>(std::floor(static_cast<double>(columns[d][l]) - 0.5));
          }
          EXPECT_TRUE(all.emplace(static_cast<int>(columns[k_identity_column][l]), seen).second) << "an identity twice";
        }
    return all;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Ordering, Reals);

TYPED_TEST(Ordering, LosesNobodyAndMovesNobody) {
  const auto from = this->drifted(1, 0), more = this->drifted(2, 100000);
  ParticleStore<TypeParam> to = from;
  sort_particles<TypeParam>(to, &more, this->geometry, nullptr);
  auto before = this->census(from);
  before.merge(this->census(more));
  const auto after = this->census(to);
  ASSERT_EQ(before.size(), after.size());
  EXPECT_EQ(to.particles(), after.size());
  for (const auto& [identity, seen] : after) {
    ASSERT_TRUE(before.contains(identity));
    const Seen& was = before.at(identity);
    EXPECT_EQ(seen.material, was.material);
    EXPECT_EQ(seen.keepsake, was.keepsake);
    // counted from another block's first node: rounded once, below 8; and so are the sums with the block's corner, below 32
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(seen.x[d], was.x[d], 16 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()));
  }
}

TYPED_TEST(Ordering, EveryParticleIsAtHomeAndTilesHoldOneMaterial) {
  const auto from = this->drifted(3, 0);
  ParticleStore<TypeParam> to = from;
  sort_particles<TypeParam>(to, nullptr, this->geometry, nullptr);
  for (const auto& [identity, seen] : this->census(to))
    for (const int c : seen.cell) EXPECT_TRUE(c >= 0 && c <= 3) << identity;
  for (std::size_t b = 1; b < to.blocks.size(); ++b)
    EXPECT_LT(this->geometry.linear(to.blocks[b - 1].at), this->geometry.linear(to.blocks[b].at));
  const auto was = this->census(from);
  for (const auto& [identity, seen] : this->census(to)) EXPECT_EQ(seen.material, was.at(identity).material);
  for (std::size_t t = 0; t < to.tiles.size(); ++t) {  // lanes without a particle repeat the last one
    for (int l = to.tiles[t].count; l < k_width<TypeParam>; ++l)
      for (int c = 0; c < to.columns; ++c) EXPECT_EQ(to.tile(t)[c][l], to.tile(t)[c][to.tiles[t].count - 1]);
  }
}

TYPED_TEST(Ordering, WithinABlockParticlesAreSortedByMaterialThenCellAndOtherwiseKeepTheirOrder) {
  const auto from = this->drifted(4, 0);
  ParticleStore<TypeParam> once = from;
  sort_particles<TypeParam>(once, nullptr, this->geometry, nullptr);
  ParticleStore<TypeParam> twice = once;
  sort_particles<TypeParam>(twice, nullptr, this->geometry, nullptr);
  ASSERT_EQ(once.tiles.size(), twice.tiles.size());
  for (std::size_t i = 0; i < once.data.size(); ++i)
    ASSERT_EQ(once.data.data()[i], twice.data.data()[i]) << "ordering what is ordered changed it";
  for (const HomeBlock& block : once.blocks) {
    std::array<int, 3> last{-1, -1, -1};  // material, cell, identity: identities rise in the order of storage of `from`
    for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t)
      for (int l = 0; l < once.tiles[static_cast<std::size_t>(t)].count; ++l) {
        const auto* columns = once.tile(static_cast<std::size_t>(t));
        int cell[3];
        for (int d = 0; d < 3; ++d) cell[d] = static_cast<int>(std::floor(static_cast<double>(columns[d][l]) - 0.5));
        const std::array<int, 3> now{once.tiles[static_cast<std::size_t>(t)].material, node_in_block(cell[0], cell[1], cell[2]),
                                     static_cast<int>(columns[k_identity_column][l])};
        EXPECT_LT(last, now);
        last = now;
      }
  }
}

TYPED_TEST(Ordering, LeavesOutWhomItIsToldToLeaveOut) {
  const auto from = this->drifted(5, 0);
  ParticleStore<TypeParam> to = from;
  std::set<int> gone;
  const auto leave_out = [&](std::int32_t tile, std::int32_t lane) { return (tile + lane) % 3 == 0; };
  for (std::size_t t = 0; t < from.tiles.size(); ++t)
    for (int l = 0; l < from.tiles[t].count; ++l)
      if (leave_out(static_cast<std::int32_t>(t), l)) gone.insert(static_cast<int>(from.tile(t)[k_identity_column][l]));
  sort_particles<TypeParam>(to, nullptr, this->geometry, leave_out);
  const auto before = this->census(from), after = this->census(to);
  EXPECT_EQ(after.size() + gone.size(), before.size());
  for (const int identity : gone) EXPECT_FALSE(after.contains(identity));
}

TYPED_TEST(Ordering, IsTheSameForAnyNumberOfThreads) {
  const auto from = this->drifted(6, 0);
  const ThreadsRestored restored;
  ParticleStore<TypeParam> one = from;
  omp_set_num_threads(1);
  sort_particles<TypeParam>(one, nullptr, this->geometry, nullptr);
  for (const int n : {2, 3}) {
    omp_set_num_threads(n);
    ParticleStore<TypeParam> other = from;
    sort_particles<TypeParam>(other, nullptr, this->geometry, nullptr);
    ASSERT_EQ(one.data.size(), other.data.size());
    EXPECT_EQ(std::memcmp(one.data.data(), other.data.data(), one.data.size() * sizeof(TypeParam)), 0) << n << " threads";
  }
}

/// So many that they are not written all at once, by particles that come from the blocks around.
TYPED_TEST(Ordering, OfManyBlocksTakesNoSecondStore) {
  constexpr int W = k_width<TypeParam>;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.45, 5.45);
  ParticleStore<TypeParam> store;
  store.columns = this->k_columns;
  for (int x = 3; x < 7; ++x)
    for (int y = 3; y < 7; ++y)
      for (int z = 3; z < 7; ++z) {
        HomeBlock block{};
        block.at = {x, y, z};
        block.first_tile = static_cast<std::int32_t>(store.tiles.size());
        block.tiles = 256;
        store.blocks.push_back(block);
        store.tiles.resize(store.tiles.size() + 256, {0, W});
      }
  store.data.resize_and_forget(store.tiles.size() * store.tile_size());
  int identity = 0;
  for (std::size_t t = 0; t < store.tiles.size(); ++t)
    for (int l = 0; l < W; ++l) {
      for (int d = 0; d < 3; ++d) store.tile(t)[d][l] = static_cast<TypeParam>(uniform(random));
      store.tile(t)[k_identity_column][l] = static_cast<TypeParam>(++identity);
      store.tile(t)[4][l] = static_cast<TypeParam>(1000 + identity);
    }
  auto before = this->census(store);
  sort_particles<TypeParam>(store, nullptr, this->geometry, nullptr);
  const TypeParam* buffer = store.data.data();
  sort_particles<TypeParam>(store, nullptr, this->geometry, nullptr);
  EXPECT_EQ(store.data.data(), buffer) << "the second time there is room";
  const auto after = this->census(store);
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [number, seen] : after) {
    EXPECT_EQ(seen.keepsake, 1000 + number);
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(seen.x[d], before.at(number).x[d], 16 * std::numeric_limits<TypeParam>::epsilon());
  }
}

TYPED_TEST(Ordering, NobodyIsAnOrderingToo) {
  ParticleStore<TypeParam> none;
  none.columns = 5;
  sort_particles<TypeParam>(none, nullptr, this->geometry, nullptr);
  EXPECT_EQ(none.particles(), 0u);
  EXPECT_TRUE(none.blocks.empty());
}

TEST(Grid, KnowsWhichBlocksAHomeTouched) {
  const GridGeometry geometry({0, 0, 0}, {1, 1, 1}, 1. / 32);
  const BlockIndex middle{5, 5, 5};
  const auto touched = [&](int low, int high) {  // tile nodes along x; along y and z those of the block itself
    HomeBlock home{};
    home.at = middle;
    for (const int d : {1, 2}) home.low[d] = 1, home.high[d] = 4;
    home.low[0] = static_cast<std::int8_t>(low);
    home.high[0] = static_cast<std::int8_t>(high);
    std::vector<HomeBlock> homes{home};
    ActiveBlocks active;
    active.surround(homes, geometry);
    active.find_touched(homes);
    std::vector<int> along_x;
    for (std::size_t s = 0; s < active.at.size(); ++s)
      if (active.touched[s]) along_x.push_back(active.at[s].x - middle.x);
    std::sort(along_x.begin(), along_x.end());
    return along_x;
  };
  EXPECT_EQ(touched(0, 2), (std::vector<int>{-1, 0}));
  EXPECT_EQ(touched(1, 4), (std::vector<int>{0}));
  EXPECT_EQ(touched(4, 6), (std::vector<int>{0, 1}));
  EXPECT_EQ(touched(5, 7), (std::vector<int>{1}));
  EXPECT_EQ(touched(0, 7), (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ(touched(5, 2), (std::vector<int>{}));  // all its particles have gone
}

}  // namespace
}  // namespace bake

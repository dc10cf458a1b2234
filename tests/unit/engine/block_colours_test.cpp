// SPDX-License-Identifier: MIT
#include "solver/engine/block_colours.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/support/threads_restored.h"

namespace bake {
namespace {

constexpr double k_cell = 1;

/// The home blocks of an ellipsoid with half axes `a` [cells] of six particles a cell, as a loaf has, in tiles of sixteen.
std::vector<HomeBlock> ellipsoid(const Vector3& a, const GridGeometry& geometry) {
  std::vector<HomeBlock> blocks;
  for (int x = 0; x < geometry.blocks(0); ++x)
    for (int y = 0; y < geometry.blocks(1); ++y)
      for (int z = 0; z < geometry.blocks(2); ++z) {
        int cells = 0;
        for (int c = 0; c < 64; ++c) {
          const int at[3] = {4 * x + c / 16, 4 * y + c / 4 % 4, 4 * z + c % 4};
          double r2 = 0;
          for (std::size_t d = 0; d < 3; ++d) {
            const double middle = 0.5 * (geometry.low_face() + geometry.high_face(static_cast<int>(d)));
            r2 += std::pow((at[d] + 0.5 - middle) / a[d], 2);
          }
          cells += r2 < 1;
        }
        HomeBlock block{};
        block.at = {x, y, z};
        block.tiles = (6 * cells + 15) / 16;
        if (cells > 0) blocks.push_back(block);
      }
  return blocks;
}

/// Time of all sets one after the other if each is shared by `threads` that take the next item when they are free, over that of perfect
/// sharing.
double balance(const std::vector<std::vector<int>>& sets, std::size_t threads) {
  double all = 0, longest = 0;
  for (const auto& set : sets) {
    std::vector<double> busy(threads, 0);
    for (const int item : set) *std::min_element(busy.begin(), busy.end()) += item, all += item;
    longest += *std::max_element(busy.begin(), busy.end());
  }
  return all / (static_cast<double>(threads) * longest);
}

TEST(BlockColours, KeepSixteenThreadsBusyWithAHundredThousandParticles) {
  const GridGeometry geometry({0, 0, 0}, {80, 60, 40}, k_cell);
  const auto blocks = ellipsoid({26, 14, 10.9}, geometry);
  const int tiles = std::accumulate(blocks.begin(), blocks.end(), 0, [](int sum, const HomeBlock& b) { return sum + b.tiles; });
  ASSERT_NEAR(16 * tiles, 1e5, 5e3);
  BlockColours colours;
  colours.find(blocks, geometry);
  std::vector<std::vector<int>> columns, sets;
  for (const BlockColumns& of : colours.columns()) {
    auto& lengths = columns.emplace_back();
    for (const auto& [first, last] : of) {
      int length = 0;
      for (std::int32_t b = first; b < last; ++b) length += blocks[static_cast<std::size_t>(b)].tiles;
      lengths.push_back(length);
    }
  }
  for (const auto& set : colours.sets()) {
    auto& lengths = sets.emplace_back();
    for (const std::int32_t b : set) lengths.push_back(blocks[static_cast<std::size_t>(b)].tiles);
  }
  EXPECT_LT(balance(columns, 16), 0.8) << "then blocks are not worth it";
  EXPECT_GT(balance(sets, 16), 0.9);
}

/// Also where a ring of blocks closes, of an odd number, too.
TEST(BlockColours, NeverShareANode) {
  for (const double length : {48., 44.}) {
    const GridGeometry geometry({0, 0, 0}, {length, 40, 36}, k_cell, {true, false, true});
    std::vector<HomeBlock> blocks;
    for (int x = 2; x < 2 + geometry.period(0); ++x)
      for (int y = 3; y < 8; ++y)
        for (int z = 2; z < 2 + geometry.period(2); ++z) {
          HomeBlock block{};
          block.at = {x, y, z};
          block.tiles = 1 + (x * 7 + y * 3 + z) % 5;
          blocks.push_back(block);
        }
    BlockColours colours;
    colours.find(blocks, geometry);
    std::size_t count = 0;
    for (const auto& set : colours.sets()) {
      for (const std::int32_t b : set) {
        const BlockIndex at = blocks[static_cast<std::size_t>(b)].at;
        ++count;
        for (int n = 0; n < 27; ++n) {  // a block beside it, over an edge or a corner
          const BlockIndex near = geometry.wrapped(BlockIndex{at.x + n / 9 - 1, at.y + n / 3 % 3 - 1, at.z + n % 3 - 1});
          const auto is_there = [&](std::int32_t other) { return blocks[static_cast<std::size_t>(other)].at == near; };
          EXPECT_EQ(std::count_if(set.begin(), set.end(), is_there), n == 13);
        }
      }
    }
    EXPECT_EQ(count, blocks.size());
  }
}

TEST(BlockColours, VisitEveryBlockOnceAndNeighboursInOneOrder) {
  const GridGeometry geometry({0, 0, 0}, {40, 40, 40}, k_cell);
  const auto blocks = ellipsoid({15, 12, 14}, geometry);
  BlockColours colours;
  colours.find(blocks, geometry);
  const ThreadsRestored restored;
  std::vector<std::vector<int>> turns;
  for (const int n : {1, BlockColours::k_many_threads}) {
    omp_set_num_threads(n);
    std::vector<int> turn(blocks.size(), -1);
    std::atomic<int> next = 0;
    colours.for_each([&](std::int32_t b) {
      EXPECT_EQ(turn[static_cast<std::size_t>(b)], -1);
      turn[static_cast<std::size_t>(b)] = next++;
    });
    EXPECT_EQ(next, static_cast<int>(blocks.size()));
    turns.push_back(turn);
  }
  for (std::size_t a = 0; a < blocks.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const BlockIndex &p = blocks[a].at, &q = blocks[b].at;
      if (std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)}) > 1) continue;
      EXPECT_EQ(turns[0][a] < turns[0][b], turns[1][a] < turns[1][b]);
    }
}

}  // namespace
}  // namespace bake

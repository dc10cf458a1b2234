// SPDX-License-Identifier: MIT
// Which home blocks may scatter at the same time, and in which order: blocks of a colour never touch the same node, and a node's sums have
// one order whatever the number of threads: colour of the column along x and y, then colour along z.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/core/parallel.h"
#include "solver/grid/grid.h"

namespace bake {

/// Columns of blocks along z, each a range of home blocks.
using BlockColumns = std::vector<std::pair<std::int32_t, std::int32_t>>;

class BlockColours {
 public:
  /// From so many threads on they share single blocks, the longest first: there are too few columns, of too different lengths. Fewer share
  /// columns, whose neighbouring blocks find the nodes between them in the cache.
  static constexpr int k_many_threads = 8;

  /// `blocks`: in the order of the store.
  void find(const std::vector<HomeBlock>& blocks, const GridGeometry& geometry) {
    const int per_axis = geometry.any_periodic() ? 3 : 2;
    const auto along = static_cast<std::size_t>(per_axis);
    columns_.assign(along * along, {});
    sets_.assign(along * along * along, {});
    colour_along_z_.resize(blocks.size());
    colours_along_z_ = per_axis;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const BlockIndex& b = blocks[i].at;
      const bool same = i > 0 && blocks[i - 1].at.x == b.x && blocks[i - 1].at.y == b.y;
      const auto column_colour = static_cast<std::size_t>(geometry.colour(b.x, 0) * per_axis + geometry.colour(b.y, 1));
      const auto number = static_cast<std::int32_t>(i);
      BlockColumns& columns = columns_[column_colour];
      if (same)
        columns.back().second = number + 1;
      else
        columns.push_back({number, number + 1});
      colour_along_z_[i] = static_cast<std::int8_t>(geometry.colour(b.z, 2));
      sets_[column_colour * along + static_cast<std::size_t>(colour_along_z_[i])].push_back(number);
    }
    for (auto& set : sets_)
      std::stable_sort(set.begin(), set.end(), [&](std::int32_t a, std::int32_t b) {
        return blocks[static_cast<std::size_t>(a)].tiles > blocks[static_cast<std::size_t>(b)].tiles;
      });
  }

  /// By colours along x and y; those of one never touch the same node.
  const std::vector<BlockColumns>& columns() const { return columns_; }
  /// By colours along x, y and z, each with its blocks of most tiles first.
  const std::vector<std::vector<std::int32_t>>& sets() const { return sets_; }

  /// Calls visit(block) for every block, those that touch the same nodes one after the other and in the same order for any number of
  /// threads.
  template <class Visit>
  void for_each(Visit visit) const {
    if (omp_get_max_threads() >= k_many_threads) {
      for (const auto& set : sets_)
#pragma omp parallel for schedule(dynamic, 1)
        for (std::size_t i = 0; i < set.size(); ++i) visit(set[i]);
      return;
    }
    for (const BlockColumns& columns : columns_)
      for_each_parallel(columns.size(), 1, [&](std::size_t c) {
        for (int colour = 0; colour < colours_along_z_; ++colour)
          for (std::int32_t b = columns[c].first; b < columns[c].second; ++b)
            if (colour_along_z_[static_cast<std::size_t>(b)] == colour) visit(b);
      });
  }

 private:
  std::vector<BlockColumns> columns_;
  std::vector<std::vector<std::int32_t>> sets_;
  std::vector<std::int8_t> colour_along_z_;
  int colours_along_z_ = 2;
};

}  // namespace bake

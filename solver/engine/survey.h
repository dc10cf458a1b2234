// SPDX-License-Identifier: MIT
// What contact asks of the nodes beside a solid: how far away they are, and the columns of nodes across its face. It is found once for as
// long as the solid stands still.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "solver/boundary/scripted.h"
#include "solver/grid/grid.h"

namespace bake {

/// Where something touches. What is kept of a node is found by the node's number.
struct Place {
  Point x;                  ///< [m]
  std::int64_t block = -1;  ///< linear number of the node's block; -1: not a node
  std::size_t node = 0;
  Place(const Point& point) : x(point) {}  // NOLINT: a point is a place
  Place(const GridGeometry& geometry, const BlockIndex& block_of, int node_of)
      : x(node_position(geometry.origin(block_of), geometry.dx(), node_of)),
        block(static_cast<std::int64_t>(geometry.linear(block_of))),
        node(static_cast<std::size_t>(node_of)) {}
};

/// The nodes along the axis nearest to a solid's normal, through one node beside it. Node j is j steps outwards of that one.
struct Column {
  static constexpr int k_furthest = 6;  ///< from -2 dx, at |n| = 1 / sqrt(3)
  Vector3 normal;                       ///< outward, at the node
  std::int8_t axis = 0, outward = 1;    ///< the axis, and 1 or -1
  std::int8_t free = -1;                ///< the first node that is dx or more away; -1: none is near
  std::int8_t count = 0;                ///< of `filled`
  double share = 0;                     ///< the node's distance over that of node `free`
  double free_filled = 0;               ///< of node `free`
  /// What dough that fills the column to the face gives nodes free - 1, free - 2, ..., over what it gives a node inside.
  std::array<double, k_furthest> filled{};
};

/// Of a node at `x`, which is `distance` [m] from the solid (negative inside).
Column find_column(const ScriptedShape& solid, const RigidState& pose, const Point& x, double distance, double dx);

/// The integral of the quadratic B-spline from `d` on.
double spline_beyond(double d);

/// The nodes beside one solid.
class Survey {
 public:
  /// Forgets everything if the pose is not that of the last call. Returns whether it is.
  bool stands_at(const RigidState& pose);
  /// Surveys those of the blocks that are new and near the solid. Parallel over blocks.
  void add(const ScriptedShape& solid, const ActiveBlocks& active, const GridGeometry& geometry,
           const std::function<bool(const BlockIndex&)>& is_near);
  /// Distance of a node [m]; none if that is not kept.
  std::optional<double> distance(const Place& at) const {
    const Block* block = block_of(at);
    return block ? std::optional(block->distance[at.node]) : std::nullopt;
  }
  /// Column through a node; null if that is not kept.
  const Column* column(const Place& at) const {
    const Block* block = block_of(at);
    return block && block->number[at.node] >= 0 ? &block->columns[static_cast<std::size_t>(block->number[at.node])] : nullptr;
  }
  std::size_t bytes() const;

 private:
  struct Block {
    std::array<double, k_block_nodes> distance;
    std::array<std::int8_t, k_block_nodes> number;  ///< among `columns`, or -1
    std::vector<Column> columns;
  };
  enum : std::int32_t { unknown = -2, far = -1 };
  const Block* block_of(const Place& at) const {
    if (at.block < 0 || number_.empty()) return nullptr;
    const std::int32_t number = number_[static_cast<std::size_t>(at.block)];
    return number < 0 ? nullptr : &blocks_[static_cast<std::size_t>(number)];
  }
  Block find(const ScriptedShape& solid, const BlockIndex& block, const GridGeometry& geometry) const;

  std::optional<RigidState> pose_;
  std::vector<std::int32_t> number_;  ///< among `blocks_`, by linear block number
  std::vector<Block> blocks_;
};

}  // namespace bake

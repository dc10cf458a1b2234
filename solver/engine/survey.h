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
#include "solver/core/vector3.h"
#include "solver/grid/grid.h"

namespace bake {

/// Is `x` in the box, or within `reach` of it along each axis?
inline bool is_within(const Box3& box, const Point& x, double reach) {
  for (std::size_t d = 0; d < 3; ++d)
    if (x[d] > box.high[d] + reach || x[d] < box.low[d] - reach) return false;
  return true;
}

/// The middle of a block's nodes [m].
inline Point middle_of(const BlockIndex& block, const GridGeometry& geometry) {
  return geometry.origin(block) + (1.5 * geometry.dx()) * Vector3{1, 1, 1};
}

/// Some nodes of a block: bit n is node n.
using NodeBits = std::uint64_t;
static_assert(k_block_nodes == 64);
inline constexpr NodeBits k_all_nodes = ~NodeBits{0};

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

/// The share that a solid leaves to the dough of what is averaged into phi~ (surface.h), at `d` node distances from its face.
inline double share_left(double d) { return 1 - (spline_beyond(d - 1) + 2 * spline_beyond(d) + spline_beyond(d + 1)) / 4; }

/// The nodes beside one solid.
class Survey {
 public:
  static constexpr double k_reach = 2.5;  ///< of what contact and the surface ask, in node distances from a solid
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
  /// share_left of a node; none if that is not kept.
  std::optional<double> share_left(const Place& at) const {
    const Block* block = block_of(at);
    return block ? std::optional(block->share_left[at.node]) : std::nullopt;
  }
  /// Outward normal at a node within `k_reach`; null if that is not kept.
  const Vector3* normal(const Place& at) const {
    const Block* block = block_of(at);
    return block ? &block->normal[at.node] : nullptr;
  }
  /// Distance of a block's middle [m]; none if that is not kept. Its linear number.
  std::optional<double> distance_of_middle(std::size_t linear) const {
    const Block* block = block_of(linear);
    return block ? std::optional(block->middle) : std::nullopt;
  }
  /// Column through a node; null if that is not kept.
  const Column* column(const Place& at) const {
    const Block* block = block_of(at);
    return block && block->number[at.node] >= 0 ? &block->columns[static_cast<std::size_t>(block->number[at.node])] : nullptr;
  }
  /// Is the node known to be further than `k_reach` from the solid?
  bool is_far(const Place& at) const { return at.block >= 0 && is_far(static_cast<std::size_t>(at.block)); }
  /// Is the block? Its linear number.
  bool is_far(std::size_t block) const { return block < number_.size() && number_[block] == far; }
  /// The nodes of a block that lie within dx of the solid or in it; all of them if that is not kept.
  NodeBits near(std::size_t block) const {
    if (is_far(block)) return 0;
    const Block* found = block_of(block);
    return found ? found->near : k_all_nodes;
  }
  std::size_t bytes() const;

 private:
  struct Block {
    double middle;  ///< distance of its middle
    std::array<double, k_block_nodes> distance, share_left;
    std::array<Vector3, k_block_nodes> normal;      ///< within k_reach
    NodeBits near = 0;                              ///< within dx of the solid or in it
    std::array<std::int8_t, k_block_nodes> number;  ///< among `columns`, or -1
    std::vector<Column> columns;
  };
  enum : std::int32_t { unknown = -2, far = -1 };
  const Block* block_of(std::size_t linear) const {
    if (linear >= number_.size() || number_[linear] < 0) return nullptr;
    return &blocks_[static_cast<std::size_t>(number_[linear])];
  }
  const Block* block_of(const Place& at) const { return at.block < 0 ? nullptr : block_of(static_cast<std::size_t>(at.block)); }
  Block find(const ScriptedShape& solid, const BlockIndex& block, const GridGeometry& geometry) const;

  std::optional<RigidState> pose_;
  std::vector<std::int32_t> number_;  ///< among `blocks_`, by linear block number
  std::vector<Block> blocks_;
};

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/engine/survey.h"

#include <algorithm>
#include <cmath>

#include "solver/core/parallel.h"

namespace bake {

double spline_beyond(double d) {
  const double a = std::min(std::abs(d), 1.5);
  const double rest = a <= 0.5 ? 0.5 - a * (0.75 - a * a / 3) : (1.5 - a) * (1.5 - a) * (1.5 - a) / 6;
  return d > 0 ? rest : 1 - rest;
}

Column find_column(const ScriptedShape& solid, const RigidState& pose, const Point& x, double distance, double dx) {
  Column column;
  column.normal = solid.normal(pose, x);
  const double d = distance / dx;
  if (d < -2) return column;
  const Vector3& n = column.normal;
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(n[i]) > std::abs(n[axis]) + 1e-6) axis = i;
  column.axis = static_cast<std::int8_t>(axis);
  column.outward = n[axis] > 0 ? 1 : -1;
  const auto distance_of = [&](int j) {
    Point y = x;
    y[axis] += j * column.outward * dx;
    return solid.distance(pose, y) / dx;
  };
  int k = 0;
  double distances[Column::k_furthest + 1] = {d};  // of the nodes from this one to k
  while (distances[k] < 1 - 1e-6 && k < Column::k_furthest) ++k, distances[k] = distance_of(k);
  const double d_k = distances[k];
  if (d_k < 1 - 1e-6) return column;
  column.free = static_cast<std::int8_t>(k);
  column.share = d / d_k;
  column.free_filled = 1 - spline_beyond(d_k);
  double last = d_k;
  for (int j = k - 1; k - j <= Column::k_furthest; --j) {
    const double d_j = j >= 0 ? distances[j] : distance_of(j);
    if (d_j >= last || d_j < -1.5) break;
    column.filled[static_cast<std::size_t>(column.count++)] = 1 - spline_beyond(d_j);
    last = d_j;
  }
  return column;
}

bool Survey::stands_at(const RigidState& pose) {
  if (pose_ && pose_->rotation == pose.rotation && pose_->centre == pose.centre) return true;
  pose_ = pose;
  number_.clear();
  blocks_.clear();
  return false;
}

void Survey::add(const ScriptedShape& solid, const ActiveBlocks& active, const GridGeometry& geometry,
                 const std::function<bool(const BlockIndex&)>& is_near) {
  number_.resize(geometry.block_count(), unknown);
  std::vector<std::size_t> fresh;
  const std::size_t before = blocks_.size();
  for (std::size_t s = 0; s < active.at.size(); ++s) {
    std::int32_t& number = number_[geometry.linear(active.at[s])];
    if (number != unknown) continue;
    const bool near = is_near(active.at[s]);
    number = near ? static_cast<std::int32_t>(before + fresh.size()) : std::int32_t{far};
    if (near) fresh.push_back(s);
  }
  if (fresh.empty()) return;
  blocks_.resize(before + fresh.size());
  for_each_parallel(fresh.size(), 1, [&](std::size_t i) { blocks_[before + i] = find(solid, active.at[fresh[i]], geometry); });
}

Survey::Block Survey::find(const ScriptedShape& solid, const BlockIndex& at, const GridGeometry& geometry) const {
  const double dx = geometry.dx(), reach = k_reach * dx;
  const Box3 bounds = solid.bounds(*pose_);
  Block block;
  block.middle = solid.distance(*pose_, middle_of(at, geometry));
  for (int n = 0; n < k_block_nodes; ++n) {
    const Point x = node_position(geometry.origin(at), dx, n);
    const double distance = solid.distance(*pose_, x);
    const bool has_column = distance <= dx && distance >= -2 * dx;
    block.distance[static_cast<std::size_t>(n)] = distance;
    block.share_left[static_cast<std::size_t>(n)] = is_within(bounds, x, reach) && distance <= reach ? bake::share_left(distance / dx) : 1;
    block.normal[static_cast<std::size_t>(n)] = distance <= reach ? solid.normal(*pose_, x) : Vector3{0, 0, 0};
    if (distance <= dx) block.near |= NodeBits{1} << n;
    block.number[static_cast<std::size_t>(n)] = has_column ? static_cast<std::int8_t>(block.columns.size()) : std::int8_t{-1};
    if (has_column) block.columns.push_back(find_column(solid, *pose_, x, distance, dx));
  }
  block.columns.shrink_to_fit();
  return block;
}

std::size_t Survey::bytes() const {
  std::size_t bytes = number_.capacity() * sizeof(std::int32_t) + blocks_.capacity() * sizeof(Block);
  for (const Block& block : blocks_) bytes += block.columns.capacity() * sizeof(Column);
  return bytes;
}

}  // namespace bake

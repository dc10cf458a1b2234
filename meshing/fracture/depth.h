// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "meshing/fracture/topology.h"

namespace bake {

/// Distances of points from the boundary of a mesh [m].
class Depth {
 public:
  explicit Depth(const Topology& topology);
  ~Depth();
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;
  double operator()(const Point& x) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace bake

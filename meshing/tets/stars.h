// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <span>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// The tetrahedra at each vertex, in ascending order.
class Stars {
 public:
  Stars(const std::vector<Tet>& tets, std::size_t vertices) : starts_(vertices + 1, 0), list_(4 * tets.size()) {
    for (const Tet& tet : tets)
      for (const std::int32_t v : tet) ++starts_[v + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::int64_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t t = 0; t < tets.size(); ++t)
      for (const std::int32_t v : tets[t]) list_[next[v]++] = static_cast<std::int32_t>(t);
  }
  std::span<const std::int32_t> at(std::int32_t v) const {
    return {list_.data() + starts_[v], static_cast<std::size_t>(starts_[v + 1] - starts_[v])};
  }

 private:
  std::vector<std::int64_t> starts_;
  std::vector<std::int32_t> list_;
};

}  // namespace bake

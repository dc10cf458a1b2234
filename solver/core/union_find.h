// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace bake {

/// Disjoint sets of whole numbers that can be united. The smallest member represents its set.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t find(std::int32_t a) {
    while (parent_[at(a)] != a) a = parent_[at(a)] = parent_[at(parent_[at(a)])];
    return a;
  }
  void unite(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) parent_[at(b)] = a;
    if (b < a) parent_[at(a)] = b;
  }

 private:
  static std::size_t at(std::int32_t a) { return static_cast<std::size_t>(a); }
  std::vector<std::int32_t> parent_;
};

}  // namespace bake

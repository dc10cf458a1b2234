// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/manifold.h"

#include <algorithm>

#include "meshing/tets/stars.h"

namespace bake {
namespace {

class Repair {
 public:
  Repair(const std::vector<Point>& points, const std::vector<Tet>& tets, const std::vector<Tet>& neighbours, std::vector<char>& kept)
      : points_(points), tets_(tets), neighbours_(neighbours), kept_(kept), stars_(tets, points.size()) {}

  void run() {
    do {
      find_boundary();
      dropped_ = false;
      for (const auto& [a, b] : odd_edges()) keep_largest_group(around(a, b));
      for (std::size_t v = 0; v < points_.size(); ++v)
        if (outer_[v]) keep_largest_group(around(static_cast<std::int32_t>(v)));
      if (!dropped_) drop_shreds();
    } while (dropped_);
  }

 private:
  using Edge = std::pair<std::int32_t, std::int32_t>;
  using Group = std::vector<std::int32_t>;  ///< of tetrahedra

  bool is_kept(std::int32_t t) const { return t >= 0 && kept_[t]; }

  /// Edges of boundary faces, and `outer_`: the vertices on the boundary.
  void find_boundary() {
    outer_.assign(points_.size(), 0);
    edges_.clear();
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      for (int k = 0; kept_[t] && k < 4; ++k) {
        if (is_kept(neighbours_[t][k])) continue;
        for (int i = 0; i < 3; ++i) {
          const std::int32_t a = tets_[t][k_faces[k][i]], b = tets_[t][k_faces[k][(i + 1) % 3]];
          edges_.push_back(std::minmax(a, b));
          outer_[a] = 1;
        }
      }
    }
    std::sort(edges_.begin(), edges_.end());
  }

  /// The edges that more than two boundary faces share.
  std::vector<Edge> odd_edges() const {
    std::vector<Edge> odd;
    for (std::size_t i = 0; i + 2 < edges_.size(); ++i)
      if (edges_[i] == edges_[i + 2] && (odd.empty() || odd.back() != edges_[i])) odd.push_back(edges_[i]);
    return odd;
  }

  Group around(std::int32_t v) const {
    Group group;
    for (const std::int32_t t : stars_.at(v))
      if (kept_[t]) group.push_back(t);
    return group;
  }
  Group around(std::int32_t a, std::int32_t b) const {
    Group group = around(a);
    std::erase_if(group, [&](std::int32_t t) { return std::find(tets_[t].begin(), tets_[t].end(), b) == tets_[t].end(); });
    return group;
  }

  /// Removes from `among` (sorted) its first tetrahedron and all that are connected to it through faces, and returns them sorted.
  Group take_group(Group& among) const {
    Group group{among.front()};
    among.erase(among.begin());
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (const std::int32_t other : neighbours_[group[i]]) {
        const auto found = std::lower_bound(among.begin(), among.end(), other);
        if (found == among.end() || *found != other) continue;
        group.push_back(other);
        among.erase(found);
      }
    }
    return group;
  }

  double volume(const Group& group) const {
    double sum = 0;
    for (const std::int32_t t : group) sum += tet_volume(points_, tets_[t]);
    return sum;
  }

  void drop(const Group& group) {
    for (const std::int32_t t : group) kept_[t] = 0;
    dropped_ = true;
  }

  void keep_largest_group(Group among) {
    Group largest;
    while (!among.empty()) {
      Group group = take_group(among);
      if (volume(group) > volume(largest)) std::swap(group, largest);
      if (!group.empty()) drop(group);
    }
  }

  void drop_shreds() {
    std::vector<char> seen(tets_.size(), 0);
    for (std::size_t first = 0; first < tets_.size(); ++first) {
      if (!kept_[first] || seen[first]) continue;
      Group group{static_cast<std::int32_t>(first)};
      seen[first] = 1;
      bool has_inner = false;
      for (std::size_t i = 0; i < group.size(); ++i) {
        has_inner |= std::any_of(tets_[group[i]].begin(), tets_[group[i]].end(), [&](std::int32_t v) { return !outer_[v]; });
        for (const std::int32_t other : neighbours_[group[i]])
          if (is_kept(other) && !seen[other]) seen[other] = 1, group.push_back(other);
      }
      if (!has_inner) drop(group);
    }
  }

  const std::vector<Point>& points_;
  const std::vector<Tet>& tets_;
  const std::vector<Tet>& neighbours_;
  std::vector<char>& kept_;
  Stars stars_;
  std::vector<char> outer_;
  std::vector<Edge> edges_;
  bool dropped_ = false;
};

}  // namespace

TetMesh manifold_part(const std::vector<Point>& points, const std::vector<Tet>& tets, std::vector<char> kept) {
  const std::vector<Tet> neighbours = tet_neighbours(tets, points.size());
  Repair(points, tets, neighbours, kept).run();
  TetMesh mesh;
  for (std::size_t t = 0; t < tets.size(); ++t)
    if (kept[t]) mesh.tets.push_back(tets[t]);
  mesh.points = take_used_points(points, mesh.tets);
  return mesh;
}

}  // namespace bake

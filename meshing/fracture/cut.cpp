// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/cut.h"

#include <algorithm>

namespace bake {
namespace {

/// For each corner of a tetrahedron the smallest corner to which it is connected.
using Sides = std::array<std::int8_t, 4>;

/// Corners connected by whole edges, for each of the 64 sets of broken ones (bit e: edge e of k_tet_edges).
constexpr std::array<Sides, 64> k_sides = [] {
  std::array<Sides, 64> table{};
  for (int broken = 0; broken < 64; ++broken) {
    Sides side{0, 1, 2, 3};
    for (int repeat = 0; repeat < 3; ++repeat)
      for (int e = 0; e < 6; ++e) {
        if (broken >> e & 1) continue;
        const auto least = std::min(side[k_tet_edges[e].a], side[k_tet_edges[e].b]);
        side[k_tet_edges[e].a] = side[k_tet_edges[e].b] = least;
      }
    table[broken] = side;
  }
  return table;
}();

class Cutter {
 public:
  Cutter(const Topology& topology, const std::vector<std::int32_t>& broken_at)
      : topology_(topology), tets_(topology.mesh.tets), broken_at_(broken_at) {}

  CutSurface run() {
    find_cut_tets();
    mark_split_boundary();
    for (const BoundaryFace& face : topology_.boundary) add_boundary(face);
    const std::size_t skin = corners_.size() / 3;
    for (const std::int32_t t : cut_tets_) add_cracks(t);
    return numbered(skin);
  }

 private:
  int broken_mask(std::int32_t t) const {
    int mask = 0;
    for (int e = 0; e < 6; ++e) mask |= (broken_at_[topology_.tet_edges[t][e]] >= 0) << e;
    return mask;
  }
  Sides sides(std::int32_t t) const { return k_sides[broken_mask(t)]; }

  void find_cut_tets() {
    joined_.assign(broken_at_.size(), 0);
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      const int mask = broken_mask(static_cast<std::int32_t>(t));
      if (mask == 0) continue;
      const Sides side = k_sides[mask];
      if (side != Sides{0, 0, 0, 0}) cut_tets_.push_back(static_cast<std::int32_t>(t));
      for (int e = 0; e < 6; ++e)
        if (side[k_tet_edges[e].a] == side[k_tet_edges[e].b]) joined_[topology_.tet_edges[t][e]] = 1;
    }
  }

  static bool is_split(const Sides& side, int opposite) {
    const auto& f = k_faces[opposite];
    return side[f[0]] != side[f[1]] || side[f[0]] != side[f[2]];
  }

  /// Marks the midpoints of the edges of split boundary faces: they are also vertices of the faces beside them.
  void mark_split_boundary() {
    active_.assign(broken_at_.size(), 0);
    for (const auto& [t, opposite] : topology_.boundary) {
      if (!is_split(sides(t), opposite)) continue;
      for (int i = 0; i < 3; ++i) active_[edge(t, k_faces[opposite][i], k_faces[opposite][(i + 1) % 3])] = 1;
    }
  }

  std::int32_t edge(std::int32_t t, int a, int b) const { return topology_.tet_edges[t][k_edge_between[a][b]]; }

  /// The node of the given corners of tetrahedron t, on the side of those for which `own` holds.
  template <class Own>
  CutNode node(std::int32_t t, std::initializer_list<int> corners, Own own) const {
    std::array<std::pair<std::int32_t, bool>, 4> list;
    int n = 0;
    for (const int c : corners) list[n++] = {tets_[t][c], own(c)};
    std::sort(list.begin(), list.begin() + n);
    CutNode result;
    result.owners = 0;
    for (int i = 0; i < n; ++i) {
      result.vertices[i] = list[i].first;
      result.owners |= list[i].second << i;
    }
    return result;
  }

  CutNode vertex(std::int32_t t, int a) const {
    return node(t, {a}, [](int) { return true; });
  }
  /// The midpoint of edge ab on the side of a. Both sides share one node if any tetrahedron connects them.
  CutNode midpoint(std::int32_t t, int a, int b) const {
    const std::int32_t e = edge(t, a, b);
    const bool whole = broken_at_[e] < 0 || joined_[e];
    return node(t, {a, b}, [&](int c) { return whole || c == a; });
  }
  CutNode centre(std::int32_t t, const Sides& side, int a) const {
    return node(t, {0, 1, 2, 3}, [&](int c) { return side[c] == side[a]; });
  }

  /// The centroid of face abc on the side of a. Sides that either of its two tetrahedra connects share one node.
  CutNode face_centre(std::int32_t t, const Sides& side, int a, int b, int c) const {
    const int opposite = 6 - a - b - c;
    const std::int32_t other = topology_.neighbours[t][opposite];
    bool ab = side[a] == side[b], ac = side[a] == side[c], bc = side[b] == side[c];
    if (other >= 0) {
      const Sides beyond = sides(other);
      const auto at = [&](int corner) {
        return beyond[std::find(tets_[other].begin(), tets_[other].end(), tets_[t][corner]) - tets_[other].begin()];
      };
      ab |= at(a) == at(b);
      ac |= at(a) == at(c);
      bc |= at(b) == at(c);
    }
    return node(t, {a, b, c}, [&](int corner) { return corner == a || (corner == b ? ab || (ac && bc) : ac || (ab && bc)); });
  }

  void add_triangle(const CutNode& a, const CutNode& b, const CutNode& c) { corners_.insert(corners_.end(), {a, b, c}); }

  void add_boundary(const BoundaryFace& face) {
    const std::int32_t t = face.tet;
    const auto& f = k_faces[face.corner];
    const Sides side = sides(t);
    if (!is_split(side, face.corner)) return add_polygon(t, f);
    for (int i = 0; i < 3; ++i) {
      const int a = f[i], b = f[(i + 1) % 3], c = f[(i + 2) % 3];
      const CutNode corner = vertex(t, a), centre = face_centre(t, side, a, b, c);
      add_triangle(corner, midpoint(t, a, b), centre);
      add_triangle(corner, centre, midpoint(t, a, c));
    }
  }

  /// Adds a whole boundary face with the midpoints that the faces beside it need.
  void add_polygon(std::int32_t t, const std::array<int, 3>& f) {
    std::array<bool, 3> has;  // a midpoint on the edge from f[i] to f[i + 1]
    for (int i = 0; i < 3; ++i) has[i] = active_[edge(t, f[i], f[(i + 1) % 3])];
    const auto mid = [&](int i) { return midpoint(t, f[i], f[(i + 1) % 3]); };
    const int count = has[0] + has[1] + has[2];
    if (count == 0) return add_triangle(vertex(t, f[0]), vertex(t, f[1]), vertex(t, f[2]));
    if (count == 3) {
      add_triangle(mid(0), mid(1), mid(2));
      for (int i = 0; i < 3; ++i) add_triangle(vertex(t, f[i]), mid(i), mid((i + 2) % 3));
      return;
    }
    // a fan from the first midpoint whose edge before has none
    int i = 0;
    while (!has[i] || has[(i + 2) % 3]) ++i;
    const int a = f[i], b = f[(i + 1) % 3], c = f[(i + 2) % 3];
    if (has[(i + 1) % 3]) {
      add_triangle(mid(i), vertex(t, b), mid((i + 1) % 3));
      add_triangle(mid(i), mid((i + 1) % 3), vertex(t, c));
    } else {
      add_triangle(mid(i), vertex(t, b), vertex(t, c));
    }
    add_triangle(mid(i), vertex(t, c), vertex(t, a));
  }

  /// Adds both sides of the quadrilaterals between separated corners, split along the same diagonal.
  void add_cracks(std::int32_t t) {
    const Sides side = sides(t);
    for (const auto& [a, b, c, d] : k_tet_edges) {
      if (side[a] == side[b]) continue;
      add_half(midpoint(t, a, b), face_centre(t, side, a, b, c), centre(t, side, a), face_centre(t, side, a, b, d));
      add_half(midpoint(t, b, a), face_centre(t, side, b, a, d), centre(t, side, b), face_centre(t, side, b, a, c));
    }
  }
  void add_half(const CutNode& midpoint, const CutNode& first, const CutNode& centre, const CutNode& second) {
    add_triangle(midpoint, first, centre);
    add_triangle(midpoint, centre, second);
  }

  CutSurface numbered(std::size_t skin_triangles) const {
    CutSurface surface;
    surface.skin_triangles = skin_triangles;
    surface.nodes = corners_;
    std::sort(surface.nodes.begin(), surface.nodes.end());
    surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()), surface.nodes.end());
    surface.triangles.resize(corners_.size() / 3);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      surface.triangles[i / 3][i % 3] =
          static_cast<std::int32_t>(std::lower_bound(surface.nodes.begin(), surface.nodes.end(), corners_[i]) - surface.nodes.begin());
    return surface;
  }

  const Topology& topology_;
  const std::vector<Tet>& tets_;
  const std::vector<std::int32_t>& broken_at_;
  std::vector<std::int32_t> cut_tets_;
  std::vector<char> joined_;  ///< per broken edge: a tetrahedron connects its ends in another way
  std::vector<char> active_;  ///< per edge: its midpoint is a vertex of the boundary
  std::vector<CutNode> corners_;
};

}  // namespace

CutSurface cut(const Topology& topology, const std::vector<std::int32_t>& broken_at) { return Cutter(topology, broken_at).run(); }

}  // namespace bake

// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/solid/cleaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "solver/core/errors.h"
#include "solver/core/union_find.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

using Face = std::vector<std::int32_t>;

/// A triangle whose height is less than this share of its longest edge has no area.
constexpr double k_flat = 1e-9;

struct Soup {
  std::vector<Point> points;
  std::vector<Face> faces;
};

[[noreturn]] void refuse(const std::string& what) { throw InputError(what); }

double largest_coordinate(const std::vector<Point>& points) {
  double largest = 0;
  for (const Point& x : points)
    for (const double c : x) largest = std::max(largest, std::abs(c));
  return largest;
}

/// The points that faces use, all finite and of sane size.
Soup used_part(const PolygonSoup& soup) {
  constexpr std::size_t k_most = std::numeric_limits<std::int32_t>::max() / 4;
  if (soup.faces.empty()) refuse("is empty: it has no triangles");
  if (soup.points.size() > k_most || soup.faces.size() > k_most) refuse(fmt::format("has more than {} points or faces", k_most));
  Soup result;
  for (const auto& polygon : soup.faces) {
    for (const std::int64_t v : polygon)
      for (const double c : soup.points[v])
        if (!std::isfinite(c)) refuse(fmt::format("vertex {} has a coordinate that is no finite number", v));
    result.faces.emplace_back(polygon.begin(), polygon.end());
  }
  result.points = take_used_points(soup.points, result.faces);
  return result;
}

void check_size(const std::vector<Point>& points) {
  constexpr double k_farthest = 1e9, k_least_share = 1e-7;
  if (points.empty()) refuse("is empty: no face has corners");
  Point low = points[0], high = points[0];
  for (const Point& x : points)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
  const double far = largest_coordinate(points), extent = length(high - low);
  if (far > k_farthest) refuse(fmt::format("reaches to {:.3g} m from the origin, allowed: {:.0e}", far, k_farthest));
  if (!(extent > k_least_share * far))
    refuse(fmt::format("is {:.3g} m across at {:.3g} m from the origin, allowed: {:.0e} of that", extent, far, k_least_share));
}

/// Gives corners that belong together the number of the first of them, and leaves out the others and what is no polygon any more.
void join(Soup& soup, UnionFind& groups, Mended& mended) {
  std::vector<std::int32_t> number(soup.points.size());
  std::vector<Point> kept;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const std::int32_t first = groups.find(static_cast<std::int32_t>(v));
    if (first == static_cast<std::int32_t>(v)) {
      number[v] = static_cast<std::int32_t>(kept.size());
      kept.push_back(soup.points[v]);
    } else {
      number[v] = number[first];
      ++mended.joined;
      mended.farthest_joined_m = std::max(mended.farthest_joined_m, length(soup.points[v] - soup.points[first]));
    }
  }
  soup.points = std::move(kept);
  for (Face& face : soup.faces) {
    for (std::int32_t& v : face) v = number[v];
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
  }
  mended.without_area += std::erase_if(soup.faces, [](const Face& face) { return face.size() < 3; });
}

void join_same_places(Soup& soup, Mended& mended) {
  std::vector<std::int32_t> order(soup.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return soup.points[a] != soup.points[b] ? soup.points[a] < soup.points[b] : a < b; });
  UnionFind groups(soup.points.size());
  for (std::size_t i = 1; i < order.size(); ++i)
    if (soup.points[order[i - 1]] == soup.points[order[i]]) groups.unite(order[i - 1], order[i]);
  join(soup, groups, mended);
}

/// The vertices at edges that an odd number of faces share.
std::vector<char> at_open_edges(const Soup& soup) {
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  for (const Face& face : soup.faces)
    for (std::size_t k = 0; k < face.size(); ++k) edges.push_back(std::minmax(face[k], face[(k + 1) % face.size()]));
  std::sort(edges.begin(), edges.end());
  std::vector<char> open(soup.points.size(), 0);
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    for (j = i; j < edges.size() && edges[j] == edges[i];) ++j;
    if ((j - i) % 2 == 1) open[edges[i].first] = open[edges[i].second] = 1;
  }
  return open;
}

/// Joins vertices at open edges that are not farther apart than `reach`.
void join_near(Soup& soup, const std::vector<char>& open, double reach, Mended& mended) {
  std::map<std::array<std::int64_t, 3>, std::vector<std::int32_t>> cells;
  UnionFind groups(soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (!open[v]) continue;
    const Point& x = soup.points[v];
    std::array<std::int64_t, 3> cell;
    for (int i = 0; i < 3; ++i) cell[i] = static_cast<std::int64_t>(std::floor(x[i] / reach));
    for (int n = 0; n < 27; ++n) {
      const auto found = cells.find({cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1});
      if (found == cells.end()) continue;
      for (const std::int32_t other : found->second)
        if (length(x - soup.points[other]) <= reach) groups.unite(other, static_cast<std::int32_t>(v));
    }
    cells[cell].push_back(static_cast<std::int32_t>(v));
  }
  join(soup, groups, mended);
}

/// Corners a rounding apart: of text with six digits first, then of ten times that. What does not close the surface is not done.
void join_roundings(Soup& soup, Mended& mended) {
  for (const double share : {2e-6, 2e-5}) {
    const std::vector<char> open = at_open_edges(soup);
    if (std::count(open.begin(), open.end(), 1) == 0) return;
    Soup joined = soup;
    Mended then = mended;
    join_near(joined, open, share * largest_coordinate(soup.points), then);
    const std::vector<char> left = at_open_edges(joined);
    if (std::count(left.begin(), left.end(), 1) > 0) continue;
    soup = std::move(joined);
    mended = then;
    return;
  }
}

/// Splits polygons into triangles: fans of those that are convex, else ear by ear.
class Splitter {
 public:
  Splitter(const std::vector<Point>& points, Mended& mended) : points_(points), mended_(mended) {}

  void split(const Face& face, std::vector<Triangle>& triangles) {
    find_normal(face);
    if (is_convex(face)) {
      for (std::size_t k = 2; k < face.size(); ++k) triangles.push_back({face[0], face[k - 1], face[k]});
      return;
    }
    ++mended_.concave;
    for (Face left = face; left.size() >= 3;) {
      const std::size_t k = best_ear(left), n = left.size();
      triangles.push_back({left[(k + n - 1) % n], left[k], left[(k + 1) % n]});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

 private:
  void find_normal(const Face& face) {
    normal_ = {0, 0, 0};
    for (std::size_t k = 2; k < face.size(); ++k)
      normal_ = normal_ + cross(points_[face[k - 1]] - points_[face[0]], points_[face[k]] - points_[face[0]]);
  }

  /// Twice the area of a triangle as seen along the normal, times the normal's length.
  double turn(const Point& a, const Point& b, const Point& c) const { return dot(normal_, cross(b - a, c - a)); }

  /// Whether every triangle of the fan turns as the polygon does, and every corner, too.
  bool is_convex(const Face& face) const {
    if (face.size() == 3) return true;
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k)
      if (!(turn(points_[face[k]], points_[face[(k + 1) % n]], points_[face[(k + 2) % n]]) > 0)) return false;
    for (std::size_t k = 2; k < n; ++k)
      if (!(turn(points_[face[0]], points_[face[k - 1]], points_[face[k]]) > 0)) return false;
    return true;
  }

  bool is_ear(const Face& face, std::size_t k) const {
    const std::size_t n = face.size();
    const Point &a = points_[face[(k + n - 1) % n]], &b = points_[face[k]], &c = points_[face[(k + 1) % n]];
    if (!(turn(a, b, c) > 0)) return false;
    for (const std::int32_t v : face) {
      const Point& x = points_[v];
      if (x == a || x == b || x == c) continue;
      if (turn(a, b, x) >= 0 && turn(b, c, x) >= 0 && turn(c, a, x) >= 0) return false;
    }
    return true;
  }

  /// The ear with the largest area against its longest side, so that corners in a line end between others; a corner that is no ear if there
  /// is none (a twisted polygon).
  std::size_t best_ear(const Face& face) const {
    const std::size_t n = face.size();
    std::size_t best = 0;
    double best_shape = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      const Point &a = points_[face[(k + n - 1) % n]], &b = points_[face[k]], &c = points_[face[(k + 1) % n]];
      const double side = std::max({length(b - a), length(c - b), length(a - c)});
      const double shape = is_ear(face, k) ? turn(a, b, c) / (side * side) : -1e300;
      if (shape > best_shape) best_shape = shape, best = k;
    }
    return best;
  }

  const std::vector<Point>& points_;
  Mended& mended_;
  Vector3 normal_{};
};

using Edge = std::pair<std::int32_t, std::int32_t>;

Edge edge_of(const Triangle& t, int k) { return std::minmax(t[k], t[(k + 1) % 3]); }

/// The triangles at each edge.
std::map<Edge, std::vector<std::int32_t>> edges_of(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<std::int32_t>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) edges[edge_of(triangles[t], k)].push_back(static_cast<std::int32_t>(t));
  return edges;
}

std::size_t open_edges(const std::vector<Triangle>& triangles) {
  std::size_t open = 0;
  for (const auto& [edge, around] : edges_of(triangles)) open += around.size() != 2;
  return open;
}

/// Of triangles with the same corners one is kept or, where two bodies touch with a wall of their own each, none.
void drop_doubled(std::vector<Triangle>& triangles, Mended& mended) {
  std::map<Triangle, int> count;
  const auto key = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  for (const Triangle& t : triangles) ++count[key(t)];
  if (count.size() == triangles.size()) return;
  std::vector<Triangle> once, none;
  for (const Triangle& t : triangles) {
    int& found = count[key(t)];
    if (found == 1) none.push_back(t);
    if (found > 0) once.push_back(t);
    if (found > 1) found = -found;  // the first of several
  }
  std::vector<Triangle>& better = !none.empty() && open_edges(none) < open_edges(once) ? none : once;
  mended.doubled = triangles.size() - better.size();
  triangles = std::move(better);
}

/// Turns triangles as the first of their part.
void turn_one_way(std::vector<Triangle>& triangles, Mended& mended) {
  const auto edges = edges_of(triangles);
  std::vector<char> seen(triangles.size(), 0);
  const auto goes = [&](const Triangle& t, const Edge& edge) {  // whether it runs along the edge from the lower vertex to the higher
    for (int k = 0; k < 3; ++k)
      if (t[k] == edge.first && t[(k + 1) % 3] == edge.second) return true;
    return false;
  };
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (seen[first]) continue;
    seen[first] = 1;
    std::vector<std::int32_t> part{static_cast<std::int32_t>(first)};
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Edge edge = edge_of(triangles[part[i]], k);
        const auto& around = edges.at(edge);
        if (around.size() != 2) continue;
        const std::int32_t other = around[0] == part[i] ? around[1] : around[0];
        const bool agrees = goes(triangles[part[i]], edge) != goes(triangles[other], edge);
        if (seen[other]) {
          if (!agrees) refuse("has but one side, as a Moebius strip: its triangles cannot be turned one way");
          continue;
        }
        seen[other] = 1;
        part.push_back(other);
        if (agrees) continue;
        std::swap(triangles[other][1], triangles[other][2]);
        mended.turned = true;
      }
  }
}

/// Corner of the longest edge's start, and whether the triangle's height on it is nothing.
struct Flatness {
  int longest = 0;
  bool is_flat = false;
};

Flatness flatness(const std::vector<Point>& x, const Triangle& t) {
  Flatness result;
  double longest = -1;
  for (int k = 0; k < 3; ++k) {
    const double edge = length(x[t[(k + 1) % 3]] - x[t[k]]);
    if (edge > longest) longest = edge, result.longest = k;
  }
  result.is_flat = !(length(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]])) > k_flat * longest * longest);
  return result;
}

/// A triangle whose corners lie in a line is removed by turning the diagonal between it and the neighbour at its longest edge.
void turn_flat_diagonals(const std::vector<Point>& points, std::vector<Triangle>& triangles, Mended& mended) {
  const auto flat_ones = [&] {
    std::vector<std::int32_t> flat;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (flatness(points, triangles[t]).is_flat) flat.push_back(static_cast<std::int32_t>(t));
    return flat;
  };
  std::vector<std::int32_t> flat = flat_ones();
  mended.without_area += flat.size();
  for (int round = 0; round < 20 && !flat.empty(); ++round, flat = flat_ones()) {
    auto edges = edges_of(triangles);  // entries that a turn makes wrong lead to triangles that were touched
    std::vector<char> touched(triangles.size(), 0);
    for (const std::int32_t t : flat) {
      const int k = flatness(points, triangles[t]).longest;
      const std::int32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3], c = triangles[t][(k + 2) % 3];
      const auto& around = edges[std::minmax(a, b)];
      if (around.size() != 2) continue;
      const std::int32_t other = around[0] == t ? around[1] : around[0];
      const Triangle& u = triangles[other];
      const std::int32_t d = *std::find_if(u.begin(), u.end(), [&](std::int32_t v) { return v != a && v != b; });
      if (touched[t] || touched[other] || d == c || edges.count(std::minmax(c, d)) > 0) continue;
      triangles[t] = {c, a, d};
      triangles[other] = {d, b, c};
      touched[t] = touched[other] = 1;
      edges[std::minmax(c, d)] = {t, other};
    }
    if (std::count(touched.begin(), touched.end(), 1) == 0) return;
  }
}

}  // namespace

std::string Mended::text() const {
  std::string line;
  const auto add = [&](const std::string& what) { line += (line.empty() ? "" : ", ") + what; };
  const auto many = [](std::size_t count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
  };
  if (joined > 0 && farthest_joined_m > 0)
    add(fmt::format("{} joined that were up to {:.2g} m apart", many(joined, "corner", "corners"), farthest_joined_m));
  else if (joined > 0)
    add(many(joined, "repeated corner joined", "repeated corners joined"));
  if (without_area > 0) add(many(without_area, "face without area removed", "faces without area removed"));
  if (doubled > 0) add(many(doubled, "doubled face removed", "doubled faces removed"));
  if (concave > 0) add(many(concave, "face split that is not convex", "faces split that are not convex"));
  if (turned) add("triangles turned so that all look outwards");
  return line;
}

TriangleMesh clean_surface(const PolygonSoup& polygons, Mended& mended) {
  Soup soup = used_part(polygons);
  check_size(soup.points);
  join_same_places(soup, mended);
  if (polygons.repeats_corners) mended.joined = mended.without_area = 0;
  join_roundings(soup, mended);
  TriangleMesh mesh;
  Splitter splitter(soup.points, mended);
  for (const Face& face : soup.faces) splitter.split(face, mesh.triangles);
  drop_doubled(mesh.triangles, mended);
  turn_one_way(mesh.triangles, mended);
  turn_flat_diagonals(soup.points, mesh.triangles, mended);
  mesh.points = take_used_points(soup.points, mesh.triangles);
  if (mesh.triangles.empty()) refuse("is empty: none of its faces has an area");
  return mesh;
}

}  // namespace bake

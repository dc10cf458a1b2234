// SPDX-License-Identifier: MIT
#include "solver/boundary/surface_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "solver/core/errors.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

constexpr double k_most_cells = 2e8;  ///< of the lattice in which the surface is sought
constexpr int k_rounds = 24;          ///< of flips and relaxation; more change little

Vector3 doubled_area(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

/// Moves a point to the surface at a depth, onto it if it is near or the steps are several.
Point foot(const Shape& shape, double depth, Point x, int steps = 1) {
  for (int i = 0; i < steps; ++i) x = x - (shape.distance(x) + depth) * shape.normal(x);
  return x;
}

/// A lattice around a shape, and for each of its nodes whether it lies below the surface.
class Lattice {
 public:
  Lattice(const Shape& shape, double spacing, double depth) : spacing_(spacing) {
    const Box3 box = shape.bounds();
    double cells = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      const double extent = box.high[d] - box.low[d];
      count_[d] = static_cast<int>(std::ceil(std::min(extent / spacing, 1e9))) + 5;
      cells *= count_[d];
      // centred, but for a little: nodes on planes of symmetry would lie in faces
      low_[d] = (box.low[d] + box.high[d]) / 2 - (count_[d] - 1) * spacing / 2 + 0.137 * spacing;
    }
    if (cells > k_most_cells)
      throw InputError(fmt::format("found about {:.2g} cells of the size of its triangles, allowed: {:g}", cells, k_most_cells));
    below_.resize(static_cast<std::size_t>(cells));
    level_.resize(below_.size());
    for (std::size_t n = 0; n < level_.size(); ++n) level_[n] = shape.distance(node(coordinates(n))) + depth;
    join_sides();
    for (std::size_t n = 0; n < level_.size(); ++n) below_[n] = level_[n] < 0;
  }

  /// The surface as a net: one vertex for each cell that it passes, in the middle of where it crosses the cell's edges, and a quadrangle
  /// for each edge of the lattice that it crosses.
  SurfaceMesh net() const {
    SurfaceMesh mesh;
    std::vector<std::int32_t> vertex_of(level_.size(), -1);
    for_each_cell([&](const std::array<int, 3>& at) {
      Point sum{0, 0, 0};
      int crossings = 0;
      for (int edge = 0; edge < 12; ++edge) {
        std::array<int, 3> from = at;
        const int axis = edge / 4;
        from[static_cast<std::size_t>((axis + 1) % 3)] += edge & 1;
        from[static_cast<std::size_t>((axis + 2) % 3)] += edge >> 1 & 1;
        std::array<int, 3> to = from;
        ++to[static_cast<std::size_t>(axis)];
        const double a = level_[number(from)], b = level_[number(to)];
        if ((a < 0) == (b < 0)) continue;
        const double share = a / (a - b);
        sum = sum + (1 - share) * node(from) + share * node(to);
        ++crossings;
      }
      if (crossings == 0) return;
      vertex_of[number(at)] = static_cast<std::int32_t>(mesh.points.size());
      mesh.points.push_back((1. / crossings) * sum);
    });
    for_each_cell([&](const std::array<int, 3>& at) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<int, 3> to = at;
        ++to[axis];
        const bool below = below_[number(at)] != 0;
        if (below == (below_[number(to)] != 0)) continue;
        std::int32_t corner[4];
        constexpr int k_around[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
        for (int c = 0; c < 4; ++c) {
          std::array<int, 3> cell = at;
          cell[(axis + 1) % 3] += k_around[c][0];
          cell[(axis + 2) % 3] += k_around[c][1];
          corner[c] = vertex_of[number(cell)];
        }
        if (!below) std::swap(corner[1], corner[3]);
        const auto apart = [&](int i, int j) {
          return length(mesh.points[static_cast<std::size_t>(corner[i])] - mesh.points[static_cast<std::size_t>(corner[j])]);
        };
        const int first = apart(0, 2) <= apart(1, 3) ? 0 : 1;  // of the shorter diagonal
        mesh.triangles.push_back({corner[first], corner[first + 1], corner[first + 2]});
        mesh.triangles.push_back({corner[first], corner[first + 2], corner[(first + 3) % 4]});
      }
    });
    return mesh;
  }

 private:
  std::size_t number(const std::array<int, 3>& at) const {
    return (static_cast<std::size_t>(at[0]) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(at[1])) *
               static_cast<std::size_t>(count_[2]) +
           static_cast<std::size_t>(at[2]);
  }
  std::array<int, 3> coordinates(std::size_t n) const {
    const auto y = static_cast<std::size_t>(count_[1]), z = static_cast<std::size_t>(count_[2]);
    return {static_cast<int>(n / z / y), static_cast<int>(n / z % y), static_cast<int>(n % z)};
  }
  Point node(const std::array<int, 3>& at) const { return low_ + spacing_ * Vector3{double(at[0]), double(at[1]), double(at[2])}; }
  /// A cell has one vertex, so the corners on either side of the surface must hang together in it. At sharp edges some do not: the fewer of
  /// them then change sides. That matters little, since vertices are moved onto the surface.
  void join_sides() {
    constexpr int k_most_rounds = 20;
    bool changed = true;
    for (int round = 0; changed && round < k_most_rounds; ++round) {
      changed = false;
      for_each_cell([&](const std::array<int, 3>& at) {
        std::size_t corner[8];
        unsigned below = 0;
        for (unsigned c = 0; c < 8; ++c) {
          corner[c] = number({at[0] + int(c >> 2), at[1] + int(c >> 1 & 1), at[2] + int(c & 1)});
          below |= unsigned(level_[corner[c]] < 0) << c;
        }
        for (const unsigned side : {below, ~below & 255U}) {
          const unsigned part = hanging_together(side);
          if (part == side) continue;
          const unsigned rest = side & ~part, few = std::popcount(part) < std::popcount(rest) ? part : rest;
          for (unsigned c = 0; c < 8; ++c)
            if (few >> c & 1) level_[corner[c]] = level_[corner[c]] < 0 ? 1e-3 * spacing_ : -1e-3 * spacing_;
          changed = true;
          return;
        }
      });
    }
  }
  /// Of the corners of a cell those that hang together with the first along its edges.
  static unsigned hanging_together(unsigned corners) {
    unsigned part = corners & (~corners + 1), before = 0;
    while (part != before) {
      before = part;
      for (unsigned c = 0; c < 8; ++c)
        if (before >> c & 1)
          for (const unsigned neighbour : {c ^ 1U, c ^ 2U, c ^ 4U}) part |= corners & 1U << neighbour;
    }
    return part;
  }

  template <class Visit>
  void for_each_cell(Visit visit) const {
    for (int x = 1; x + 1 < count_[0]; ++x)
      for (int y = 1; y + 1 < count_[1]; ++y)
        for (int z = 1; z + 1 < count_[2]; ++z) visit(std::array<int, 3>{x, y, z});
  }

  double spacing_;
  int count_[3];
  Point low_;
  std::vector<double> level_;  ///< above the surface [m]
  std::vector<char> below_;
};

std::uint64_t key_of(std::int32_t a, std::int32_t b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

/// Turns the edges about which the angles at the two tips are more than 180 degrees together (Delaunay), but not where the surface has a
/// sharp edge.
void flip_edges(SurfaceMesh& mesh) {
  constexpr double k_sharp = 0.75;  // cosine of the angle between normals
  const std::vector<SurfaceHinge> hinges = hinges_of(mesh.triangles);
  std::unordered_set<std::uint64_t> edges;
  for (const SurfaceHinge& h : hinges) edges.insert(key_of(h.edge[0], h.edge[1]));
  std::vector<char> turned(mesh.triangles.size());
  for (const SurfaceHinge& h : hinges) {
    const auto first = static_cast<std::size_t>(h.triangles[0]), second = static_cast<std::size_t>(h.triangles[1]);
    if (turned[first] || turned[second]) continue;
    const auto at = [&](std::int32_t v) { return mesh.points[static_cast<std::size_t>(v)]; };
    const Point a = at(h.edge[0]), b = at(h.edge[1]), c = at(h.tips[0]), d = at(h.tips[1]);
    const Vector3 n = doubled_area(a, b, c), m = doubled_area(b, a, d);
    const double cotangents = dot(a - c, b - c) / length(n) + dot(a - d, b - d) / length(m);
    if (!(cotangents < -1e-9) || dot(n, m) < k_sharp * length(n) * length(m)) continue;
    const Vector3 turned_n = doubled_area(c, d, b), turned_m = doubled_area(d, c, a);
    if (dot(turned_n, n) <= 0 || dot(turned_m, n) <= 0) continue;  // it would fold over
    if (!edges.insert(key_of(h.tips[0], h.tips[1])).second) continue;
    edges.erase(key_of(h.edge[0], h.edge[1]));
    mesh.triangles[first] = {h.tips[0], h.tips[1], h.edge[1]};
    mesh.triangles[second] = {h.tips[1], h.tips[0], h.edge[0]};
    turned[first] = turned[second] = 1;
  }
}

/// Moves the vertices half way to the middle of their neighbours, along the surface.
void relax(const Shape& shape, double depth, SurfaceMesh& mesh) {
  std::vector<Vector3> sum(mesh.points.size(), Vector3{0, 0, 0});
  std::vector<int> neighbours(mesh.points.size(), 0);
  for (const SurfaceTriangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(t[k]), to = static_cast<std::size_t>(t[(k + 1) % 3]);
      sum[from] = sum[from] + mesh.points[to];
      ++neighbours[from];
    }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vector3 n = shape.normal(mesh.points[v]), way = (1. / neighbours[v]) * sum[v] - mesh.points[v];
    mesh.points[v] = foot(shape, depth, mesh.points[v] + 0.5 * (way - dot(way, n) * n));
  }
}

/// Cuts edges longer than `longest` in half, at most one of each triangle.
void split_edges(double longest, SurfaceMesh& mesh) {
  std::vector<char> split(mesh.triangles.size());
  for (const SurfaceHinge& h : hinges_of(mesh.triangles)) {
    const auto first = static_cast<std::size_t>(h.triangles[0]), second = static_cast<std::size_t>(h.triangles[1]);
    const Point a = mesh.points[static_cast<std::size_t>(h.edge[0])], b = mesh.points[static_cast<std::size_t>(h.edge[1])];
    if (split[first] || split[second] || length(b - a) < longest) continue;
    const auto middle = static_cast<std::int32_t>(mesh.points.size());
    mesh.points.push_back(0.5 * (a + b));
    mesh.triangles[first] = {h.edge[0], middle, h.tips[0]};
    mesh.triangles[second] = {middle, h.edge[0], h.tips[1]};
    mesh.triangles.push_back({middle, h.edge[1], h.tips[0]});
    mesh.triangles.push_back({h.edge[1], middle, h.tips[1]});
    split[first] = split[second] = 1;
  }
}

/// The edge of equilateral triangles that have as many vertices on the same area.
double even_edge(const SurfaceMesh& mesh) {
  double area = 0;
  for (const SurfaceTriangle& t : mesh.triangles) area += area_of(mesh, t);
  return std::sqrt(2 / std::sqrt(3.) * area / static_cast<double>(mesh.points.size()));
}

/// Makes a net's triangles even.
void make_even(const Shape& shape, double edge, double depth, SurfaceMesh& mesh) {
  for (int round = 0; round < k_rounds; ++round) {
    if (round % 6 == 5) split_edges(1.45 * edge, mesh);
    flip_edges(mesh);
    relax(shape, depth, mesh);
  }
  flip_edges(mesh);
  for (Point& x : mesh.points) x = foot(shape, depth, x, 3);
}

/// Are there triangles that are hardly any, or that look inwards?
bool is_spoilt(const Shape& shape, double edge, const SurfaceMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const SurfaceTriangle& t) {
    const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
    const Vector3 n = doubled_area(at(0), at(1), at(2));
    return length(n) < 1e-3 * edge * edge || dot(n, shape.normal((1. / 3) * (at(0) + at(1) + at(2)))) < -0.7 * length(n);
  });
}

}  // namespace

double area_of(const SurfaceMesh& mesh, const SurfaceTriangle& t) {
  const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
  return length(doubled_area(at(0), at(1), at(2))) / 2;
}

std::vector<double> vertex_areas(const SurfaceMesh& mesh) {
  std::vector<double> areas(mesh.points.size(), 0);
  for (const SurfaceTriangle& t : mesh.triangles)
    for (const std::int32_t v : t) areas[static_cast<std::size_t>(v)] += area_of(mesh, t) / 3;
  return areas;
}

std::vector<SurfaceHinge> hinges_of(const std::vector<SurfaceTriangle>& triangles) {
  struct Side {
    std::int32_t low, high;  ///< corners of the edge
    bool turned;             ///< whether its triangle has them the other way round
    std::int32_t triangle, tip;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a > b, static_cast<std::int32_t>(t), triangles[t][(k + 2) % 3]});
    }
  const auto key = [](const Side& s) { return std::tuple(s.low, s.high, s.turned, s.triangle); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return key(a) < key(b); });
  std::vector<SurfaceHinge> hinges;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &left = sides[i - 1], &right = sides[i];
    if (left.low != right.low || left.high != right.high) continue;
    if (left.turned == right.turned || (i + 1 < sides.size() && sides[i + 1].low == right.low && sides[i + 1].high == right.high))
      throw TornSurface(
          fmt::format("found an edge between the vertices {} and {} that is not one of two triangles turned the same way, "
                      "allowed: a surface that nowhere touches itself",
                      left.low, left.high));
    hinges.push_back({{left.low, left.high}, {left.tip, right.tip}, {left.triangle, right.triangle}});
  }
  return hinges;
}

SurfaceMesh cover(const Shape& shape, double edge_m, double depth_m) {
  const auto thin = [&] {
    return InputError(fmt::format(
        "found a shape too thin or too sharp for triangles with edges of {:.3g} m that lie {:.3g} m below its surface, allowed: "
        "a thicker one (a finer --quality or grid.dx_m)",
        edge_m, depth_m));
  };
  const auto net = [&](double spacing) {
    SurfaceMesh net = Lattice(shape, spacing, depth_m).net();
    if (net.triangles.empty()) throw thin();
    for (Point& x : net.points) x = foot(shape, depth_m, x, 3);
    return net;
  };
  SurfaceMesh mesh;
  try {
    mesh = net(edge_m * edge_m / even_edge(net(edge_m)));  // how many cells a face passes depends on how it lies
    make_even(shape, edge_m, depth_m, mesh);
    if (2 * hinges_of(mesh.triangles).size() != 3 * mesh.triangles.size()) throw thin();
  } catch (const TornSurface&) {
    throw thin();
  }
  if (is_spoilt(shape, edge_m, mesh)) throw thin();
  return mesh;
}

SurfaceMesh part_inside(const SurfaceMesh& mesh, const Shape& region) {
  std::vector<std::int32_t> number(mesh.points.size(), -1);
  SurfaceMesh part;
  for (const SurfaceTriangle& t : mesh.triangles) {
    Point centre{0, 0, 0};
    for (const std::int32_t v : t) centre = centre + (1. / 3) * mesh.points[static_cast<std::size_t>(v)];
    if (region.distance(centre) > 0) continue;
    part.triangles.push_back(t);
    for (const std::int32_t v : t) number[static_cast<std::size_t>(v)] = 0;
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<std::int32_t>(part.points.size());
    part.points.push_back(mesh.points[v]);
  }
  for (SurfaceTriangle& t : part.triangles)
    for (std::int32_t& v : t) v = number[static_cast<std::size_t>(v)];
  return part;
}

void move_inwards(SurfaceMesh& mesh, double depth_m) {
  std::vector<Vector3> normal(mesh.points.size(), Vector3{0, 0, 0});
  for (const SurfaceTriangle& t : mesh.triangles) {
    const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
    const Vector3 n = doubled_area(at(0), at(1), at(2));
    for (const std::int32_t v : t) normal[static_cast<std::size_t>(v)] = normal[static_cast<std::size_t>(v)] + n;
  }
  for (std::size_t v = 0; v < normal.size(); ++v) mesh.points[v] = mesh.points[v] - depth_m * unit(normal[v]);
}

}  // namespace bake

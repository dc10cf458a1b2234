// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/even_volumes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "meshing/tets/stars.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

constexpr double k_pull = 0.1;         ///< towards the first position, against the aim of even volumes
constexpr double k_least_share = 0.5;  ///< of a tetrahedron's first volume
constexpr int k_halvings = 4;          ///< of a step before it is dropped

/// The solution of a symmetric system by its cofactors: the same on every machine.
Vector3 solve(const std::array<Vector3, 3>& a, const Vector3& b) {
  const Vector3 c0 = cross(a[1], a[2]), c1 = cross(a[2], a[0]), c2 = cross(a[0], a[1]);
  return (1 / dot(a[0], c0)) * (b[0] * c0 + b[1] * c1 + b[2] * c2);
}

class Evening {
 public:
  Evening(TetMesh& mesh, double wanted_m3)
      : mesh_(mesh), first_(mesh.points), wanted_(wanted_m3), volumes_(vertex_volumes(mesh)), stars_(mesh.tets, mesh.points.size()) {
    outer_.assign(mesh.points.size(), 0);
    for (const Triangle& t : boundary_triangles(mesh.tets, tet_neighbours(mesh.tets, mesh.points.size())))
      for (const std::int32_t v : t) outer_[v] = 1;
  }

  void sweep() {
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      if (!outer_[v]) move(static_cast<std::int32_t>(v));
  }

 private:
  /// dV_v / dx of an inner vertex v when another one moves.
  struct Slope {
    std::int32_t vertex;
    Vector3 gradient;
  };

  void find_slopes(std::int32_t moving) {
    slopes_.clear();
    for (const std::int32_t t : stars_.at(moving)) {
      const Tet& tet = mesh_.tets[t];
      const auto& face = k_faces[std::find(tet.begin(), tet.end(), moving) - tet.begin()];
      const Point &a = mesh_.points[tet[face[0]]], &b = mesh_.points[tet[face[1]]], &c = mesh_.points[tet[face[2]]];
      const Vector3 n = cross(b - a, c - a);
      for (const int k : face) {
        if (outer_[tet[k]]) continue;
        auto slope = std::find_if(slopes_.begin(), slopes_.end(), [&](const Slope& s) { return s.vertex == tet[k]; });
        if (slope == slopes_.end()) slope = slopes_.insert(slope, {tet[k], {0, 0, 0}});
        slope->gradient = slope->gradient - (1.0 / 24) * n;
      }
    }
  }

  bool keeps_shapes(std::int32_t v) const {
    const auto star = stars_.at(v);
    return std::all_of(star.begin(), star.end(), [&](std::int32_t t) {
      return tet_volume(mesh_.points, mesh_.tets[t]) >= k_least_share * tet_volume(first_, mesh_.tets[t]);
    });
  }

  void move(std::int32_t v) {
    find_slopes(v);
    Point& x = mesh_.points[v];
    const double pull = k_pull * wanted_ * std::cbrt(wanted_);
    std::array<Vector3, 3> a{{{pull, 0, 0}, {0, pull, 0}, {0, 0, pull}}};
    Vector3 b = pull * (first_[v] - x);
    for (const Slope& s : slopes_) {
      for (int i = 0; i < 3; ++i) a[i] = a[i] + s.gradient[i] * s.gradient;
      b = b + (wanted_ - volumes_[s.vertex]) * s.gradient;
    }
    const Point old = x;
    Vector3 step = solve(a, b);
    x = old + step;
    for (int i = 0; i < k_halvings && !keeps_shapes(v); ++i) {
      step = 0.5 * step;
      x = old + step;
    }
    if (!keeps_shapes(v)) {
      step = {0, 0, 0};
      x = old;
    }
    for (const Slope& s : slopes_) volumes_[s.vertex] += dot(s.gradient, step);
  }

  TetMesh& mesh_;
  std::vector<Point> first_;
  double wanted_;
  std::vector<double> volumes_;
  Stars stars_;
  std::vector<char> outer_;
  std::vector<Slope> slopes_;
};

}  // namespace

void even_volumes(TetMesh& mesh, double wanted_m3) {
  Evening evening(mesh, wanted_m3);
  for (int i = 0; i < 2; ++i) evening.sweep();
}

}  // namespace bake

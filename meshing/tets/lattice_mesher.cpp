// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/lattice_mesher.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "meshing/tets/delaunay.h"
#include "meshing/tets/even_volumes.h"
#include "meshing/tets/manifold.h"
#include "meshing/tets/surface_foot.h"
#include "solver/core/errors.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

Box3 finite_bounds(const Shape& solid) {
  const Box3 box = solid.bounds();
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(box.low[i]) || !std::isfinite(box.high[i])) throw InputError("the shape has no end: it cannot be meshed");
  return box;
}

/// The feature of the surface on which a lattice point lies; sharper ones come first.
enum class Feature : std::uint8_t { corner, crease, face, inside };

struct Sites {
  std::vector<Point> points;
  std::vector<Feature> places;
};

/// Rejects points that are too near to an accepted one; the cells of a hashed grid hold the accepted points.
class Spacing {
 public:
  explicit Spacing(double least) : least_(least) {}
  bool is_free(const Point& x) const {
    for (int i = 0; i < 27; ++i) {
      const auto cell = cells_.find(key(x, {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1}));
      if (cell == cells_.end()) continue;
      for (const Point& other : cell->second)
        if (length(x - other) < least_) return false;
    }
    return true;
  }
  void add(const Point& x) { cells_[key(x, {0, 0, 0})].push_back(x); }

 private:
  std::int64_t key(const Point& x, const std::array<int, 3>& offset) const {
    std::int64_t sum = 0;
    for (int i = 0; i < 3; ++i) sum = sum * 2'097'143 + static_cast<std::int64_t>(std::floor(x[i] / least_)) + offset[i];
    return sum;
  }
  double least_;
  std::unordered_map<std::int64_t, std::vector<Point>> cells_;
};

/// All lattice points within the box and a little around it. Of each row of the lattice only the part that crosses the box is visited.
template <class Visit>
void for_lattice_points(const Box3& box, double a, double margin, Visit visit) {
  static const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Point centre = 0.5 * (box.low + box.high);
  const int reach = static_cast<int>(std::ceil((0.5 * length(box.high - box.low) + margin) / a)) + 1;
  const auto place = [&](int i, int j, int k, double half) {
    const Eigen::Vector3d y = a * (turn * Eigen::Vector3d(i + half + 0.137, j + half + 0.271, k + half + 0.093));
    return centre + Vector3{y[0], y[1], y[2]};
  };
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      double first = -reach, last = reach;  // of k, by the box's faces and a little more
      for (int c = 0; c < 3; ++c) {
        const double start = place(i, j, 0, 0.25)[c], step = a * turn(c, 2);
        const double low = (box.low[c] - margin - a - start) / step, high = (box.high[c] + margin + a - start) / step;
        first = std::max(first, std::min(low, high));
        last = std::min(last, std::max(low, high));
      }
      for (int k = static_cast<int>(std::ceil(first)); k <= last; ++k)
        for (const double half : {0.0, 0.5}) {
          const Point x = place(i, j, k, half);
          bool near = true;
          for (int c = 0; c < 3; ++c) near = near && x[c] > box.low[c] - margin && x[c] < box.high[c] + margin;
          if (near) visit(x);
        }
    }
}

/// The lattice of constant `a` with its outer points moved onto the surface. Points on sharp features come first, then those on faces, then
/// those inside.
Sites sites(const Shape& solid, const Box3& box, double a) {
  const double d = a * std::sqrt(3.0) / 2;  // distance of nearest neighbours
  Sites all;
  for_lattice_points(box, a, d, [&](const Point& x) {
    const double distance = solid.distance(x);
    if (distance >= 0.5 * d) return;
    if (distance < -0.5 * d) {
      all.points.push_back(x);
      all.places.push_back(Feature::inside);
      return;
    }
    const auto foot = foot_on_surface(solid, x, 1e-6 * d, d);
    if (!foot) return;
    const Sharpest sharp = sharpest_near(solid, *foot, 0.6 * d);
    const bool snap = sharp.faces > 1 && length(sharp.at - *foot) < 0.6 * d;
    all.points.push_back(snap ? sharp.at : *foot);
    all.places.push_back(!snap ? Feature::face : sharp.faces > 2 ? Feature::corner : Feature::crease);
  });
  Sites kept;
  Spacing crowded(0.5 * d);
  for (const Feature place : {Feature::corner, Feature::crease, Feature::face, Feature::inside}) {
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      if (all.places[i] != place || (place != Feature::inside && !crowded.is_free(all.points[i]))) continue;
      if (place == Feature::corner || place == Feature::crease) crowded.add(all.points[i]);
      kept.points.push_back(all.points[i]);
      kept.places.push_back(place);
    }
  }
  return kept;
}

/// Whether a Delaunay tetrahedron is part of the solid. One between four points of a curved or flat part of the surface is dropped if it
/// has hardly any volume.
bool is_inside(const Shape& solid, const Sites& sites, const Tet& tet, double vertex_volume) {
  constexpr double k_sliver = 0.02;
  const auto on_surface = std::count_if(tet.begin(), tet.end(), [&](std::int32_t v) { return sites.places[v] != Feature::inside; });
  if (on_surface == 0) return true;
  if (on_surface == 4 && tet_volume(sites.points, tet) < k_sliver * vertex_volume) return false;
  const auto& x = sites.points;
  return solid.distance(0.25 * (x[tet[0]] + x[tet[1]] + x[tet[2]] + x[tet[3]])) <= 0;
}

TetMesh connect(const Shape& solid, const Sites& sites, double vertex_volume) {
  const std::vector<Tet> tets = delaunay_tets(sites.points);
  std::vector<char> kept(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) kept[t] = is_inside(solid, sites, tets[t], vertex_volume);
  return manifold_part(sites.points, tets, std::move(kept));
}

double miss(std::size_t found, double wanted) { return std::abs(static_cast<double>(found) / wanted - 1); }

/// The lattice with about the given number of points; `a` is the first guess of its constant and returns the final one.
Sites sites_of_count(const Shape& solid, const Box3& box, double wanted, double& a) {
  Sites found = sites(solid, box, a);
  for (int round = 0; round < 4 && miss(found.points.size(), wanted) > 0.004 && !found.points.empty(); ++round) {
    a *= std::cbrt(static_cast<double>(found.points.size()) / wanted);
    found = sites(solid, box, a);
  }
  return found;
}

}  // namespace

double solid_volume(const Shape& solid) {
  constexpr double k_cells = 1e6;
  const Box3 box = finite_bounds(solid);
  const Vector3 size = box.high - box.low;
  const double h = std::cbrt(size[0] * size[1] * size[2] / k_cells);
  double volume = 0;
  if (h > 0) {
    std::array<int, 3> n;
    for (int i = 0; i < 3; ++i) n[i] = static_cast<int>(std::ceil(size[i] / h));
    for (int i = 0; i < n[0]; ++i)
      for (int j = 0; j < n[1]; ++j)
        for (int k = 0; k < n[2]; ++k) {
          const Point x = box.low + h * Vector3{i + 0.5, j + 0.5, k + 0.5};
          volume += h * h * h * std::clamp(0.5 - solid.distance(x) / h, 0.0, 1.0);
        }
  }
  if (!(volume > 0)) throw InputError("the shape is empty: no point of its bounds is inside");
  return volume;
}

TetMesh lattice_tets(const Shape& solid, double volume_m3, std::size_t target, const Tell& tell) {
  const Box3 box = finite_bounds(solid);
  const double vertex_volume = volume_m3 / static_cast<double>(target);
  double a = std::cbrt(2 * vertex_volume);  // a lattice of constant a has two points per a^3
  auto wanted = static_cast<double>(target);
  TetMesh best;
  double best_a = a;
  for (int round = 0; round < 4; ++round) {
    tell(fmt::format("placing about {:.0f} vertices", wanted));
    const Sites lattice = sites_of_count(solid, box, wanted, a);
    tell(fmt::format("connecting {} vertices", lattice.points.size()));
    TetMesh mesh = connect(solid, lattice, vertex_volume);
    if (mesh.points.empty()) break;
    wanted *= static_cast<double>(target) / static_cast<double>(mesh.points.size());
    if (round == 0 || miss(mesh.points.size(), static_cast<double>(target)) < miss(best.points.size(), static_cast<double>(target)))
      best = std::move(mesh), best_a = a;
    if (miss(best.points.size(), static_cast<double>(target)) < 0.01) break;
  }
  if (best.tets.empty()) throw InputError(fmt::format("{} vertices are too few to fill the shape with tetrahedra", target));
  tell("making the volumes inside even");
  even_volumes(best, 0.5 * best_a * best_a * best_a);
  return best;
}

}  // namespace bake

// SPDX-License-Identifier: MIT
// Meshes that cover shapes are closed, even and where they should be.
#include "solver/boundary/surface_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/unit/boundary/sampling.h"

namespace bake {
namespace {

struct Named {
  const char* name;
  ShapePtr shape;
};

std::vector<Named> solids() {
  const ShapePtr ball = make_sphere({0, 0, 0}, 6), brick = make_box({0, 0, 0}, {5, 4, 3});
  return {{"ball", ball},
          {"grape", make_ellipsoid({0, 0, 0}, {9, 8, 6})},
          {"slice", make_cylinder({0, 0, 0}, {0, 0, 4}, 10)},
          {"brick", brick},
          {"loaf", make_superellipsoid({8, 6, 5}, 4, 2)},
          {"two balls", make_union({ball, make_sphere({0, 0, 5}, 4)})},
          {"turned brick", make_transformed(brick, 1.3, {30, 20, 10}, {1, 2, 3})}};
}

double whole_area(const SurfaceMesh& mesh) {
  const std::vector<double> areas = vertex_areas(mesh);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

constexpr double k_edge = 0.6, k_depth = 0.4;

TEST(Cover, IsClosedEvenAndAtItsDepth) {
  for (const auto& [name, shape] : solids()) {
    const SurfaceMesh mesh = cover(*shape, k_edge, k_depth);
    const auto hinges = hinges_of(mesh.triangles);
    EXPECT_EQ(2 * hinges.size(), 3 * mesh.triangles.size()) << name << ": not closed";
    double sum = 0, longest = 0, quality = 0, worst = 1, volume = 0;
    for (const SurfaceHinge& h : hinges) {
      const double edge = length(mesh.points[static_cast<std::size_t>(h.edge[1])] - mesh.points[static_cast<std::size_t>(h.edge[0])]);
      sum += edge;
      longest = std::max(longest, edge);
    }
    EXPECT_NEAR(sum / static_cast<double>(hinges.size()), k_edge, 0.07 * k_edge) << name;
    EXPECT_LT(longest, 1.6 * k_edge) << name;
    for (const SurfaceTriangle& t : mesh.triangles) {
      const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
      double squares = 0;
      for (std::size_t k = 0; k < 3; ++k) squares += dot(at(k) - at((k + 1) % 3), at(k) - at((k + 1) % 3));
      const double q = 4 * std::sqrt(3) * area_of(mesh, t) / squares;  // 1: equilateral
      quality += q;
      worst = std::min(worst, q);
      volume += dot(at(0), cross(at(1), at(2))) / 6;
    }
    EXPECT_GT(quality / static_cast<double>(mesh.triangles.size()), 0.88) << name;
    EXPECT_GT(worst, 0.4) << name;
    EXPECT_GT(volume, 0) << name << ": inside out";
    EXPECT_LT(volume, shape->volume()) << name;
    for (const Point& x : mesh.points) EXPECT_NEAR(shape->distance(x), -k_depth, 1e-5 * k_edge) << name;
  }
}

TEST(Cover, OfABallHasItsArea) {
  EXPECT_NEAR(whole_area(cover(*make_sphere({0, 0, 0}, 10), k_edge, k_depth)) / (4 * M_PI * 9.6 * 9.6), 1, 0.002);
}

TEST(Cover, IsTheSameEveryTime) {
  const ShapePtr ball = make_sphere({0, 0, 0}, 4);
  const SurfaceMesh one = cover(*ball, k_edge, k_depth), other = cover(*ball, k_edge, k_depth);
  EXPECT_EQ(one.points, other.points);
  EXPECT_EQ(one.triangles, other.triangles);
}

TEST(Cover, RefusesWhatIsTooThin) {
  const ShapePtr wafer = make_cylinder({0, 0, 0}, {0, 0, 0.9}, 10), crumb = make_sphere({0, 0, 0}, 0.3),
                 planet = make_sphere({0, 0, 0}, 1e4);
  for (const ShapePtr& shape : {wafer, crumb, planet}) EXPECT_THROW(cover(*shape, k_edge, k_depth), InputError);
}

TEST(PartInside, KeepsTrianglesOfARegionAndTheirVerticesOnly) {
  const SurfaceMesh half = part_inside(cover(*make_sphere({0, 0, 0}, 6), k_edge, k_depth), *make_half_space({0, 0, 0}, {0, 0, 1}));
  for (const double area : vertex_areas(half)) EXPECT_GT(area, 0);
  EXPECT_NEAR(whole_area(half) / (2 * M_PI * 5.6 * 5.6), 1, 0.03);
  for (const Point& x : half.points) EXPECT_LT(x[2], k_edge);
}

TEST(MoveInwards, GoesAgainstTheNormals) {
  SurfaceMesh mesh = cover(*make_sphere({0, 0, 0}, 6), k_edge, 0);
  move_inwards(mesh, 0.5);
  for (const Point& x : mesh.points) EXPECT_NEAR(length(x), 5.5, 0.01);
}

TEST(HingesOf, RefuseASurfaceThatTouchesItself) {
  EXPECT_THROW(hinges_of({{0, 1, 2}, {0, 1, 3}}), TornSurface);             // turned differently
  EXPECT_THROW(hinges_of({{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}), TornSurface);  // three at an edge
  EXPECT_EQ(hinges_of({{0, 1, 2}, {1, 0, 3}}).size(), 1U);
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "meshing/tets/even_volumes.h"
#include "meshing/tets/lattice_mesher.h"
#include "meshing/tets/manifold.h"
#include "meshing/tets/surface_foot.h"
#include "solver/core/errors.h"
#include "solver/core/vector3.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/meshing/solids.h"

namespace bake {
namespace {

struct NamedSolid {
  const char* name;
  ShapePtr solid;
  double volume;  ///< [m^3]; 0: not known on paper
  std::size_t target;
};

class ASolid : public testing::TestWithParam<NamedSolid> {};

/// Every vertex has tetrahedra, the boundary is closed, volumes are positive and add up.
void expect_sound(const TetMesh& mesh) {
  const TetQuality quality = tet_quality(mesh);
  EXPECT_EQ(quality.odd_edges, 0u);
  EXPECT_EQ(quality.loose, 0u);
  const std::vector<double> volumes = vertex_volumes(mesh);
  EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0);
  EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), quality.volume, 1e-12 * quality.volume);
  for (const Tet& tet : mesh.tets) ASSERT_GT(tet_volume(mesh.points, tet), 0);
}

TEST_P(ASolid, IsFilledWithTheVerticesAskedForAndWatertight) {
  const auto& [name, solid, volume, target] = GetParam();
  const TetMesh mesh = filled(*solid, target);
  EXPECT_NEAR(static_cast<double>(mesh.points.size()), static_cast<double>(target), 0.02 * static_cast<double>(target));
  expect_sound(mesh);
  const double expected = volume > 0 ? volume : solid_volume(*solid);
  EXPECT_NEAR(bake::volume(mesh), expected, 0.02 * expected);
  for (const Point& x : mesh.points) ASSERT_LT(solid->distance(x), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Tets, ASolid,
                         testing::Values(NamedSolid{"ball", ball(), 4.0 / 3 * M_PI * 1e-3, 5000},
                                         NamedSolid{"brick", brick(), 8 * 0.00048, 5000}, NamedSolid{"coarse_brick", brick(), 0, 400},
                                         NamedSolid{"slit_loaf", slit_loaf(), 0, 9000},
                                         NamedSolid{"two_balls",
                                                    make_union({ball(), make_transformed(ball(), 0.7, {0, 0, 0}, {0.3, 0, 0})}),
                                                    4.0 / 3 * M_PI * 1e-3 * 1.343, 4000}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Tets, HaveInnerVerticesOfEvenVolume) {
  for (const auto& [solid, target] : {std::pair{ball(), 20000}, {slit_loaf(), 9000}, {brick(), 2000}}) {
    const TetQuality quality = tet_quality(filled(*solid, target));
    EXPECT_LT(quality.inner_spread, 0.04);
    EXPECT_GT(quality.inner_spread, 0.001);
  }
}

TEST(EvenVolumes, LeaveTheSurfaceAndTheVolumeAndFlattenNothing) {
  TetMesh mesh = filled(*ball(), 3000);
  std::vector<char> outer(mesh.points.size(), 0);
  for (const Triangle& t : boundary_triangles(mesh.tets, tet_neighbours(mesh.tets, mesh.points.size())))
    for (const std::int32_t v : t) outer[v] = 1;
  std::vector<char> near = outer;
  for (const Tet& tet : mesh.tets)
    for (const std::int32_t v : tet)
      if (std::any_of(tet.begin(), tet.end(), [&](std::int32_t other) { return outer[other]; })) near[v] = 1;
  const std::size_t middle = std::find(near.begin(), near.end(), 0) - near.begin();
  ASSERT_LT(middle, near.size());
  const double wanted = vertex_volumes(mesh)[middle];
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (int i = 0; i < 3 && !near[v]; ++i) mesh.points[v][i] += 0.1 * std::cbrt(wanted) * std::sin(static_cast<double>(7 * v + 3 * i));
  const TetMesh shaken = mesh;
  const TetQuality before = tet_quality(shaken);
  for (const Tet& tet : shaken.tets) ASSERT_GT(tet_volume(shaken.points, tet), 0);

  even_volumes(mesh, wanted);
  const TetQuality after = tet_quality(mesh);
  EXPECT_LT(after.inner_spread, 0.5 * before.inner_spread);
  EXPECT_NEAR(after.volume, before.volume, 1e-12 * before.volume);
  EXPECT_EQ(mesh.tets, shaken.tets);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) ASSERT_TRUE(!outer[v] || mesh.points[v] == shaken.points[v]);
  for (const Tet& tet : mesh.tets) ASSERT_GE(tet_volume(mesh.points, tet), (0.5 - 1e-9) * tet_volume(shaken.points, tet));
}

TEST(Tets, AreTheSameEveryTime) {
  const TetMesh a = filled(*slit_loaf(), 3000), b = filled(*slit_loaf(), 3000);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets, b.tets);
}

TEST(Tets, TellTheirPhases) {
  std::vector<std::string> phases;
  filled(*ball(), 1000, [&](const std::string& doing) { phases.push_back(doing.substr(0, doing.find(' '))); });
  ASSERT_GE(phases.size(), 2u);
  phases.resize(2);
  EXPECT_EQ(phases, (std::vector<std::string>{"placing", "connecting"}));
}

TEST(Tets, OfABoxReachItsEdgesAndCorners) {
  const TetMesh mesh = filled(*brick(), 5000);
  int corners = 0, edges = 0;
  for (const Point& x : mesh.points) {
    const int faces = (std::abs(x[0]) > 0.0999) + (std::abs(x[1]) > 0.0799) + (std::abs(x[2]) > 0.0599);
    corners += faces == 3;
    edges += faces == 2;
  }
  EXPECT_GE(corners, 6);  // of 8
  EXPECT_GE(edges, 100);
}

std::string error_of(const Shape& solid, std::size_t target) {
  return message_of<InputError>([&] { filled(solid, target); });
}

TEST(Tets, OfWhatCannotBeFilledAreRefused) {
  EXPECT_EQ(error_of(*make_half_space({0, 0, 0}, {0, 0, 1}), 1000), "the shape has no end: it cannot be meshed");
  const ShapePtr apart = make_intersection({ball(), make_transformed(ball(), 1, {0, 0, 0}, {1, 0, 0})});
  EXPECT_EQ(error_of(*apart, 1000), "the shape is empty: no point of its bounds is inside");
  EXPECT_EQ(error_of(*ball(), 4), "4 vertices are too few to fill the shape with tetrahedra");
}

const TetMesh k_corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};

TEST(ATetMesh, IsMeasured) {
  const TetQuality quality = tet_quality(k_corner);
  EXPECT_NEAR(quality.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(quality.least_angle, std::acos(1 / std::sqrt(3)) * 180 / M_PI, 1e-9);
  EXPECT_EQ(quality.boundary, 4u);
  EXPECT_EQ(quality.loose, 0u);
  EXPECT_EQ(quality.odd_edges, 0u);
}

TEST(ATetMesh, WithThreeTetrahedraAtAFaceIsRefused) {
  EXPECT_EQ(message_of<InputError>([] {
              tet_neighbours({{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}, 6);
            }),
            "three tetrahedra share the face of vertices 0, 1 and 2, allowed: two");
}

TEST(OddEdges, AreThoseWithoutTwoTrianglesOfOppositeDirections) {
  const std::vector<Triangle> closed = boundary_triangles(k_corner.tets, tet_neighbours(k_corner.tets, 4));
  EXPECT_EQ(count_odd_edges(closed), 0u);
  std::vector<Triangle> open = closed, turned = closed, touching = closed;
  open.pop_back();
  EXPECT_EQ(count_odd_edges(open), 3u);
  std::swap(turned[0][0], turned[0][1]);
  EXPECT_EQ(count_odd_edges(turned), 3u);
  for (const Triangle& t : closed) {  // another body, which shares the edge from 2 to 3
    touching.push_back(t);
    for (std::int32_t& v : touching.back()) v += v < 2 ? 10 : 0;
  }
  EXPECT_EQ(count_odd_edges(touching), 1u);
}

/// Eight tetrahedra around a centre, the only inner vertex.
TetMesh octahedron(const Point& centre, double radius) {
  TetMesh mesh{{centre}, {}};
  for (int i = 0; i < 3; ++i)
    for (const double sign : {-radius, radius}) {
      mesh.points.push_back(centre);
      mesh.points.back()[i] += sign;
    }
  for (const std::int32_t x : {1, 2})
    for (const std::int32_t y : {3, 4})
      for (const std::int32_t z : {5, 6}) mesh.tets.push_back((x + y + z) % 2 == 0 ? Tet{0, x, y, z} : Tet{0, y, x, z});
  return mesh;
}

/// Both meshes as one, with one vertex where both have one.
TetMesh together(TetMesh a, const TetMesh& b) {
  for (Tet tet : b.tets) {
    for (std::int32_t& v : tet) {
      const Point& x = b.points[v];
      v = static_cast<std::int32_t>(std::find(a.points.begin(), a.points.end(), x) - a.points.begin());
      if (v == static_cast<std::int32_t>(a.points.size())) a.points.push_back(x);
    }
    a.tets.push_back(tet);
  }
  return a;
}

TetMesh manifold_part_of(const TetMesh& mesh) { return manifold_part(mesh.points, mesh.tets, std::vector<char>(mesh.tets.size(), 1)); }

TEST(TheManifoldPart, IsTheLargerOfWhatTouchesAtAVertexOrAnEdge) {
  const TetMesh small = octahedron({-1, 0, 0}, 1), large = octahedron({2, 0, 0}, 2), beside = octahedron({0, 1, 0}, 1);
  ASSERT_NEAR(volume(large), 4.0 / 3 * 8, 1e-12);
  for (const TetMesh& mesh : {together(small, large), together(large, small)}) {
    ASSERT_EQ(mesh.points.size(), 13u) << "one vertex belongs to both";
    const TetMesh part = manifold_part_of(mesh);
    EXPECT_NEAR(volume(part), volume(large), 1e-12);
    EXPECT_EQ(part.points.size(), 7u);
  }
  const TetMesh at_an_edge = together(small, beside);
  ASSERT_EQ(at_an_edge.points.size(), 12u) << "two vertices belong to both";
  EXPECT_NEAR(volume(manifold_part_of(at_an_edge)), volume(small), 1e-12);
}

TEST(TheManifoldPart, HasNoShredsWithoutAnInnerVertex) {
  const TetMesh body = octahedron({0, 0, 0}, 1), far = octahedron({5, 0, 0}, 0.1);
  TetMesh shred = k_corner;
  for (Point& x : shred.points) x = x + Point{10, 0, 0};
  EXPECT_NEAR(volume(manifold_part_of(together(together(shred, body), far))), volume(body) + volume(far), 1e-12);
  EXPECT_TRUE(manifold_part_of(shred).tets.empty());
}

TEST(SurfaceFoot, IsOnTheSurfaceAndNear) {
  const ShapePtr loaf = slit_loaf();
  for (const Point& x : {Point{0.3, 0.1, 0.2}, Point{-0.1, 0.2, 0.19}, Point{0.02, 0, 0.12}}) {
    const auto foot = foot_on_surface(*loaf, x, 1e-9, 0.2);
    ASSERT_TRUE(foot);
    EXPECT_LT(std::abs(loaf->distance(*foot)), 1e-9);
  }
  EXPECT_FALSE(foot_on_surface(*loaf, {0, 0, 2}, 1e-9, 0.2));
}

TEST(SurfaceFoot, FindsCreasesAndCornersButNotBends) {
  const ShapePtr box = brick();
  const Sharpest edge = sharpest_near(*box, {0.095, 0.08, 0.01}, 0.02), corner = sharpest_near(*box, {0.095, 0.08, 0.055}, 0.02);
  EXPECT_EQ(edge.faces, 2);
  EXPECT_LT(length(edge.at - Point{0.1, 0.08, edge.at[2]}), 1e-6);
  EXPECT_EQ(corner.faces, 3);
  EXPECT_LT(length(corner.at - Point{0.1, 0.08, 0.06}), 1e-6);
  EXPECT_EQ(sharpest_near(*box, {0.05, 0.08, 0.01}, 0.02).faces, 1);
  EXPECT_EQ(sharpest_near(*ball(0.02), {0.02, 0, 0}, 0.02).faces, 1) << "round, if strongly";
  for (const auto& [between_normals_deg, faces] : {std::pair{10, 1}, {30, 2}, {60, 2}}) {
    const double half = between_normals_deg * M_PI / 360;
    const ShapePtr roof = make_intersection({make_half_space({0, 0, 0}, {std::sin(half), 0, std::cos(half)}),
                                             make_half_space({0, 0, 0}, {-std::sin(half), 0, std::cos(half)})});
    EXPECT_EQ(sharpest_near(*roof, {0.005, 0, -0.005 * std::tan(half)}, 0.02).faces, faces) << between_normals_deg;
  }
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// Closed surfaces as people bring them, and what is said of those that are broken.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "meshing/skin/skin.h"
#include "meshing/solid/triangle_mesh.h"
#include "meshing/tets/feature_mesher.h"
#include "meshing/tets/lattice_mesher.h"
#include "solver/core/errors.h"
#include "solver/core/vector3.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/meshing/solids.h"

namespace bake {
namespace {

/// A cube with one corner at `low`, edges of 0.1 m.
TriangleMesh cube(const Point& low = {0, 0, 0}) {
  TriangleMesh mesh;
  for (int v = 0; v < 8; ++v) mesh.points.push_back(low + 0.1 * Vector3{double(v >> 2), double(v >> 1 & 1), double(v & 1)});
  constexpr int k_sides[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  for (const auto& s : k_sides) {
    mesh.triangles.push_back({s[0], s[1], s[2]});
    mesh.triangles.push_back({s[0], s[2], s[3]});
  }
  return mesh;
}

/// Both surfaces as one.
TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::int32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

std::string as_off(const TriangleMesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.points.size(), mesh.triangles.size());
  for (const Point& x : mesh.points) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  for (const Triangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

std::string as_obj(const TriangleMesh& mesh) {
  std::string text;
  for (const Point& x : mesh.points) text += fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  for (const Triangle& t : mesh.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string as_ply(const TriangleMesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.points.size(), mesh.triangles.size());
  for (const Point& x : mesh.points) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  for (const Triangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

std::string as_stl(const TriangleMesh& mesh) {
  std::string text = "solid cube\n";
  for (const Triangle& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::int32_t v : t) text += fmt::format("vertex {} {} {}\n", mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

class ASurfaceFile : public testing::Test {
 protected:
  TriangleMesh read(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return read_triangle_mesh(folder_ / name);
  }
  std::string error_of(const std::string& name, const std::string& text) const {
    return message_of<InputError>([&] { read(name, text); }).substr(folder_.path().string().size() + 1);
  }
  const TemporaryFolder folder_;
};

TEST_F(ASurfaceFile, IsReadInFourFormats) {
  for (const auto& [name, text] : {std::pair{"cube.off", as_off(cube())},
                                   {"cube.obj", as_obj(cube())},
                                   {"cube.ply", as_ply(cube())},
                                   {"cube.stl", as_stl(cube())},
                                   {"CUBE.STL", as_stl(cube())}}) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(is_triangle_file(name));
    const TriangleMesh mesh = read(name, text);
    EXPECT_EQ(mesh.points.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_NEAR(enclosed_volume(mesh), 1e-3, 1e-9);
    EXPECT_NEAR(area(mesh), 0.06, 1e-8);
    EXPECT_TRUE(has_sharp_edges(mesh));
  }
  EXPECT_FALSE(is_triangle_file("scene.toml"));
}

TEST_F(ASurfaceFile, WithLargerFacesIsSplitIntoTriangles) {
  std::string text = "OFF\n8 6 0\n";
  for (const Point& x : cube().points) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  text += "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n";
  EXPECT_EQ(read("cube.off", text).triangles, cube().triangles);
}

TEST_F(ASurfaceFile, ThatIsBrokenIsRefusedWithWhatAndWhere) {
  TriangleMesh open = cube(), inside_out = cube(), turned = cube(), fin = cube(), flat = cube();
  open.triangles.pop_back();
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  fin.points.push_back({0.05, -0.05, 0.05});
  fin.triangles.push_back({0, 1, 8});
  flat.triangles.push_back({0, 0, 1});
  TriangleMesh touching = together(cube(), cube({0.1, 0.1, 0.1}));
  for (Triangle& t : touching.triangles)
    for (std::int32_t& v : t) v = v == 8 ? 7 : v;

  EXPECT_EQ(error_of("a.off", as_off(open)),
            "a.off: is open at the edge from vertex 1 (0 0 0.1) to vertex 3 (0 0.1 0.1), allowed: closed surfaces");
  EXPECT_EQ(error_of("a.off", as_off(inside_out)),
            "a.off: is inside out: its volume is -0.001 m^3; triangles must be counter-clockwise from outside");
  EXPECT_EQ(error_of("a.off", as_off(turned)),
            "a.off: has neighbouring triangles that turn different ways at the edge from vertex 0 (0 0 0) to vertex 1 (0 0 0.1)");
  EXPECT_EQ(error_of("a.off", as_off(fin)),
            "a.off: is not manifold at the edge from vertex 0 (0 0 0) to vertex 1 (0 0 0.1): 3 triangles meet there, allowed: 2");
  EXPECT_EQ(error_of("a.off", as_off(flat)), "a.off: triangle 12 at vertex 0 (0 0 0) has no area");
  EXPECT_EQ(error_of("a.off", as_off(touching)), "a.off: is not manifold at vertex 7 (0.1 0.1 0.1): parts of the surface touch there");
  EXPECT_EQ(error_of("a.off", as_off(together(cube(), cube({0.05, 0.05, 0.05})))),
            "a.off: intersects itself: triangles 10 and 12 at vertex 1 (0 0 0.1) do, and 18 pairs in all");
  TriangleMesh small = cube({0.02, 0.02, 0.02});
  for (Point& x : small.points) x = 0.5 * x + Point{0.02, 0.02, 0.02};
  EXPECT_EQ(error_of("a.off", as_off(together(cube(), small))),
            "a.off: has a shell that is inside out: shells must in turn hold and leave out");
  EXPECT_EQ(error_of("a.off", "OFF\n0 0 0\n"), "a.off: is empty: it has no triangles");
  EXPECT_EQ(error_of("a.stl", "hello"), "a.stl: is empty: it has no triangles");
  EXPECT_NE(error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n").find("a.off: damaged"), std::string::npos);
  EXPECT_NE(error_of("a.off", "OFF\n8 12 0\n0 0 0\n0 0\n").find("a.off: damaged"), std::string::npos);
  EXPECT_THROW(read_triangle_mesh(folder_ / "missing.off"), InputError);
}

TEST_F(ASurfaceFile, WithAHollowIsAllowed) {
  TriangleMesh hollow = cube();
  for (Point& x : hollow.points) x = 0.5 * x + Point{0.02, 0.02, 0.02};
  for (Triangle& t : hollow.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(enclosed_volume(read("a.off", as_off(together(cube(), hollow)))), 1e-3 * (1 - 0.125), 1e-9);
}

TEST(FeatureTets, KeepEdgesAndCornersAndTheVolume) {
  const TetMesh mesh = feature_tets(cube(), 3000);
  EXPECT_NEAR(static_cast<double>(mesh.points.size()), 3000, 60);
  const TetQuality quality = tet_quality(mesh);
  EXPECT_NEAR(quality.volume, 1e-3, 1e-12);
  EXPECT_EQ(quality.odd_edges, 0u);
  EXPECT_EQ(quality.loose, 0u);
  EXPECT_GT(quality.least_angle, 5);
  for (const Point& corner : cube().points)
    EXPECT_TRUE(std::any_of(mesh.points.begin(), mesh.points.end(), [&](const Point& x) { return length(x - corner) < 1e-9; }));
}

TEST(FeatureTets, AreTheSameEveryTime) {
  const TetMesh a = feature_tets(cube(), 1000), b = feature_tets(cube(), 1000);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets, b.tets);
}

/// Even triangles on a solid's surface, closed, looking outwards.
void expect_even(const Shape& solid, const TriangleMesh& skin, double edge) {
  EXPECT_EQ(count_odd_edges(skin.triangles), 0u);
  double sum = 0;
  for (const Triangle& t : skin.triangles)
    for (int k = 0; k < 3; ++k)
      sum += length(skin.points[t[k]] - skin.points[t[(k + 1) % 3]]) / (3.0 * static_cast<double>(skin.triangles.size()));
  EXPECT_NEAR(sum, edge, 0.1 * edge);
  for (const Point& x : skin.points) ASSERT_LT(std::abs(solid.distance(x)), 1e-4 * edge);
}

TEST(Skin, IsEvenClosedAndLooksOutwards) {
  const TriangleMesh round = make_skin(*ball(), nullptr, 0.01);
  expect_even(*ball(), round, 0.01);
  EXPECT_NEAR(enclosed_volume(round), 4.0 / 3 * M_PI * 1e-3, 0.01 * 4.0 / 3 * M_PI * 1e-3);
  EXPECT_NEAR(area(round), 4 * M_PI * 0.01, 0.01 * 4 * M_PI * 0.01);
}

TEST(Skin, TellsItsPhases) {
  std::string last;
  make_skin(*ball(), nullptr, 0.03, [&](const std::string& doing) { last = doing; });
  EXPECT_EQ(last.substr(0, 7), "moving ") << last;
}

TEST(Skin, OfASurfaceKeepsItsEdges) {
  const TriangleMesh surface = cube(), skin = make_skin(*make_triangle_solid(surface), &surface, 0.01);
  expect_even(*make_triangle_solid(surface), skin, 0.01);
  EXPECT_NEAR(enclosed_volume(skin), 1e-3, 1e-9);
}

TEST(Skin, OfEdgesThatDoNotFitIsRefused) {
  EXPECT_THROW(make_skin(*ball(), nullptr, 1), InputError);
  EXPECT_THROW(make_skin(*ball(), nullptr, 1e-6), InputError);
}

TEST(TriangleSolid, MeasuresItsDistance) {
  const ShapePtr solid = make_triangle_solid(cube());
  EXPECT_NEAR(solid->distance({0.05, 0.05, 0.03}), -0.03, 1e-12);
  EXPECT_NEAR(solid->distance({0.05, 0.05, 0.13}), 0.03, 1e-12);
  EXPECT_NEAR(solid->distance({0.2, 0.2, 0.2}), 0.1 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(solid->normal({0.05, 0.05, 0.09})[2], 1, 1e-12);
  EXPECT_NEAR(solid->normal({0.05, 0.05, 0.1})[2], 1, 1e-12);
  EXPECT_NEAR(solid_volume(*solid), 1e-3, 1e-6);
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// Closed surfaces as people bring them, and what is said of those that are broken.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <functional>
#include <limits>
#include <regex>

#include "meshing/skin/skin.h"
#include "meshing/solid/cleaning.h"
#include "meshing/solid/polygon_soup.h"
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
  TriangleMesh read(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    said_.clear();
    SurfaceReading reading;
    reading.say = [&](const std::string& line) { said_ += line; };
    return read_triangle_mesh(folder_ / name, reading);
  }
  std::string error_of(const std::string& name, const std::string& text) {
    return message_of<InputError>([&] { read(name, text); }).substr(folder_.path().string().size() + 1);
  }
  const TemporaryFolder folder_;
  std::string said_;  ///< of the last surface
};

TEST_F(ASurfaceFile, IsReadInFourFormats) {
  for (const auto& [name, text] : {std::pair{"cube.off", as_off(cube())},
                                   {"cube.obj", as_obj(cube())},
                                   {"cube.ply", as_ply(cube())},
                                   {"cube.stl", as_stl(cube())},
                                   {"CUBE.STL", as_stl(cube())}}) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(is_surface_file(name));
    const TriangleMesh mesh = read(name, text);
    EXPECT_EQ(mesh.points.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_NEAR(enclosed_volume(mesh), 1e-3, 1e-9);
    EXPECT_NEAR(area(mesh), 0.06, 1e-8);
    EXPECT_TRUE(has_sharp_edges(mesh));
  }
  EXPECT_FALSE(is_surface_file("scene.toml"));
}

TEST_F(ASurfaceFile, WithLargerFacesIsSplitIntoTriangles) {
  std::string text = "OFF\n8 6 0\n";
  for (const Point& x : cube().points) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  text += "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n";
  EXPECT_EQ(read("cube.off", text).triangles, cube().triangles);
}

TEST_F(ASurfaceFile, ThatIsBrokenIsRefusedWithWhatAndWhere) {
  TriangleMesh open = cube(), fin = cube();
  open.triangles.pop_back();
  fin.points.push_back({0.05, -0.05, 0.05});
  fin.triangles.push_back({0, 1, 8});
  TriangleMesh touching = together(cube(), cube({0.1, 0.1, 0.1}));
  touching.points[8] = {0.1, 0.1, 0.1};

  EXPECT_EQ(error_of("a.off", as_off(open)),
            "a.off: is open at the edge from vertex 1 (0 0 0.1) to vertex 3 (0 0.1 0.1), and at 3 edges in all, allowed: closed surfaces");
  EXPECT_EQ(error_of("a.off", as_off(fin)),
            "a.off: is not manifold at the edge from vertex 0 (0 0 0) to vertex 1 (0 0 0.1): 3 triangles meet there, allowed: 2");
  EXPECT_EQ(error_of("a.off", as_off(touching)), "a.off: is not manifold at vertex 7 (0.1 0.1 0.1): parts of the surface touch there");
  EXPECT_EQ(error_of("a.off", as_off(together(cube(), cube({0.05, 0.05, 0.05})))),
            "a.off: intersects itself: triangles 10 and 12 at vertex 1 (0 0 0.1) do, and 18 pairs in all");
  TriangleMesh small = cube({0.02, 0.02, 0.02});
  for (Point& x : small.points) x = 0.5 * x + Point{0.02, 0.02, 0.02};
  EXPECT_EQ(error_of("a.off", as_off(together(cube(), small))),
            "a.off: has a shell that is inside out: shells must in turn hold and leave out");
}

TEST_F(ASurfaceFile, ThatIsNoneSaysWhy) {
  EXPECT_EQ(error_of("a.off", "OFF\n0 0 0\n"), "a.off: is empty: it has no triangles");
  EXPECT_EQ(error_of("a.obj", "hello\n"), "a.obj: is empty: it has no triangles");
  EXPECT_EQ(error_of("a.stl", "hello"), "a.stl: is no STL file: it does not begin with 'solid' and is too short for a binary one");
  EXPECT_EQ(error_of("a.off", "hello"), "a.off: is damaged: it does not begin with OFF");
  EXPECT_EQ(error_of("a.ply", "hello"), "a.ply: is damaged: it does not begin with ply");
  EXPECT_EQ(error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "a.off: face 0: found vertex 3, allowed: 0 to 2");
  EXPECT_EQ(error_of("a.off", "OFF\n8 12 0\n0 0 0\n0 0\n"), "a.off: line 4: found the end of the line, allowed: a number");
  EXPECT_EQ(error_of("a.off", "OFF\n8 12 0\n0 0 0\n"), "a.off: is damaged: it ends behind 1 of its 8 vertices");
  EXPECT_EQ(error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999 0 1 2\n"),
            "a.off: line 6: found a face of 999999999 corners and 3 words behind, allowed: as many words as corners");
  EXPECT_EQ(error_of("a.obj", "v 0 0 0\nf 1 2 3\n"), "a.obj: line 2: found vertex 2, allowed: 1 to 1, or -1 to -1");
  EXPECT_EQ(error_of("a.obj", "v 0 0 zero\n"), "a.obj: line 1: found zero, allowed: a number");
  EXPECT_EQ(error_of("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"), "a.stl: is damaged: it ends within a facet");
  std::string cut_off(84, '\0');
  cut_off[80] = 5;
  EXPECT_EQ(error_of("a.stl", cut_off), "a.stl: is cut off: it announces 5 facets and has 0");
  const std::string heading = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty double x\n";
  EXPECT_EQ(error_of("a.ply", heading + "end_header\n12345678"), "a.ply: is damaged: it ends too early");
  EXPECT_EQ(error_of("a.ply", heading), "a.ply: is damaged: its heading has no end");
  EXPECT_EQ(error_of("a.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\nend_header\n2000000000 1 2\n"),
            "a.ply: is damaged: a list of 2000000000 numbers");
  std::filesystem::create_directory(folder_ / "folder.stl");
  EXPECT_EQ(message_of<InputError>([&] { read_triangle_mesh(folder_ / "folder.stl"); }),
            (folder_ / "folder.stl").string() + ": is a folder, allowed: a file");
  EXPECT_EQ(message_of<InputError>([&] { read_triangle_mesh(folder_ / "missing.off"); }),
            (folder_ / "missing.off").string() + ": cannot open");
}

/// The same surface with corners of its own for every triangle, and what stands in `first` behind the others in the same place.
TriangleMesh with_own_corners(const TriangleMesh& mesh, double apart_m = 0) {
  TriangleMesh result;
  for (const Triangle& t : mesh.triangles) {
    Triangle own;
    for (int k = 0; k < 3; ++k) {
      own[k] = static_cast<std::int32_t>(result.points.size());
      result.points.push_back(mesh.points[t[k]] + (own[k] % 2 ? apart_m : -apart_m) * Vector3{1, 0.5, -0.5});
    }
    result.triangles.push_back(own);
  }
  return result;
}

TEST_F(ASurfaceFile, WithRepeatedCornersIsJoined) {
  const TriangleMesh parted = with_own_corners(cube());
  for (const auto& [name, text] :
       {std::pair{"cube.off", as_off(parted)}, {"cube.obj", as_obj(parted)}, {"cube.ply", as_ply(parted)}, {"cube.stl", as_stl(parted)}}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read(name, text);
    EXPECT_EQ(mesh.points.size(), 8u);
    EXPECT_NEAR(enclosed_volume(mesh), 1e-3, 1e-12);
    const bool usual = std::string(name) == "cube.stl";  // the format knows no shared corners
    EXPECT_EQ(said_, usual ? "" : (folder_ / name).string() + ": mended: 28 repeated corners joined");
  }
}

TEST_F(ASurfaceFile, WithCornersARoundingApartIsJoined) {
  for (const double apart_m : {2e-7, 8e-6}) {
    const TriangleMesh mesh = read("cube.stl", as_stl(with_own_corners(cube({1, 1, 1}), apart_m)));
    EXPECT_EQ(mesh.points.size(), 8u);
    EXPECT_NEAR(enclosed_volume(mesh), 1e-3, 1e-6);
    EXPECT_NE(said_.find("joined that were up to "), std::string::npos) << said_;
  }
  // 2.9e-5 m apart, where 2e-5 of 1.1 m are joined
  EXPECT_NE(error_of("gaps.stl", as_stl(with_own_corners(cube({1, 1, 1}), 1.2e-5))).find("gaps.stl: is open at the edge"),
            std::string::npos);
}

TEST_F(ASurfaceFile, WithConcaveFacesIsSplitWithinThem) {
  std::string text;  // an L as prism
  for (const char* z : {"0", "1"}) text += fmt::format("v 0 0 {0}\nv 2 0 {0}\nv 2 1 {0}\nv 1 1 {0}\nv 1 2 {0}\nv 0 2 {0}\n", z);
  // the upper face begins at a corner from which a fan leaves the L
  text += "f 8 9 10 11 12 7\nf 6 5 4 3 2 1\n";
  for (int k = 0; k < 6; ++k) text += fmt::format("f {} {} {} {}\n", k + 1, (k + 1) % 6 + 1, (k + 1) % 6 + 7, k + 7);
  const TriangleMesh mesh = read("l.obj", text);
  EXPECT_NEAR(enclosed_volume(mesh), 3, 1e-12);
  EXPECT_NEAR(area(mesh), 2 * 3 + 8, 1e-12);
  EXPECT_EQ(mesh.triangles.size(), 20u);
}

TEST_F(ASurfaceFile, WithAFaceThatTurnsInDeeplyIsSplitWithinIt) {
  std::string text;  // a dart as prism, whose largest corner holds the one that turns in
  for (const char* z : {"0", "1"}) text += fmt::format("v 0 0 {0}\nv 4 0 {0}\nv 1 1 {0}\nv 0 4 {0}\n", z);
  text += "f 4 3 2 1\nf 5 6 7 8\n";
  for (int k = 0; k < 4; ++k) text += fmt::format("f {} {} {} {}\n", k + 1, (k + 1) % 4 + 1, (k + 1) % 4 + 5, k + 5);
  const TriangleMesh mesh = read("dart.obj", text);
  EXPECT_NEAR(enclosed_volume(mesh), 4, 1e-12);
  EXPECT_NEAR(area(mesh), 2 * 4 + 8 + 2 * std::sqrt(10), 1e-12);
}

TEST_F(ASurfaceFile, IsCleanedAlikeAtEverySize) {
  for (const double scale : {1e-8, 1.0, 1e6}) {
    TriangleMesh mesh = cube();
    for (Point& x : mesh.points) x = scale * x;
    EXPECT_EQ(read("a.off", as_off(mesh)).triangles, cube().triangles);
    EXPECT_EQ(said_.find("mended"), std::string::npos) << said_;
  }
}

TEST_F(ASurfaceFile, WithCornersInALineOfAFaceHasNoFlatTriangles) {
  // a cube of 1 m whose lower face has a fifth corner in the middle of an edge, as the face beside it has
  const TriangleMesh mesh = read("cube.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0.5 0 0\n"
                                 "f 1 4 3 2 9\nf 5 6 7 8\nf 1 9 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  EXPECT_NEAR(enclosed_volume(mesh), 1, 1e-12);
  EXPECT_NEAR(area(mesh), 6, 1e-12);
}

TEST_F(ASurfaceFile, WhoseTrianglesTurnBothWaysIsTurnedOutwards) {
  TriangleMesh inside_out = cube(), turned = cube(), mostly_turned = cube();
  for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  for (std::size_t t = 0; t < 9; ++t) std::swap(mostly_turned.triangles[t][0], mostly_turned.triangles[t][1]);
  for (const TriangleMesh& mesh : {inside_out, turned, mostly_turned}) {
    EXPECT_NEAR(enclosed_volume(read("a.off", as_off(mesh))), 1e-3, 1e-12);
    EXPECT_EQ(said_, (folder_ / "a.off").string() + ": mended: triangles turned so that all look outwards");
  }
}

TEST_F(ASurfaceFile, WithFlatAndDoubledTrianglesLosesThem) {
  TriangleMesh mesh = cube();
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back(mesh.triangles[5]);
  // a corner in the middle of an edge on one side only, closed by a triangle without area
  const Triangle cut = mesh.triangles[0];
  const auto middle = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.push_back(0.5 * (mesh.points[cut[0]] + mesh.points[cut[1]]));
  mesh.triangles[0] = {cut[0], middle, cut[2]};
  mesh.triangles.push_back({middle, cut[1], cut[2]});
  mesh.triangles.push_back({cut[0], cut[1], middle});
  const TriangleMesh clean = read("a.off", as_off(mesh));
  EXPECT_EQ(clean.triangles.size(), 14u);
  EXPECT_NEAR(enclosed_volume(clean), 1e-3, 1e-12);
  EXPECT_NEAR(area(clean), 0.06, 1e-12);
  EXPECT_EQ(said_, (folder_ / "a.off").string() + ": mended: 2 faces without area removed, 1 doubled face removed");
}

TEST_F(ASurfaceFile, OfTwoBodiesWithAWallBetweenThemBecomesOne) {
  const TriangleMesh mesh = read("a.off", as_off(together(cube(), cube({0.1, 0, 0}))));
  EXPECT_NEAR(enclosed_volume(mesh), 2e-3, 1e-12);
  EXPECT_EQ(mesh.triangles.size(), 20u);
}

TEST_F(ASurfaceFile, MayHoldWhatASurfaceDoesNotNeed) {
  std::string obj = "\xEF\xBB\xBF# cube\no cube\n" + as_obj(cube());
  obj.replace(obj.find("f "), 2, "l 1 2\np 3\nvt 0 0\nvn 0 0 1\nusemtl red\nf \\\n");
  EXPECT_EQ(read("cube.obj", obj).triangles.size(), 12u);
  std::string slashes = as_obj(cube());
  slashes.replace(slashes.rfind("f "), std::string::npos, "f -7/1/2 -1//3 -5/4\n");  // vertices 2, 8, 4
  EXPECT_EQ(read("cube.obj", slashes).triangles, cube().triangles);
  std::string stl = as_stl(cube());
  std::transform(stl.begin(), stl.end(), stl.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  EXPECT_EQ(read("cube.stl", stl).triangles.size(), 12u);
  std::string loose = as_obj(cube());
  EXPECT_EQ(read("cube.obj", "v nan 0 0\n" + std::regex_replace(loose, std::regex("f (\\d) (\\d) (\\d)"), "f -$1 -$2 -$3")).points.size(),
            8u);
}

template <class T>
void append(std::string& to, T value, bool swapped = false) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  to.append(bytes.data(), bytes.size());
}

TEST_F(ASurfaceFile, InBinaryIsRead) {
  const TriangleMesh mesh = cube();
  std::string stl = "solid, though binary";
  stl.resize(80, ' ');
  append(stl, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(stl, 0.0f);
    for (const std::int32_t v : t)
      for (const double c : mesh.points[v]) append(stl, static_cast<float>(c));
    append(stl, std::uint16_t{0});
  }
  EXPECT_NEAR(enclosed_volume(read("cube.stl", stl)), 1e-3, 1e-9);
  for (const bool big : {false, true}) {
    std::string ply = fmt::format(
        "ply\nformat binary_{}_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\n"
        "element face 12\nproperty list uchar uint vertex_index\nproperty float quality\nend_header\n",
        big ? "big" : "little");
    for (const Point& x : mesh.points) {
      append(ply, static_cast<float>(x[0]), big), append(ply, static_cast<float>(x[1]), big), append(ply, x[2], big);
      append(ply, std::uint8_t{7});
    }
    for (const Triangle& t : mesh.triangles) {
      append(ply, std::uint8_t{3});
      for (const std::int32_t v : t) append(ply, static_cast<std::uint32_t>(v), big);
      append(ply, 1.5f, big);
    }
    EXPECT_NEAR(enclosed_volume(read("cube.ply", ply)), 1e-3, 1e-9);
  }
}

TEST_F(ASurfaceFile, InBinaryMayHaveNumbersOfEveryType) {
  const auto expect_read = [&]<class T>(std::initializer_list<const char*> types, T value) {
    for (const char* type : types) {
      std::string ply = fmt::format(
          "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty {0} x\nproperty {0} y\nproperty {0} z\nend_header\n", type);
      for (int i = 0; i < 3; ++i) append(ply, value);
      std::ofstream(folder_ / "a.ply", std::ios::binary) << ply;
      const auto is = static_cast<double>(value);
      EXPECT_EQ(read_polygon_soup(folder_ / "a.ply").points, (std::vector<Point>{{is, is, is}})) << type;
    }
  };
  expect_read({"char", "int8"}, std::int8_t{-100});
  expect_read({"uchar", "uint8"}, std::uint8_t{200});
  expect_read({"short", "int16"}, std::int16_t{-30000});
  expect_read({"ushort", "uint16"}, std::uint16_t{60000});
  expect_read({"int", "int32"}, std::int32_t{-2'000'000'000});
  expect_read({"uint", "uint32"}, std::uint32_t{4'000'000'000});
  expect_read({"float", "float32"}, -1.5e-30f);
  expect_read({"double", "float64"}, -1.5e-300);
}

TEST_F(ASurfaceFile, LargerThanWhatIsBakedIsDoubted) {
  for (int axis = 0; axis < 3; ++axis) {
    TriangleMesh mesh = cube();
    for (Point& x : mesh.points) x[axis] *= 200;
    read("a.off", as_off(mesh));
    EXPECT_EQ(said_, "");
    for (Point& x : mesh.points) x[axis] *= 1.05;
    read("a.off", as_off(mesh));
    EXPECT_NE(said_.find("is 21 m across"), std::string::npos) << said_;
  }
}

TEST_F(ASurfaceFile, InMillimetresWithYUpIsTurnedAndScaled) {
  TriangleMesh tall = cube();
  for (Point& x : tall.points) x = {1000 * x[0], 3000 * x[1], 1000 * x[2]};
  std::ofstream(folder_ / "tall.obj") << as_obj(tall);
  SurfaceReading reading;
  reading.say = [&](const std::string& line) { said_ = line; };
  read_triangle_mesh(folder_ / "tall.obj", reading);
  EXPECT_EQ(said_,
            (folder_ / "tall.obj").string() + ": is 300 m across, if its numbers are metres; if they are millimetres, add --unit mm");
  said_.clear();
  reading.unit_m = 1e-3, reading.unit_is_given = true, reading.y_is_up = true;
  const TriangleMesh mesh = read_triangle_mesh(folder_ / "tall.obj", reading);
  EXPECT_EQ(said_, "");
  EXPECT_NEAR(enclosed_volume(mesh), 3e-3, 1e-12);
  const Box3 box = make_triangle_solid(mesh)->bounds();
  EXPECT_NEAR(box.high[2], 0.3, 1e-12);
  EXPECT_NEAR(box.low[1], -0.1, 1e-12);
}

TEST(Cleaning, RefusesWhatNoLibraryShouldSee) {
  const auto error = [](const std::function<void(PolygonSoup&)>& spoil) {
    PolygonSoup soup;
    for (const Point& x : cube().points) soup.points.push_back(x);
    for (const Triangle& t : cube().triangles) soup.faces.push_back({t.begin(), t.end()});
    spoil(soup);
    Mended mended;
    return message_of<InputError>([&] { clean_surface(soup, mended); });
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error([](PolygonSoup& soup) { soup.points[3][1] = nan; }), "vertex 3 has a coordinate that is no finite number");
  EXPECT_EQ(error([](PolygonSoup& soup) { soup.points[7][2] = -infinite; }), "vertex 7 has a coordinate that is no finite number");
  EXPECT_EQ(error([](PolygonSoup& soup) { soup.points[0][0] = 1e200; }), "reaches to 1e+200 m from the origin, allowed: 1e+09");
  EXPECT_EQ(error([](PolygonSoup& soup) {
              for (Point& x : soup.points) x[0] += 1e8;
            }),
            "is 0.173 m across at 1e+08 m from the origin, allowed: 1e-07 of that");
  EXPECT_EQ(error([](PolygonSoup& soup) { soup.faces.clear(); }), "is empty: it has no triangles");
  EXPECT_EQ(error([](PolygonSoup& soup) {
              for (auto& face : soup.faces) face = {face[0], face[0], face[1]};
            }),
            "is empty: none of its faces has an area");
  // the strip of Moebius, whose triangles cannot be turned one way
  EXPECT_EQ(error([](PolygonSoup& soup) {
              soup.faces.clear();
              for (std::int64_t k = 0; k < 5; ++k) soup.faces.push_back({k, (k + 1) % 5, (k + 2) % 5});
            }),
            "has but one side, as a Moebius strip: its triangles cannot be turned one way");
}

TEST_F(ASurfaceFile, WithAHollowIsAllowed) {
  TriangleMesh hollow = cube();
  for (Point& x : hollow.points) x = 0.5 * x + Point{0.02, 0.02, 0.02};
  for (Triangle& t : hollow.triangles) std::swap(t[0], t[1]);
  TriangleMesh both = together(cube(), hollow);
  EXPECT_NEAR(enclosed_volume(read("a.off", as_off(both))), 1e-3 * (1 - 0.125), 1e-9);
  std::swap(both.triangles[0][0], both.triangles[0][1]);
  EXPECT_NEAR(enclosed_volume(read("a.off", as_off(both))), 1e-3 * (1 - 0.125), 1e-9) << "a triangle of the outer shell is turned";
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
  EXPECT_FALSE(has_sharp_edges(round));
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

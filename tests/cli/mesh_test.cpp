// SPDX-License-Identifier: MIT
// bake-mesh as a user calls it, where it is built.
#ifdef BAKE_MESH_PROGRAM
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

class AMesh : public testing::Test {
 protected:
  AMesh() { place.use_program(BAKE_MESH_PROGRAM); }
  Workplace place;
};

TEST_F(AMesh, OfASceneBecomesItsParticles) {
  const Outcome made = place.bake("tets dough --set grid.dx_m=0.002 --out x.hdf");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("vertices"), std::string::npos) << made.out;
  std::string scene = contents(place.folder() / "experiments/fig01_dough/dough.toml");
  scene.replace(scene.find("shape = "), std::string::npos, "particles_file = \"x.hdf\"\n");
  place.write("meshed.toml", scene);
  place.use_program(BAKE_PROGRAM);
  ASSERT_EQ(place.bake("run meshed.toml --quiet --out run").exit_code, 0);
  place.use_program(BAKE_MESH_PROGRAM);
  const Outcome whole = place.bake("fracture x.hdf run --every 1 --out surfaces");
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_NE(whole.out.find("frame 2 (0.01 s): 0 broken edges, 0 cracks of 0 m^2, 1 pieces"), std::string::npos) << whole.out;
  EXPECT_TRUE(std::filesystem::exists(place.folder() / "surfaces/fracture.json"));
}

/// The user has done nothing wrong, and the same command may succeed later.
TEST_F(AMesh, ThatFindsNoRoomOnTheDiskFailsWithExitThree) {
  expect_refused(place, "tets dough --set grid.dx_m=0.002 --out x.hdf", "x.hdf: cannot write: ", "trap '' XFSZ; ulimit -f 4;", 3);
  for (const char* file : {"x.hdf", "x.hdf.part"}) EXPECT_FALSE(std::filesystem::exists(place.folder() / file));
}

TEST_F(AMesh, WithAMistakeIsOneLineAndExitTwo) {
  place.write("hello.stl", "hello");
  expect_refused(place, "", "no command given; commands: tets, skin, fracture");
  expect_refused(place, "tetts dough", "unknown command 'tetts'; did you mean 'tets'?");
  expect_refused(place, "tets dough", "--out is required");
  expect_refused(place, "tets duogh --out x.hdf", "unknown scene 'duogh'; did you mean 'dough'?");
  expect_refused(place, "tets dough --body 1 --out x.hdf", "--body: found 1, the scene has 1");
  expect_refused(place, "tets dough --method mesh3 --out x.hdf", "--method: found mesh3 with a scene");
  expect_refused(place, "tets dough --vertices 5 --out x.hdf", "5 vertices are too few");
  expect_refused(place, "tets hello.stl --vertices 100 --out x.hdf", "hello.stl: is no STL file");
  expect_refused(place, "tets body.vtk --out x.hdf", "body.vtk: found .vtk, allowed: a scene (.toml), or .stl, .obj, .ply, .off");
  expect_refused(place, "skin dough --edge-length 1 --out x.hdf", "are too long for this body");
  for (const char* length : {"0", "nan", "-1", "1e7", "1x"})
    expect_refused(place, fmt::format("skin dough --edge-length {} --out x.hdf", length),
                   fmt::format("found {}, allowed: a number from 1e-09 to 1000000 m", length));
  for (const char* option : {"--stretch", "--smallest-gap", "--void-ratio", "--reference-time"})
    expect_refused(place, fmt::format("fracture x.hdf run --out y {} nan", option), "found nan, allowed: a number from ");
  expect_refused(place, "fracture x.hdf run --out y", "x.hdf: cannot open");
  EXPECT_FALSE(std::filesystem::exists(place.folder() / "x.hdf"));
}

/// A biscuit of 1 x 1 x 0.2, whose sides are faces of four corners.
constexpr const char* k_biscuit =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0.2\nv 1 0 0.2\nv 1 1 0.2\nv 0 1 0.2\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST_F(AMesh, FallsBackToTheLatticeWhereTheEdgesCannotBeKept) {
  place.write("biscuit.obj", k_biscuit);
  const Outcome made = place.bake("tets biscuit.obj --vertices 200 --out x.hdf");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find("bake-mesh: mesh3 gives up (its mesh is empty), so the lattice is used"), std::string::npos) << made.err;
  EXPECT_EQ(made.out.find(" 0 tetrahedra"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("0.2 m^3"), std::string::npos) << made.out;
  EXPECT_NE(place.bake("tets biscuit.obj --vertices 200 --method mesh3 --out y.hdf").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(place.folder() / "y.hdf"));
}

TEST_F(AMesh, TellsWhatItMendedAndWhatItDoubts) {
  std::string turned = k_biscuit;
  turned.replace(turned.find("f 1 4 3 2"), 9, "f 1 2 3 4");
  for (std::size_t at = turned.find("0.2"); at != turned.npos; at = turned.find("0.2")) turned.replace(at, 3, "200");
  place.write("biscuit.obj", turned);
  const Outcome made = place.bake("skin biscuit.obj --edge-length 100 --out x.hdf");
  EXPECT_NE(made.err.find("bake-mesh: biscuit.obj: mended: triangles turned so that all look outwards"), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("is 200 m across, if its numbers are metres; if they are millimetres, add --unit mm"), std::string::npos)
      << made.err;
  const Outcome small = place.bake("skin biscuit.obj --unit mm --edge-length 0.1 --out x.hdf");
  EXPECT_EQ(small.err.find("across"), std::string::npos) << small.err;
}

TEST_F(AMesh, TooLargeForTheMachineIsRefusedWithTheEstimate) {
  place.write("biscuit.obj", k_biscuit);
  expect_refused(place, "tets biscuit.obj --vertices 100000000 --out x.hdf", "100000000 vertices would take about ");
  expect_refused(place, "skin biscuit.obj --edge-length 1e-9 --out x.hdf", "edges of 1e-09 m would take about ");
  expect_refused(place, "tets dough --vertices 100000000 --out x.hdf", "100000000 vertices would take about ");
}

TEST_F(AMesh, HelpsWithItsCommands) {
  for (const char* command : {"", "tets ", "skin ", "fracture "}) expect_success(place, std::string(command) + "--help", "Usage");
}

}  // namespace
}  // namespace bake::test
#endif

// SPDX-License-Identifier: MIT
// bake-mesh as a user calls it, where it is built.
#ifdef BAKE_MESH_PROGRAM
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

TEST_F(AMesh, WithAMistakeIsOneLineAndExitTwo) {
  place.write("hello.stl", "hello");
  expect_refused(place, "", "no command given; commands: tets, skin, fracture");
  expect_refused(place, "tetts dough", "unknown command 'tetts'; did you mean 'tets'?");
  expect_refused(place, "tets dough", "--out is required");
  expect_refused(place, "tets duogh --out x.hdf", "unknown scene 'duogh'; did you mean 'dough'?");
  expect_refused(place, "tets dough --body 1 --out x.hdf", "--body: found 1, the scene has 1");
  expect_refused(place, "tets dough --method mesh3 --out x.hdf", "--method: found mesh3 with a scene");
  expect_refused(place, "tets dough --vertices 5 --out x.hdf", "5 vertices are too few");
  expect_refused(place, "tets hello.stl --vertices 100 --out x.hdf", "hello.stl: is empty: it has no triangles");
  expect_refused(place, "tets body.vtk --out x.hdf", "body.vtk: found .vtk, allowed: a scene (.toml), or .stl, .obj, .ply, .off");
  expect_refused(place, "skin dough --edge-length 1 --out x.hdf", "are too long for this body");
  expect_refused(place, "fracture x.hdf run --out y", "x.hdf: cannot open");
  EXPECT_FALSE(std::filesystem::exists(place.folder() / "x.hdf"));
}

TEST_F(AMesh, HelpsWithItsCommands) {
  for (const char* command : {"", "tets ", "skin ", "fracture "}) {
    const Outcome help = place.bake(std::string(command) + "--help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("Usage"), std::string::npos);
    EXPECT_EQ(help.err, "");
  }
}

}  // namespace
}  // namespace bake::test
#endif

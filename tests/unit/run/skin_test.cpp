// SPDX-License-Identifier: MIT
// Skins of scenes: their meshes, their files, their doubts.
#include <gtest/gtest.h>

#include <filesystem>

#include "solver/core/vector3.h"
#include "solver/engine/sheets.h"
#include "solver/run/run.h"
#include "solver/run/simulation.h"
#include "solver/run/skins.h"
#include "solver/scene/scene_builder.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

SceneBuilder fruit(const std::string& skin = "") {
  SceneBuilder builder;
  builder.effects = "motion, water, elasticity";
  builder.precision = "single";
  builder.dx = 0.0625;
  builder.frame_s = 0.01;
  builder.material =
      "density_kg_per_m3 = 1000\nyoung_modulus_Pa = 2e4\ninitial_saturation = 0.8\npressure_Pa = 8e4\ndiffusivity_m2_per_sK = 1e-3\n"
      "evaporation_kg_per_m2sK = 5\n";
  builder.shape = "sphere = { radius_m = 0.3 }";
  builder.tables = "[[skin]]\nyoung_modulus_Pa = 1e6\nthickness_m = 0.025\n" + skin;
  return builder;
}

std::string refusal(const SceneBuilder& builder) {
  return message_of<InputError>([&] { make_skins(builder.scene()); });
}

TEST(ASkin, CoversABodyBelowItsSurface) {
  const std::vector<MadeSkin> skins = make_skins(fruit().scene());
  ASSERT_EQ(skins.size(), 1U);
  double area = 0;
  for (const double a : vertex_areas(skins[0].mesh)) area += a;
  const double r = 0.3 - 0.4 * 0.0625;
  EXPECT_NEAR(area / (4 * M_PI * r * r), 1, 0.02);
  EXPECT_TRUE(doubts_about_skins(fruit().scene()).empty());
}

TEST(ASkin, CanCoverAPartAndSeveralBodies) {
  SceneBuilder builder = fruit("only = { half_space = { } }\nbody = [1, 0]");
  builder.tables += "\n[[body]]\nmaterial = \"dough\"\nshape = { sphere = { centre_m = [0.6, 0, 0], radius_m = 0.2 } }";
  const MadeSkin skin = make_skins(builder.scene()).at(0);
  EXPECT_EQ(skin.body.front(), 1);
  EXPECT_EQ(skin.body.back(), 0);
  for (const Point& x : skin.mesh.points) EXPECT_LT(x[2], 0.0625);
}

TEST(ASkin, ComesFromAFile) {
  const TemporaryFolder folder;
  Mesh mesh;
  mesh.points = {0, 0, 0.1, 0.1, 0, 0.1, 0, 0.1, 0.1, 0.1, 0.1, 0.1};
  mesh.cells = {0, 1, 2, 1, 3, 2};
  write_mesh(folder / "sheet.hdf", mesh);
  SceneBuilder builder = fruit("depth_dx = 0.5\nmesh_file = \"" + (folder / "sheet.hdf").string() + "\"");
  const MadeSkin skin = make_skins(builder.scene()).at(0);
  EXPECT_EQ(skin.mesh.triangles.size(), 2U);
  for (const Point& x : skin.mesh.points) EXPECT_NEAR(x[2], 0.1 - 0.5 * 0.0625, 1e-12);
  EXPECT_EQ(doubts_about_skins(builder.scene()).size(), 1U) << "edges are longer than dx";

  mesh.points[7] = 0;  // two corners in one place
  mesh.points[6] = 0;
  write_mesh(folder / "sheet.hdf", mesh);
  EXPECT_NE(refusal(builder).find("skin.0: found a triangle of the vertices 0, 1, 2 that has no area"), std::string::npos)
      << refusal(builder);
  mesh.points = {0, 0, 0.1, 0.1, 0, 0.1, 0, 0.1, 0.1, 0.1, 0.1, 0.1};
  mesh.cells = {0, 1, 2, 1, 2, 3};
  write_mesh(folder / "sheet.hdf", mesh);
  EXPECT_NE(refusal(builder).find("not one of two triangles turned the same way"), std::string::npos) << refusal(builder);
}

TEST(ASkin, IsRefusedWhereItCannotBe) {
  SceneBuilder thin = fruit();
  thin.shape = "box = { half_extents_m = [0.3, 0.3, 0.02] }";
  EXPECT_NE(refusal(thin).find("skin.0: found a shape too thin"), std::string::npos) << refusal(thin);
  EXPECT_NE(refusal(fruit("only = { sphere = { centre_m = [0.9, 0, 0], radius_m = 0.1 } }")).find("found no triangle"), std::string::npos);
}

TEST(DoubtsAboutSkins, TellWhatTheGridCannotShow) {
  SceneBuilder soft = fruit();
  soft.tables = "[[skin]]\nyoung_modulus_Pa = 1e5\nthickness_m = 0.005\ndepth_dx = 0\n";
  soft.shape = "box = { half_extents_m = [0.3, 0.3, 0.1] }";
  std::string all;
  for (const std::string& doubt : doubts_about_skins(soft.scene())) all += doubt + "\n";
  for (const char* part : {"skin.0: it would fold at", "below 5 dx", "is 3.2 dx thick", "below 4 dx"})
    EXPECT_NE(all.find(part), std::string::npos) << all;
}

TEST(ARunWithASkin, WritesMeshesAndItsLedgerAndLeavesVerticesOutOfFrames) {
  const TemporaryFolder folder;
  SceneBuilder builder = fruit();
  builder.overrides = {"run.end_s=0.03"};
  const Scene scene = builder.scene();
  RunOptions options;
  options.out = folder / "out";
  options.quiet = true;
  run_scene(scene, options);
  const Mesh first = read_mesh(folder / "out" / "skins" / "0000.hdf"), last = read_mesh(folder / "out" / "skins" / "0003.hdf");
  EXPECT_EQ(first.cells, last.cells);
  EXPECT_NEAR(last.time_s, 0.03, 1e-9);
  for (const char* name : {"velocity", "area_ratio", "curvature", "skin", "saturation"}) {
    ASSERT_NE(last.find(name), nullptr) << name;
    for (const double value : last.find(name)->values) ASSERT_TRUE(std::isfinite(value)) << name;
  }
  for (const double a : first.find("area_ratio")->values) EXPECT_NEAR(a, 1, 1e-5);
  double mean = 0;
  for (const double s : last.find("saturation")->values) mean += s / static_cast<double>(last.vertex_count());
  EXPECT_LT(mean, 0.79) << "it dries at the skin";
  EXPECT_GT(mean, 0.3);
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "skins.hdf.series"));
  const auto s = Simulation::begin(scene);
  EXPECT_EQ(FrameReader(folder / "out" / "frames" / "0003.hdf").particles(), s->particles());
  s->advance(0.03, 0.04);
  EXPECT_GT(s->skin_sums().membrane, 0);
  EXPECT_LT(s->skin_sums().area, 4 * M_PI * 0.09);

  SceneBuilder bare = fruit();
  bare.tables = "";
  bare.overrides = {"run.end_s=0.01"};
  options.replace = Replace::any_run;
  run_scene(bare.scene(), options);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "skins")) << "the other run's";
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "skins.hdf.series"));
}

}  // namespace
}  // namespace bake

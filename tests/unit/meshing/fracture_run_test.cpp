// SPDX-License-Identifier: MIT
// Surfaces of a run whose frames are made up here: a brick that is stretched evenly, then torn in two.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "meshing/fracture/fracture.h"
#include "meshing/tets/lattice_mesher.h"
#include "solver/core/errors.h"
#include "solver/io/frames.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/meshing/solids.h"

namespace bake {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double k_dx = 0.02;

/// Frames 0 to 4 stretch the brick to 1.5 along x, 5 to 12 move the halves apart.
Point moved(const Point& x, int frame) {
  const double stretch = 1 + 0.125 * std::min(frame, 4), apart = 0.02 * std::max(0, frame - 4);
  return {stretch * x[0] + (x[0] > 0 ? apart : -apart), x[1], x[2]};
}

class ATornBrick : public testing::Test {
 protected:
  static constexpr int k_frames = 13;
  static constexpr std::int64_t k_first = 100;

  ATornBrick() : mesh_(filled(*brick(), 1200)) {
    write_mesh(folder_ / "mesh.hdf", to_particles_mesh(mesh_));
    write_run("done", 0);
  }

  /// `growth`: by how much of their first volume particles grow in each frame; without it they have no volumes.
  void write_run(const char* state, double shift, std::optional<double> growth = {}) const {
    fs::create_directories(folder_ / "run/frames");
    for (int frame = 0; frame < k_frames; ++frame) write_frame_of(frame, shift, growth);
    const json description{{"scene", {{"quality", "standard"}, {"grid", {{"dx_m", k_dx / 2}}}}}, {"summary", {{"state", state}}}};
    std::ofstream(folder_ / "run/run.json") << description;
    std::ofstream(folder_ / "run/ledger.csv") << "frame\n0\n";
  }

  /// Particles in reverse order: rows are found by identity.
  void write_frame_of(int frame, double shift, std::optional<double> growth) const {
    std::vector<float> positions, temperature;
    const std::vector<float> volumes(mesh_.points.size(), static_cast<float>(1e-6 * (1 + frame * growth.value_or(0))));
    std::vector<std::int64_t> ids;
    for (std::size_t v = mesh_.points.size(); v-- > 0;) {
      const Point x = moved(mesh_.points[v], frame);
      for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(x[k] + shift));
      temperature.push_back(static_cast<float>(1000 * mesh_.points[v][1]));
      ids.push_back(k_first + static_cast<std::int64_t>(v));
    }
    FrameData written{positions, {{"id", "1", ids}, {"temperature", "C", temperature}}};
    if (growth) written.columns.push_back({"volume", "m^3", volumes});
    write_frame(folder_ / "run/frames" / frame_name(frame), 0.5 * frame, written);
  }

  FractureOptions options() const {
    FractureOptions result;
    result.mesh = folder_ / "mesh.hdf";
    result.results = folder_ / "run";
    result.out = folder_ / "out";
    result.first_particle = k_first;
    return result;
  }

  json report_of(const FractureOptions& options) const {
    write_fracture(options, [](const std::string&) {});
    return json::parse(contents(options.out / "fracture.json"));
  }

  std::string error_of(const FractureOptions& options) const {
    return message_of<InputError>([&] { write_fracture(options, [](const std::string&) {}); });
  }

  const TemporaryFolder folder_;
  const TetMesh mesh_;
};

TEST_F(ATornBrick, IsWholeFirstAndTwoClosedPiecesInTheEnd) {
  FractureOptions wanted = options();
  wanted.frames = {0, 4, 12};
  const json report = report_of(wanted);
  ASSERT_EQ(report["frames"].size(), 3u);
  for (const int i : {0, 1}) {
    EXPECT_EQ(report["frames"][i]["broken_edges"], 0) << "stretched evenly by half is not broken";
    EXPECT_TRUE(report["frames"][i]["cracks"].empty());
    EXPECT_EQ(report["frames"][i]["pieces"].size(), 1u);
  }
  const json& torn = report["frames"][2];
  ASSERT_EQ(torn["pieces"].size(), 2u);
  for (const json& piece : torn["pieces"]) EXPECT_TRUE(piece["closed"].get<bool>());
  EXPECT_NEAR(torn["volume_m3"].get<double>(), 1.5 * volume(mesh_), 1e-3 * 1.5 * volume(mesh_));
  EXPECT_NEAR(torn["cut_volume_m3"].get<double>(), volume(mesh_), 1e-9 * volume(mesh_)) << "the mesh has not been stretched";
  EXPECT_NEAR(report["mesh_volume_m3"].get<double>(), volume(mesh_), 1e-9 * volume(mesh_));
  ASSERT_EQ(torn["cracks"].size(), 1u);
  EXPECT_NEAR(torn["crack_area_m2"].get<double>(), 0.16 * 0.12, 0.2 * 0.16 * 0.12);
  EXPECT_NEAR(torn["cracks"][0]["length_m"].get<double>(), 0.18, 0.03);
  EXPECT_NEAR(torn["cracks"][0]["centre_m"][0].get<double>(), 0, 0.01);
  EXPECT_EQ(torn["time_s"], 6);
}

TEST_F(ATornBrick, CarriesItsFieldsOntoTheSurface) {
  report_of(options());
  const Mesh surface = read_mesh(folder_ / "out/0012.hdf");
  EXPECT_EQ(surface.corners, 3u);
  EXPECT_EQ(surface.time_s, 6);
  for (const char* name : {"temperature", "piece", "crack", "depth"}) ASSERT_NE(surface.find(name), nullptr) << name;
  std::size_t on_crack = 0;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) {
    const double x = surface.points[3 * v], y = surface.points[3 * v + 1];
    EXPECT_NEAR(surface.find("temperature")->values[v], 1000 * y, 15);
    const double piece = surface.find("piece")->values[v];
    EXPECT_EQ(piece, std::round(piece));
    if (surface.find("crack")->values[v] == 0) continue;
    ++on_crack;
    EXPECT_NEAR(std::abs(x), 0.16, 0.03) << "faces of the tear are moved by their own side";
    EXPECT_GT(surface.find("depth")->values[v], 0);
    EXPECT_LT(surface.find("depth")->values[v], 0.061);
  }
  EXPECT_GT(on_crack, 50u);
}

TEST_F(ATornBrick, IsJudgedByTheReferenceTimeAndTheBounds) {
  FractureOptions early = options();
  early.stretch = 1.3;
  early.smallest_gap_m = 0;
  early.frames = {4};
  EXPECT_GT(report_of(early)["frames"][0]["broken_edges"], 0) << "stretched by half since the start";
  early.reference_time_s = 2.1;  // frame 4
  EXPECT_EQ(report_of(early)["frames"][0]["broken_edges"], 0) << "not stretched since then";
  FractureOptions wide = options();
  wide.smallest_gap_m = 0.5;
  EXPECT_EQ(report_of(wide)["frames"][0]["broken_edges"], 0) << "the gap never gets that wide";
  EXPECT_NEAR(report_of(options())["smallest_gap_m"].get<double>(), k_smallest_gap * k_dx, 1e-12);
}

TEST_F(ATornBrick, IsBrokenWhereThereIsAVoidIfAskedTo) {
  FractureOptions wanted = options();
  wanted.void_ratio = 1.6;
  EXPECT_EQ(error_of(wanted), wanted.results.string() + ": found no column 'volume' in its frames, needed for --void-ratio");
  write_run("done", 0, 0.5 / 4);  // the dough itself grows by half over frames 0 to 4
  EXPECT_EQ(report_of(wanted)["frames"][0]["pieces"].size(), 2u) << "dough has not grown into the tear";
  write_run("done", 0, 2);
  EXPECT_EQ(report_of(wanted)["frames"][0]["broken_edges"], 0) << "dough fills all of it";
}

TEST_F(ATornBrick, IsWholeIfTheTearIsSmallerThanAskedFor) {
  const double faces = report_of(options())["frames"][0]["crack_area_m2"].get<double>() / (k_dx * k_dx);
  FractureOptions wanted = options();
  wanted.smallest_crack = 0.99 * faces;
  EXPECT_EQ(report_of(wanted)["frames"][0]["pieces"].size(), 2u);
  wanted.smallest_crack = 1.01 * faces;
  const json closed = report_of(wanted);
  EXPECT_NEAR(closed["smallest_crack_m2"].get<double>(), 1.01 * faces * k_dx * k_dx, 1e-9);
  EXPECT_TRUE(closed["frames"][0]["cracks"].empty());
  EXPECT_EQ(closed["frames"][0]["pieces"].size(), 1u);
}

TEST_F(ATornBrick, HasWantedFramesOnly) {
  FractureOptions every = options();
  every.every = 5;
  EXPECT_EQ(report_of(every)["frames"].size(), 3u);  // 0, 5, 10
  EXPECT_TRUE(fs::exists(folder_ / "out/0010.hdf"));
  EXPECT_FALSE(fs::exists(folder_ / "out/0012.hdf"));
  for (const int frame : {13, -1}) {
    every.frames = {0, frame};
    EXPECT_EQ(error_of(every), "--frames: found " + std::to_string(frame) + ", allowed: 0 to 12");
  }
}

TEST_F(ATornBrick, OfAnotherMeshOrAnUnfinishedRunIsRefused) {
  FractureOptions other = options();
  other.first_particle = 101;
  EXPECT_NE(error_of(other).find("is not there, allowed: a run whose particles 101 to "), std::string::npos) << error_of(other);
  write_run("done", 0.0003);  // in each direction; a hundredth of the node distance is allowed
  EXPECT_NE(error_of(options()).find("allowed: a run that started from this mesh"), std::string::npos) << error_of(options());
  write_run("done", 0.0001);
  EXPECT_EQ(error_of(options()), "nothing was thrown");
  fs::remove(folder_ / "out/fracture.json");
  write_run("interrupted", 0);
  EXPECT_NE(error_of(options()).find("found a run that is interrupted"), std::string::npos) << error_of(options());
  other = options();
  other.results = folder_ / "nowhere";
  EXPECT_NE(error_of(other).find("there is no run here"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out/fracture.json"));
}

TEST_F(ATornBrick, NeedsTetrahedra) {
  Mesh triangles;
  triangles.points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  triangles.cells = {0, 1, 2};
  write_mesh(folder_ / "mesh.hdf", triangles);
  EXPECT_NE(error_of(options()).find("mesh.hdf: found triangles, allowed: tetrahedra"), std::string::npos);
  TetMesh inverted{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1, 3}}};
  write_mesh(folder_ / "mesh.hdf", to_particles_mesh(inverted));
  EXPECT_NE(error_of(options()).find("mesh.hdf: tetrahedron 0 has no positive volume"), std::string::npos);
}

}  // namespace
}  // namespace bake

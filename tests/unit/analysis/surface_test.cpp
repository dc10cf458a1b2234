// SPDX-License-Identifier: MIT
// Surfaces around particles, and what is done to meshes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "analysis/surface/mesh_tools.h"
#include "analysis/surface/splat.h"
#include "solver/core/errors.h"
#include "tests/unit/analysis/runs.h"

namespace bake {
namespace {

Particles particles_of(const Ball& ball) {
  Particles particles;
  particles.positions = ball.positions;
  particles.volumes = ball.volumes;
  particles.ids = ball.ids;
  MeshField height{"height", "m", 1, {}};
  for (std::size_t i = 0; i < ball.ids.size(); ++i) height.values.push_back(ball.positions[3 * i + 2]);
  particles.fields.push_back(height);
  return particles;
}

Eigen::Vector3d point(const Mesh& mesh, std::int64_t v) {
  return Eigen::Map<const Eigen::Vector3d>(&mesh.points[3 * static_cast<std::size_t>(v)]);
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); c += 3)
    sum += point(mesh, mesh.cells[c]).dot(point(mesh, mesh.cells[c + 1]).cross(point(mesh, mesh.cells[c + 2]))) / 6;
  return sum;
}

/// Every edge is used once in each direction.
void expect_closed_and_oriented(const Mesh& mesh) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> uses;
  for (std::size_t c = 0; c < mesh.cells.size(); c += 3)
    for (std::size_t k = 0; k < 3; ++k) ++uses[{mesh.cells[c + k], mesh.cells[c + (k + 1) % 3]}];
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    ASSERT_EQ(count, back == uses.end() ? 0 : back->second) << edge.first << " to " << edge.second;
  }
}

/// The ball of the surface is half a spacing larger than that of the outermost particles; 5 % of volume are 1.7 % of radius.
TEST(SplatSurface, OfAFilledBallIsClosedWithItsVolume) {
  const Ball ball(0.1f, 0.01f);
  const Mesh mesh = splat_surface(particles_of(ball));
  expect_closed_and_oriented(mesh);
  const double held = static_cast<double>(ball.ids.size()) * 1e-6;
  EXPECT_NEAR(volume(mesh), held, 0.05 * held);
}

TEST(SplatSurface, CarriesFields) {
  const Mesh mesh = splat_surface(particles_of(Ball(0.1f, 0.01f)));
  const MeshField* height = mesh.find("height");
  ASSERT_TRUE(height);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) EXPECT_NEAR(height->values[i], mesh.points[3 * i + 2], 0.01);  // a spacing
}

TEST(SplatSurface, IsTheSameForAnyNumberOfThreads) {
  const Particles particles = particles_of(Ball(0.1f, 0.02f));
  const Mesh one = splat_surface(particles, {0, 1}), three = splat_surface(particles, {0, 3});
  EXPECT_TRUE(same_bits(one.points, three.points));
  EXPECT_EQ(one.cells, three.cells);
  EXPECT_TRUE(same_bits(one.fields[0].values, three.fields[0].values));
}

TEST(SplatSurface, OfRagsMayBeCoarserThanTheirParticles) {
  Particles rags = particles_of(Ball(0.1f, 0.02f));
  for (float& volume : rags.volumes) volume = 1e-9f;  // of 1 mm
  const Mesh mesh = splat_surface(rags, {0.04, 1});
  const MeshField* height = mesh.find("height");
  ASSERT_TRUE(height);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) EXPECT_NEAR(height->values[i], mesh.points[3 * i + 2], 0.04);
}

TEST(SplatSurface, OfStrewnParticlesIsRefused) {
  Particles particles = particles_of(Ball(0.1f, 0.05f));
  particles.positions[0] = 1e6f;
  EXPECT_TRUE(has(message_of<InputError>([&] { splat_surface(particles); }), "the particles are strewn"));
}

TEST(FieldsAt, PlacesFarFromAllParticlesIsRefused) {
  const Particles particles = particles_of(Ball(0.1f, 0.02f));
  const std::string message = message_of<InputError>([&] { fields_at({1, 0, 0}, particles, particles.fields, 1, "loaf.hdf"); });
  EXPECT_TRUE(has(message, "loaf.hdf: found 1 of 1 vertices with no particle within")) << message;
}

TEST(FieldsAt, AStrayPlaceAreThoseOfTheNearestParticle) {
  const Particles particles = particles_of(Ball(0.1f, 0.02f));
  std::vector<double> places(3 * 100, 0.0);
  places[2] = 3;  // far above
  const auto fields = fields_at(places, particles, particles.fields, 1, "loaf.hdf");
  EXPECT_NEAR(fields[0].values[0], 0.1, 0.02) << "the height of the topmost particle";
  EXPECT_NEAR(fields[0].values[1], 0, 0.02);
}

/// A cube of 2 m of 5 tetrahedra.
Mesh cube() {
  Mesh mesh;
  mesh.corners = 4;
  for (int i = 0; i < 8; ++i) mesh.points.insert(mesh.points.end(), {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  mesh.cells = {0, 1, 2, 4, 3, 2, 1, 7, 5, 1, 4, 7, 6, 4, 2, 7, 1, 2, 4, 7};
  MeshField x{"x", "m", 1, {}};
  for (std::size_t i = 0; i < 8; ++i) x.values.push_back(mesh.points[3 * i]);
  mesh.fields.push_back(x);
  return mesh;
}

TEST(Meshes, BoundaryOfTetrahedraIsClosedAndOutwards) {
  const Mesh skin = boundary_of_tetrahedra(cube());
  EXPECT_EQ(skin.cell_count(), 12u);
  expect_closed_and_oriented(skin);
  EXPECT_NEAR(volume(skin), 8, 1e-12);
}

TEST(Meshes, LoseSpecksAndBubblesAndKeepTheirFields) {
  Mesh mesh = splat_surface(particles_of(Ball(0.1f, 0.01f)));
  const std::size_t vertices = mesh.vertex_count();
  const std::vector<std::int64_t> cells = mesh.cells;
  const auto add = [&](double scale, double shift, bool inside_out) {  // the same ball once more
    const auto first = static_cast<std::int64_t>(mesh.vertex_count());
    for (std::size_t i = 0; i < 3 * vertices; ++i) mesh.points.push_back(scale * mesh.points[i] + (i % 3 == 0 ? shift : 0));
    for (MeshField& field : mesh.fields)
      for (std::size_t i = 0; i < vertices * field.components; ++i) field.values.push_back(field.values[i]);
    for (std::size_t c = 0; c < cells.size(); c += 3) {
      mesh.cells.insert(mesh.cells.end(), {first + cells[c], first + cells[c + 1], first + cells[c + 2]});
      if (inside_out) std::swap(mesh.cells.back(), mesh.cells[mesh.cells.size() - 2]);
    }
  };
  add(0.05, 1, false);  // a speck of 1.25e-4 of the volume
  add(0.05, 0, true);   // a bubble
  add(0.5, 2, false);   // an eighth
  const Mesh kept = without_specks(mesh, 1e-3);
  EXPECT_EQ(kept.vertex_count(), 2 * vertices);
  EXPECT_EQ(kept.cells.size(), 2 * cells.size());
  EXPECT_NEAR(volume(kept), 1.125 * volume(splat_surface(particles_of(Ball(0.1f, 0.01f)))), 1e-9);
  EXPECT_EQ(kept.find("height")->values.size(), 2 * vertices);
  EXPECT_EQ(without_specks(mesh, 1e-5).cells.size(), mesh.cells.size());
}

TEST(Meshes, CreasesStaySharpAndSlightOnesAreSmoothed) {
  const Mesh skin = boundary_of_tetrahedra(cube());
  for (const auto& corners : corner_normals(skin, 60))
    for (const auto& n : corners) EXPECT_NEAR(n.cwiseAbs().maxCoeff(), 1, 1e-6);  // along an axis
  for (const auto& corners : corner_normals(skin, 120))
    for (const auto& n : corners) EXPECT_LT(n.cwiseAbs().maxCoeff(), 0.95);
}

TEST(Meshes, MoveOutwardsAlongTheNormals) {
  Mesh skin = boundary_of_tetrahedra(cube());
  const Mesh before = skin;
  move_outwards(skin, 0.1);
  EXPECT_GT(volume(skin), 8 * 1.1);
  for (std::size_t v = 0; v < skin.vertex_count(); ++v)
    EXPECT_NEAR((point(skin, static_cast<std::int64_t>(v)) - point(before, static_cast<std::int64_t>(v))).norm(), 0.1, 1e-6);
}

TEST(Meshes, CutKeepsWhatIsBehindAndItsFaceClosesIt) {
  const Mesh skin = boundary_of_tetrahedra(cube());
  const auto [kept, face] = cut(skin, {0.25, 0, 0}, {2, 0, 0}, 0.3);
  double area = 0;
  for (std::size_t c = 0; c < face.cells.size(); c += 3) {
    const Eigen::Vector3d a = point(face, face.cells[c]), b = point(face, face.cells[c + 1]), d = point(face, face.cells[c + 2]);
    area += (b - a).cross(d - a).norm() / 2;
    EXPECT_NEAR(a.x(), 0.25, 1e-12);
    EXPECT_LE(std::max({(b - a).norm(), (d - b).norm(), (a - d).norm()}), 0.3);
  }
  EXPECT_NEAR(area, 4, 1e-9);
  EXPECT_NEAR(volume(kept) + volume(face), 1.25 * 4, 1e-9);  // closed together, whatever the place of the origin
  const MeshField* x = kept.find("x");
  ASSERT_TRUE(x);
  for (std::size_t i = 0; i < kept.vertex_count(); ++i) EXPECT_NEAR(x->values[i], kept.points[3 * i], 1e-12);
  EXPECT_TRUE(cut(skin, {-3, 0, 0}, {1, 0, 0}, 1).kept.cells.empty());
  EXPECT_TRUE(cut(skin, {3, 0, 0}, {1, 0, 0}, 1).face.cells.empty());
  EXPECT_THROW(cut(skin, {0, 0, 0}, {0, 0, 0}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace bake

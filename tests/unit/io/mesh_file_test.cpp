// SPDX-License-Identifier: MIT
#include "solver/io/mesh_file.h"

#include <gtest/gtest.h>

#include "solver/core/errors.h"
#include "solver/io/hdf5.h"
#include "solver/io/particles_file.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.corners = 4;
  mesh.points = {0, 0, 0, 1.0 / 3, 0, 0, 0, 0.1, 0, 0, 0, 2};
  mesh.cells = {0, 1, 2, 3};
  mesh.fields = {{"volume", "m^3", 1, {1.0 / 7, 0.1, 0.2, 0.3}}, {"velocity", "m/s", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}};
  mesh.time_s = 2.5;
  return mesh;
}

TEST(MeshFile, ComesBackExactly) {
  const TemporaryFolder scratch;
  const Mesh mesh = tetrahedron();
  write_mesh(scratch / "mesh.hdf", mesh);
  const Mesh back = read_mesh(scratch / "mesh.hdf");
  EXPECT_EQ(back.corners, 4u);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.cells, mesh.cells);
  EXPECT_EQ(back.time_s, 2.5);
  ASSERT_NE(back.find("volume"), nullptr);
  EXPECT_EQ(back.find("volume")->values, mesh.find("volume")->values);
  EXPECT_EQ(back.find("volume")->unit, "m^3");
  ASSERT_NE(back.find("velocity"), nullptr);
  EXPECT_EQ(back.find("velocity")->values, mesh.find("velocity")->values);
  EXPECT_EQ(back.find("pressure"), nullptr);
}

TEST(MeshFile, OfTetrahedraIsAFileOfParticles) {
  const TemporaryFolder scratch;
  write_mesh(scratch / "mesh.hdf", tetrahedron());
  const ParticlesFile particles = read_particles(scratch / "mesh.hdf");
  EXPECT_EQ(particles.positions.at(1), (Vector3{1.0 / 3, 0, 0}));
  EXPECT_EQ(particles.volumes, tetrahedron().find("volume")->values);
}

TEST(MeshFile, RefusesACornerThatIsNoVertex) {
  const TemporaryFolder scratch;
  Mesh mesh = tetrahedron();
  mesh.cells[2] = 4;
  write_mesh(scratch / "mesh.hdf", mesh);
  EXPECT_TRUE(has(message_of<InputError>([&] { read_mesh(scratch / "mesh.hdf"); }), "cell 0: found vertex 4, allowed: 0 to 3"));
}

TEST(MeshFile, RefusesOtherFiles) {
  const TemporaryFolder scratch;
  EXPECT_TRUE(has(message_of<InputError>([&] { read_mesh(scratch / "none.hdf"); }), "cannot open"));
  put(scratch / "text.hdf", "not HDF5");
  EXPECT_TRUE(has(message_of<InputError>([&] { read_mesh(scratch / "text.hdf"); }), "not an HDF5 file"));
}

}  // namespace
}  // namespace bake

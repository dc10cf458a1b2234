// SPDX-License-Identifier: MIT
#include "solver/io/particles_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/io/hdf5.h"
#include "solver/scene/scene.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

/// Two good particles; each test spoils one thing.
struct Contents {
  std::vector<double> positions{0, 0.1, 0.2, 1, 2, 3};
  std::vector<double> volumes{1e-9, 2e-9};
  std::vector<std::int64_t> material{0, 1};
  std::size_t columns = 3;
};

class ParticlesFromAFile : public testing::Test {
 protected:
  void write(const Contents& contents) {
    AtomicFile file(path_);
    Hdf5Writer out(file);
    out.table<double>("positions", contents.positions, contents.columns);
    if (!contents.volumes.empty()) out.array<double>("volumes", contents.volumes);
    if (!contents.material.empty()) out.array<std::int64_t>("material", contents.material);
    out.close();
    file.commit();
  }
  std::string refusal() {
    return message_of<InputError>([&] { read_particles(path_); });
  }
  std::string refusal(const Contents& contents) {
    write(contents);
    return refusal();
  }
  const TemporaryFolder scratch_;
  const std::filesystem::path path_ = scratch_ / "particles.h5";
};

TEST_F(ParticlesFromAFile, AreReadExactly) {
  write({});
  const auto particles = read_particles(path_);
  EXPECT_EQ(particles.positions, (std::vector<Vector3>{{0, 0.1, 0.2}, {1, 2, 3}}));
  EXPECT_EQ(particles.volumes, (std::vector<double>{1e-9, 2e-9}));
  EXPECT_EQ(particles.materials, (std::vector<std::int32_t>{0, 1}));
}

TEST_F(ParticlesFromAFile, NeedNoMaterial) {
  Contents contents;
  contents.material.clear();
  write(contents);
  EXPECT_TRUE(read_particles(path_).materials.empty());
}

TEST_F(ParticlesFromAFile, MayBeStoredInSinglePrecision) {
  AtomicFile file(path_);
  Hdf5Writer out(file);
  out.table<float>("positions", std::vector<float>{1, 2, 3}, 3, Packing::shuffle_gzip);
  out.array<float>("volumes", std::vector<float>{0.5f});
  out.array<std::int32_t>("material", std::vector<std::int32_t>{4});
  out.close();
  file.commit();
  const auto particles = read_particles(path_);
  EXPECT_EQ(particles.positions[0], (Vector3{1, 2, 3}));
  EXPECT_EQ(particles.volumes[0], 0.5);
  EXPECT_EQ(particles.materials[0], 4);
}

TEST_F(ParticlesFromAFile, MustBeThere) {
  EXPECT_TRUE(has(refusal(), "particles.h5: cannot open: No such file or directory")) << refusal();
}

TEST_F(ParticlesFromAFile, MustNotBeCutShort) {
  write({});
  const auto whole = contents(path_);
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    put(path_, whole.substr(0, length));
    EXPECT_TRUE(has(refusal(), "particles.h5: not an HDF5 file, or cut short")) << length << ": " << refusal();
  }
}

TEST_F(ParticlesFromAFile, MustHaveVolumes) {
  Contents contents;
  contents.volumes.clear();
  EXPECT_TRUE(has(refusal(contents), "particles.h5: volumes: there is no such dataset")) << refusal();
}

TEST_F(ParticlesFromAFile, MustHaveThreeCoordinates) {
  Contents contents;
  contents.columns = 2;
  EXPECT_TRUE(has(refusal(contents), "particles.h5: positions: has shape [3, 2], needs [n, 3]")) << refusal();
}

TEST_F(ParticlesFromAFile, MustHaveAVolumeEach) {
  Contents contents;
  contents.volumes.push_back(1e-9);
  EXPECT_TRUE(has(refusal(contents), "particles.h5: volumes: holds 3 values for 2 positions")) << refusal();
}

TEST_F(ParticlesFromAFile, MustHaveAMaterialEachIfAny) {
  Contents contents;
  contents.material.pop_back();
  EXPECT_TRUE(has(refusal(contents), "particles.h5: material: holds 1 values for 2 positions")) << refusal();
}

TEST_F(ParticlesFromAFile, MustBeSomewhere) {
  for (const double bad : {double{NAN}, double{INFINITY}}) {
    Contents contents;
    contents.positions[4] = bad;
    EXPECT_TRUE(has(refusal(contents), "particles.h5: positions: particle 1 has ")) << refusal();
  }
}

TEST_F(ParticlesFromAFile, MustHavePositiveVolumes) {
  for (const double bad : {0.0, -1e-9, double{NAN}, double{INFINITY}}) {
    Contents contents;
    contents.volumes[1] = bad;
    EXPECT_TRUE(has(refusal(contents), "particles.h5: volumes: particle 1 has ")) << refusal();
  }
}

TEST_F(ParticlesFromAFile, MustNameMaterialsByIndex) {
  Contents contents;
  contents.material[0] = -1;
  EXPECT_TRUE(has(refusal(contents), "particles.h5: material: particle 0 has -1, must be the index of a material, from 0")) << refusal();
  contents.material[0] = std::int64_t{1} << 32;
  EXPECT_TRUE(has(refusal(contents), "particles.h5: material: particle 0 has 4294967296")) << refusal();
}

TEST_F(ParticlesFromAFile, MustNotBeNone) {
  Contents contents{{}, {}, {}, 3};
  EXPECT_TRUE(has(refusal(contents), "particles.h5: positions: there are none")) << refusal();
}

}  // namespace
}  // namespace bake

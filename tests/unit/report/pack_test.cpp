// SPDX-License-Identifier: MIT
// What is unpacked is what was packed, within half a step. Unpacking is written here once more, from the description in pack.h.
#include "experiments/report/pack.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <cmath>
#include <random>

#include "experiments/report/body.h"
#include "solver/core/errors.h"
#include "tests/unit/report/ball.h"

namespace bake::report {
namespace {

Bytes inflated(const Bytes& bytes, std::size_t size) {
  Bytes out(size);
  libdeflate_decompressor* inflater = libdeflate_alloc_decompressor();
  std::size_t got = 0;
  EXPECT_EQ(libdeflate_deflate_decompress(inflater, bytes.data(), bytes.size(), out.data(), out.size(), &got), LIBDEFLATE_SUCCESS);
  libdeflate_free_decompressor(inflater);
  EXPECT_EQ(got, size);
  return out;
}

class Unpacking {
 public:
  explicit Unpacking(Bytes bytes) : bytes_(std::move(bytes)) {}
  std::vector<int> planes(std::size_t count) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(bytes_.at(at_ + i) | bytes_.at(at_ + count + i) << 8);
    at_ += 2 * count;
    return numbers;
  }
  std::vector<int> signed_planes(std::size_t count) {
    std::vector<int> numbers = planes(count);
    for (int& n : numbers) n = n % 2 == 0 ? n / 2 : -(n + 1) / 2;
    return numbers;
  }
  std::vector<int> codes(std::size_t count, const std::vector<int>* before) {
    std::vector<int> codes;
    for (std::size_t i = 0; i < count; ++i) codes.push_back(((before ? (*before)[i] : i > 0 ? codes[i - 1] : 0) + bytes_.at(at_++)) & 255);
    return codes;
  }
  bool is_at_end() const { return at_ == bytes_.size(); }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

std::vector<int> sums(std::vector<int> differences) {
  for (std::size_t i = 1; i < differences.size(); ++i) differences[i] += differences[i - 1];
  return differences;
}

TEST(PackedMesh, IsTheMeshAgainWithinHalfAStep) {
  const Mesh mesh = sphere(0.3, 1);
  const Cube cube{{-0.31, -0.32, -0.33}, 0.7};
  const std::vector<std::pair<std::string, FieldSteps>> steps{{"temperature", {20, 100}}, {"porosity", {0, 0.6}}};
  const std::size_t n = mesh.vertex_count();
  const Bytes bytes = packed_mesh(mesh, cube, steps, "ball");
  Unpacking piece(inflated(deflated(bytes), bytes.size()));

  std::vector<int> corners;
  int next = 0;
  for (const int below : piece.planes(mesh.cells.size())) {
    corners.push_back(next - below);
    next += below == 0;
  }
  ASSERT_EQ(next, static_cast<int>(n));
  std::vector<std::vector<int>> places, fields;
  for (int axis = 0; axis < 3; ++axis) places.push_back(sums(piece.signed_planes(n)));
  for (int f = 0; f < 2; ++f) fields.push_back(piece.codes(n, nullptr));
  EXPECT_TRUE(piece.is_at_end());

  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto was = static_cast<std::size_t>(mesh.cells[c]), is = static_cast<std::size_t>(corners[c]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(cube.low[axis] + places[axis][is] * cube.span / Cube::k_steps, mesh.points[3 * was + axis],
                  0.5001 * cube.span / Cube::k_steps);
    for (std::size_t f = 0; f < 2; ++f) {
      const FieldSteps& range = steps[f].second;
      const double step = (range.high - range.low) / FieldSteps::k_steps;
      ASSERT_NEAR(range.low + (fields[f][is] - 1) * step, mesh.find(steps[f].first)->values[was], 0.5001 * step);
    }
  }
}

TEST(PackedMesh, WithoutAFieldIsRefusedByItsFile) {
  EXPECT_EQ(message_of<InputError>([] {
              packed_mesh(sphere(1, 0), {}, {{"sugar", {}}}, "surface_0000.hdf");
            }),
            "surface_0000.hdf: has no field 'sugar': make the figure again");
}

TEST(PackedMesh, OfMoreThanTwoBytesCanNumberIsRefused) {
  Mesh mesh;
  mesh.points.resize(3 * 65537);
  EXPECT_THROW(packed_mesh(mesh, {}, {}, ""), std::invalid_argument);
  mesh.points.resize(3 * 4);
  mesh.cells = {0, 1, 2};
  EXPECT_THROW(packed_mesh(mesh, {}, {}, ""), std::invalid_argument) << "vertex 3 is no corner";
}

TEST(PackedParticles, AreThoseOfEachFrameAlsoWhereSomeComeAndGo) {
  std::mt19937 random(2019);
  ParticleCodes frames[3];
  for (ParticleCodes& frame : frames) {
    frame.fields.resize(2);
    for (int i = 0; i < 500; ++i) {
      const bool is_there = random() % 4 != 0;
      const auto any = [&] { return static_cast<std::uint16_t>(random() % (Cube::k_steps + 1)); };
      frame.positions.push_back(is_there ? std::array{any(), any(), any()} : std::array{Cube::k_absent, Cube::k_absent, Cube::k_absent});
      for (auto& field : frame.fields) field.push_back(static_cast<std::uint8_t>(is_there ? 1 + random() % 255 : 0));
    }
  }
  std::vector<std::vector<int>> places, fields;
  for (std::size_t k = 0; k < 3; ++k) {
    Unpacking piece(packed_particles(frames[k], k > 0 ? &frames[k - 1] : nullptr));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<int> now = piece.signed_planes(500);
      if (k == 0) places.push_back(sums(std::move(now)));
      for (std::size_t i = 0; k > 0 && i < 500; ++i) places[axis][i] += now[i];
      for (std::size_t i = 0; i < 500; ++i) ASSERT_EQ(places[axis][i], frames[k].positions[i][axis]);
    }
    for (std::size_t f = 0; f < 2; ++f) {
      std::vector<int> now = piece.codes(500, k > 0 ? &fields[f] : nullptr);
      if (k == 0) fields.emplace_back();
      fields[f] = std::move(now);
      for (std::size_t i = 0; i < 500; ++i) ASSERT_EQ(fields[f][i], frames[k].fields[f][i]);
    }
    EXPECT_TRUE(piece.is_at_end());
  }
}

TEST(Codes, OfWhatIsOutsideTheRangeAreThoseOfItsEnds) {
  const Cube cube{{1, 1, 1}, 2};
  EXPECT_EQ(cube.code(0, 0), 0);
  EXPECT_EQ(cube.code(1, 1), 0);
  EXPECT_EQ(cube.code(3, 2), Cube::k_steps);
  EXPECT_EQ(cube.code(4, 2), Cube::k_steps);
  const FieldSteps steps{10, 20};
  EXPECT_EQ(steps.code(9), 1);
  EXPECT_EQ(steps.code(15), 128);
  EXPECT_EQ(steps.code(21), 255);
  EXPECT_EQ(steps.code(std::nan("")), 1);
  EXPECT_EQ((FieldSteps{5, 5}.code(5)), 1);
}

class Bodies : public testing::Test {
 protected:
  const TemporaryFolder place;

  /// Codes of the first field at the nodes of a frame.
  static std::vector<int> nodes_of(const PackedBody& body, const nlohmann::json& frame) {
    const auto& shape = body.head["grid"]["shape"];
    const std::size_t count = shape[0].get<std::size_t>() * shape[1].get<std::size_t>() * shape[2].get<std::size_t>();
    const std::size_t at = frame["fields"][0], size = frame["fields"][1];
    const Bytes piece(body.bytes.begin() + static_cast<std::ptrdiff_t>(at), body.bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
    return Unpacking(inflated(piece, 4 * count)).codes(count, nullptr);
  }
};

TEST_F(Bodies, ShareSizeAndRangesAndAreSmall) {
  write_ball(place / "a");
  write_ball(place / "b");
  write_mesh(place / "b/surface_0020.hdf", sphere(0.3, 2, 0.5));  // farther to the side
  const std::vector<PackedBody> bodies = packed_bodies({place / "a", place / "b"}, true);
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].head["span"], bodies[1].head["span"]);
  EXPECT_NEAR(bodies[0].head["span"].get<double>(), 1.1, 1e-3);
  EXPECT_EQ(bodies[0].head["fields"], bodies[1].head["fields"]);
  EXPECT_EQ(bodies[0].head["frames"].size(), 3u);
  EXPECT_EQ(bodies[0].head["frames"][1]["time"], 1.0);
  EXPECT_LT(bodies[0].bytes.size(), 120'000u);
  EXPECT_EQ(packed_bodies({place / "a"}, false)[0].head["particles"], 0);
}

TEST_F(Bodies, ShowTheFieldsThatAllOfThemHave) {
  write_ball(place / "a");
  std::filesystem::create_directories(place / "dry");
  for (const char* name : {"surface_0000.hdf", "look.json"}) std::filesystem::copy(place / "a" / name, place / "dry" / name);
  FrameData data;
  data.positions = std::vector<float>{0, 0, 0};
  data.columns = {{"id", "", std::vector<std::int64_t>{1}, 1}, {"volume", "m^3", std::vector<float>{1}, 1}};
  data.columns.push_back({"temperature", "C", std::vector<float>{20}, 1});
  write_frame(place / "dry/particles_0000.hdf", 0, data);
  EXPECT_EQ(packed_bodies({place / "a"}, false)[0].head["fields"].size(), 4u);
  for (const PackedBody& body : packed_bodies({place / "a", place / "dry"}, false)) {
    ASSERT_EQ(body.head["fields"].size(), 1u);
    EXPECT_EQ(body.head["fields"][0]["name"], "temperature");
  }
}

TEST_F(Bodies, HaveTheFieldsOfTheirInsideOnAGrid) {
  write_ball(place / "a");
  const PackedBody body = packed_bodies({place / "a"}, false).front();
  const auto& grid = body.head["grid"];
  const double h = grid["spacing"];
  const auto low = body.head["low"].get<std::array<double, 3>>();
  const auto shape = grid["shape"].get<std::array<std::size_t, 3>>();
  const auto& field = body.head["fields"][0];
  EXPECT_EQ(field["name"], "temperature");
  const double from = field["low"], to = field["high"], r = radius_at(2);
  const std::vector<int> codes = nodes_of(body, body.head["frames"][2]);
  int inside = 0;
  for (std::size_t n = 0; n < codes.size(); ++n) {
    const double x = low[0] + h * static_cast<double>(n % shape[0]), y = low[1] + h * static_cast<double>(n / shape[0] % shape[1]),
                 z = low[2] + h * static_cast<double>(n / shape[0] / shape[1]);
    if (std::hypot(x, y, z) > 0.9 * r) continue;
    ++inside;
    EXPECT_NEAR(from + (codes[n] - 1) * (to - from) / FieldSteps::k_steps, AtPlace(x, y, z, r).temperature_C, 3);
  }
  EXPECT_GT(inside, 2000);
  // at the start the ball is smaller: far from it there is nothing
  EXPECT_EQ(nodes_of(body, body.head["frames"][0]).front(), 0);
}

TEST_F(Bodies, WithoutFilesAreRefused) {
  EXPECT_THROW(packed_bodies({place / "none"}, false), InputError);
  write_ball(place / "a");
  std::filesystem::remove(place / "a/look.json");
  EXPECT_THROW(packed_bodies({place / "a"}, false), InputError);
  write_ball(place / "a");
  std::filesystem::remove(place / "a/particles_0010.hdf");
  EXPECT_THROW(packed_bodies({place / "a"}, false), InputError);
}

}  // namespace
}  // namespace bake::report

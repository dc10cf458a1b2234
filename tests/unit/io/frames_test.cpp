// SPDX-License-Identifier: MIT
#include "solver/io/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/core/errors.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

TEST(Frame, ComesBackExactlyWithUnitsAndTime) {
  const TemporaryFolder scratch;
  const std::vector<float> positions{0, 0.1f, -0.0f, 1e-40f, std::numeric_limits<float>::max(), 3};
  const std::vector<float> theta{20.5f, NAN};
  const std::vector<float> velocity{1, 2, 3, 4, 5, 6};
  const std::vector<std::int64_t> id{7, std::int64_t{1} << 60};
  const double time_s = 1.0 / 24;
  write_frame(scratch / "0001.hdf", time_s, {positions, {{"theta", "C", theta, 1}, {"velocity", "m/s", velocity, 3}, {"id", "1", id, 1}}});
  const Hdf5Reader in(scratch / "0001.hdf");
  EXPECT_TRUE(same_bits(in.table<float>("VTKHDF/Points", 3), positions));
  EXPECT_TRUE(same_bits(in.array<float>("VTKHDF/PointData/theta"), theta));
  EXPECT_EQ(in.table<float>("VTKHDF/PointData/velocity", 3), velocity);
  EXPECT_EQ(in.array<std::int64_t>("VTKHDF/PointData/id"), id);
  EXPECT_EQ(in.attribute<std::string>("VTKHDF/PointData/theta", "unit"), "C");
  EXPECT_EQ(in.attribute<std::string>("VTKHDF/Points", "unit"), "m");
  EXPECT_EQ(in.attribute<double>("VTKHDF", "time_s"), time_s);
}

TEST(Frame, KeepsPositionsInDoubleWhereGivenSo) {
  const TemporaryFolder scratch;
  const std::vector<double> positions{1e6, 1e6 + 1e-4, -1e6, 1e6, 1e6 + 2e-4, -1e6};
  write_frame(scratch / "0001.hdf", 0, {positions, {}});
  EXPECT_EQ(Hdf5Reader(scratch / "0001.hdf").stored_type("VTKHDF/Points"), ElementType::float64);
  EXPECT_EQ(FrameReader(scratch / "0001.hdf").positions(), positions);
}

TEST(Frame, NeedsDoubleWhereFloatDoesNotResolveAThousandthOfANodeDistance) {
  EXPECT_FALSE(stores_double_positions(false, 10, 1e-3));
  EXPECT_TRUE(stores_double_positions(true, 10, 1e-3));
  EXPECT_TRUE(stores_double_positions(false, 17, 1e-3));
  const float before = 16.3f;  // just before the bound the next float is 2^-20 m away
  EXPECT_LT(std::nextafter(before, 17.0f) - before, 1e-3 * 1e-3 * 2);
}

TEST(FrameWriter, WritesPartsAsItWritesTheWhole) {
  const TemporaryFolder scratch;
  constexpr std::size_t n = 1000;
  std::vector<std::int64_t> id(n);
  std::vector<float> x(3 * n), theta(n), v(3 * n);
  for (std::size_t i = 0; i < n; ++i) id[i] = static_cast<std::int64_t>(2 * i), theta[i] = static_cast<float>(i) / 7;
  for (std::size_t i = 0; i < 3 * n; ++i) x[i] = static_cast<float>(i) / 3, v[i] = -x[i];
  const Members members{{2 * n, n}};
  const FrameData parts[] = {
      {x, {}, members}, {{}, {{"id", "1", id}}, members}, {{}, {{"theta", "C", theta}, {"velocity", "m/s", v, 3}}, members}};
  FrameWriter by_parts, whole;
  for (const char* name : {"0", "1"}) {  // the second frame keeps identities and cells of the first
    const auto in_parts = scratch / (std::string("parts_") + name), in_one = scratch / (std::string("whole_") + name);
    by_parts.write(in_parts, 0.5, n, members, std::size(parts), [&](std::size_t part) { return parts[part]; })->commit();
    whole.write(in_one, 0.5, {x, {{"id", "1", id}, {"theta", "C", theta}, {"velocity", "m/s", v, 3}}, members})->commit();
    EXPECT_TRUE(contents(in_parts) == contents(in_one));
  }
  EXPECT_EQ(FrameReader(scratch / "parts_1").column("velocity", 3), v);
  EXPECT_EQ(FrameReader(scratch / "parts_1").identities(), id);
}

TEST(FrameWriter, WritesTheSameFrameWhateverItKeeps) {
  const TemporaryFolder scratch;
  FrameWriter frames;
  const auto write = [&](const char* name, std::size_t ever, std::vector<std::int64_t> id) {
    const std::size_t here = id.size();
    FrameData data{std::vector<float>(3 * here, static_cast<float>(ever)),
                   {{"id", "1", std::move(id)}, {"theta", "C", std::vector<float>(here, static_cast<float>(ever))}}};
    data.members = {ever, here};
    frames.write(scratch / name, 0, data)->commit();
  };
  write("first", 3, {0, 1, 2});
  write("same", 3, {0, 1, 2});
  write("fewer", 3, {0, 2});
  write("other", 4, {2, 3});
  EXPECT_TRUE(contents(scratch / "same") == contents(scratch / "first"));
  EXPECT_EQ(FrameReader(scratch / "same").identities(), (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(FrameReader(scratch / "fewer").identities(), (std::vector<std::int64_t>{0, 2}));
  EXPECT_EQ(FrameReader(scratch / "other").identities(), (std::vector<std::int64_t>{2, 3}));
  EXPECT_EQ(FrameReader(scratch / "other").column("theta"), (std::vector<float>{4, 4}));
  EXPECT_EQ(Hdf5Reader(scratch / "other").array<std::int64_t>("VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 1, 2}));
}

TEST(FrameWriter, PacksIdentitiesAndCellsOnceForTheSameParticles) {
  const TemporaryFolder scratch;
  FrameWriter frames;
  const auto write = [&](std::int64_t id) {  // a lie about who is there shows what was kept
    FrameData data{std::vector<float>(3), {{"id", "1", std::vector{id}}}, Members{{1, 1}}};
    frames.write(scratch / "frame", 0, data)->commit();
    return FrameReader(scratch / "frame").identities().at(0);
  };
  EXPECT_EQ(write(7), 7);
  EXPECT_EQ(write(8), 7);
}

TEST(FrameWriter, SaysWhyItCannotWriteAndGoesOnWithTheNextFrame) {
  const TemporaryFolder scratch;
  FrameWriter frames;
  const FrameData data{std::vector<float>(3), {{"theta", "C", std::vector<float>(1)}}, Members{{1, 1}}};
  const auto message = message_of<OutputError>([&] { frames.write(scratch / "none/0000.hdf", 0, data); });
  EXPECT_TRUE(message.find("none/0000.hdf: cannot create: No such file") != std::string::npos) << message;
  frames.write(scratch / "0001.hdf", 0, data)->commit();
  EXPECT_EQ(FrameReader(scratch / "0001.hdf").particles(), 1u);
}

TEST(Frame, HasAVtkCellForEachParticle) {
  const TemporaryFolder scratch;
  const std::vector<float> positions(9);
  write_frame(scratch / "0000.hdf", 0, {positions, {}});
  const Hdf5Reader in(scratch / "0000.hdf");
  EXPECT_EQ(in.attribute<std::string>("VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(in.array<std::int64_t>("VTKHDF/NumberOfPoints"), (std::vector<std::int64_t>{3}));
  EXPECT_EQ(in.array<std::int64_t>("VTKHDF/NumberOfCells"), (std::vector<std::int64_t>{3}));
  EXPECT_EQ(in.array<std::int64_t>("VTKHDF/Connectivity"), (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(in.array<std::int64_t>("VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 1, 2, 3}));
  EXPECT_EQ(in.array<std::uint8_t>("VTKHDF/Types"), (std::vector<std::uint8_t>{1, 1, 1}));
}

TEST(Frame, MayHaveNoParticles) {
  const TemporaryFolder scratch;
  write_frame(scratch / "0000.hdf", 0, {{}, {{"theta", "C", std::vector<float>(), 1}, {"velocity", "m/s", std::vector<float>(), 3}}});
  const Hdf5Reader in(scratch / "0000.hdf");
  EXPECT_TRUE(in.table<float>("VTKHDF/Points", 3).empty());
  EXPECT_TRUE(in.table<float>("VTKHDF/PointData/velocity", 3).empty());
}

TEST(Frame, RefusesColumnsOfAnotherLength) {
  const TemporaryFolder scratch;
  const std::vector<float> positions(9), theta(2);
  const auto message = message_of<std::invalid_argument>([&] {
    write_frame(scratch / "0000.hdf", 0, {positions, {{"theta", "C", theta, 1}}});
  });
  EXPECT_TRUE(has(message, "theta has 2 numbers for 3 particles")) << message;
  EXPECT_EQ(files_in(scratch.path()), 0u);
}

TEST(Frame, NamesSortLikeNumbers) {
  EXPECT_EQ(frame_name(0), "0000.hdf");
  EXPECT_EQ(frame_name(42), "0042.hdf");
  EXPECT_EQ(frame_name(12345), "12345.hdf");
}

TEST(FrameReader, FindsEveryParticleWhateverTheOrder) {
  const TemporaryFolder scratch;
  const std::vector<float> positions{0, 0, 0, 1, 1, 1, 2, 2, 2}, theta{20, 30, 40};
  const std::vector<std::int64_t> id{12, 10, 13};
  write_frame(scratch / "0001.hdf", 0.5, {positions, {{"theta", "C", theta, 1}, {"id", "1", id, 1}}});
  const FrameReader frame(scratch / "0001.hdf");
  EXPECT_EQ(frame.time_s(), 0.5);
  EXPECT_EQ(frame.particles(), 3u);
  EXPECT_EQ(frame.positions(), (std::vector<double>{0, 0, 0, 1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(frame.column("theta"), theta);
  EXPECT_EQ(frame.rows_by_identity(10, 4), (std::vector<std::int64_t>{1, -1, 0, 2}));
  EXPECT_EQ(frame.rows_by_identity(12, 1), (std::vector<std::int64_t>{0}));
  EXPECT_TRUE(has(message_of<InputError>([&] { frame.column("saturation"); }), "found no column saturation"));
}

TEST(FrameReader, RefusesWhatIsNoFrame) {
  const TemporaryFolder scratch;
  AtomicFile file(scratch / "particles.h5");
  Hdf5Writer out(file);
  out.array<double>("volumes", std::vector<double>{1});
  out.close();
  file.commit();
  EXPECT_TRUE(has(message_of<InputError>([&] { FrameReader frame(scratch / "particles.h5"); }), "not a frame"));
}

TEST(Series, ListsFilesWithExactTimes) {
  const TemporaryFolder scratch;
  write_series(scratch / "frames.hdf.series", {{"0000.hdf", 0}, {"0001.hdf", 1.0 / 24}});
  const auto series = nlohmann::json::parse(contents(scratch / "frames.hdf.series"));
  EXPECT_EQ(series["file-series-version"], "1.0");
  ASSERT_EQ(series["files"].size(), 2u);
  EXPECT_EQ(series["files"][1]["name"], "0001.hdf");
  EXPECT_EQ(series["files"][1]["time"].get<double>(), 1.0 / 24);
}

}  // namespace
}  // namespace bake

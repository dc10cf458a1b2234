// SPDX-License-Identifier: MIT
#include "solver/io/checkpoint.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "solver/io/checksum.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

constexpr auto k_single = Precision::single_precision;
constexpr const char* k_advice = "; resume from another checkpoint or start the run anew";

std::vector<float> strange_floats() {
  return {std::bit_cast<float>(0x7fc12345u), std::bit_cast<float>(0x7f812345u) /* signalling */, -0.0f, 1e-45f, -INFINITY, 0.1f};
}

void write_example(const std::filesystem::path& path) {
  CheckpointWriter out(path, "scene 5e1f", k_single);
  out.add<float>("position", strange_floats());
  out.add<double>("mass", std::vector{-0.0, 5e-324, 1.0 / 3});
  out.add<std::int32_t>("material", std::vector<std::int32_t>{-1, 2});
  out.add<std::int64_t>("id", std::vector<std::int64_t>{1LL << 62});
  out.add<double>("none", {});
  out.set("time_s", 0.1 + 0.2);
  out.set("frame", std::int64_t{-3});
  out.set("steps", std::numeric_limits<std::uint64_t>::max());
  out.set("random", "state 1 2 3");
  out.commit();
}

class ACheckpoint : public testing::Test {
 protected:
  ACheckpoint() { write_example(path_); }
  std::string refusal() {
    return message_of<InputError>([&] { CheckpointReader{path_}; });
  }
  const TemporaryFolder scratch_;
  const std::filesystem::path path_ = scratch_ / "checkpoint.h5";
};

TEST_F(ACheckpoint, ComesBackBitForBit) {
  const CheckpointReader in(path_);
  in.expect("scene 5e1f", k_single);
  EXPECT_TRUE(same_bits(in.array<float>("position"), strange_floats()));
  EXPECT_TRUE(same_bits(in.array<double>("mass"), std::vector{-0.0, 5e-324, 1.0 / 3}));
  EXPECT_EQ(in.array<std::int32_t>("material"), (std::vector<std::int32_t>{-1, 2}));
  EXPECT_EQ(in.array<std::int64_t>("id"), (std::vector<std::int64_t>{1LL << 62}));
  EXPECT_TRUE(in.array<double>("none").empty());
  EXPECT_EQ(in.value<double>("time_s"), 0.1 + 0.2);
  EXPECT_EQ(in.value<std::int64_t>("frame"), -3);
  EXPECT_EQ(in.value<std::uint64_t>("steps"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(in.value<std::string>("random"), "state 1 2 3");
}

TEST_F(ACheckpoint, HasTheSameBytesWhenWrittenTwice) {
  write_example(scratch_ / "again.h5");
  EXPECT_EQ(contents(path_), contents(scratch_ / "again.h5"));
}

TEST_F(ACheckpoint, HoldsManyArraysAndValues) {
  CheckpointWriter out(path_, "", k_single);
  for (int i = 0; i < 300; ++i) {
    out.add<std::int32_t>(fmt::format("a{}", i), std::array{i});
    out.set(fmt::format("v{}", i), std::int64_t{i});
  }
  out.commit();
  const CheckpointReader in(path_);
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(in.array<std::int32_t>(fmt::format("a{}", i)), std::vector{i});
    EXPECT_EQ(in.value<std::int64_t>(fmt::format("v{}", i)), i);
  }
}

TEST_F(ACheckpoint, IsNotTouchedByAWriterThatGivesUp) {
  const auto old = contents(path_);
  {
    CheckpointWriter out(path_, "another", k_single);
    out.add<float>("position", std::vector<float>(5000));
  }
  EXPECT_EQ(contents(path_), old);
  EXPECT_EQ(files_in(scratch_.path()), 1u);
}

TEST_F(ACheckpoint, IsRefusedWhenAnyByteIsFlipped) {
  const auto whole = contents(path_);
  for (std::size_t at = 0; at < whole.size(); at += at < 700 ? 1 : 13) {
    auto damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    put(path_, damaged);
    const auto message = refusal();
    EXPECT_TRUE(has(message, "checkpoint.h5: ") && has(message, k_advice)) << "byte " << at << ": " << message;
  }
}

TEST_F(ACheckpoint, IsRefusedWhenCutShortAnywhere) {
  const auto whole = contents(path_);
  for (std::size_t length = 0; length < whole.size(); length += 101) {
    put(path_, whole.substr(0, length));
    const auto expected = length < k_checkpoint_heading ? std::string() : fmt::format("checkpoint.h5: cut short, {} of ", length);
    const auto message = refusal();
    EXPECT_TRUE(has(message, expected) && has(message, k_advice)) << "length " << length << ": " << message;
  }
}

TEST_F(ACheckpoint, IsRefusedWithSomethingAppended) {
  put(path_, contents(path_) + "x");
  EXPECT_TRUE(has(refusal(), "checkpoint.h5: damaged, its checksum does not match its contents")) << refusal();
}

TEST_F(ACheckpoint, MustBeThere) {
  std::filesystem::remove(path_);
  EXPECT_TRUE(has(refusal(), "checkpoint.h5: cannot open the checkpoint: No such file or directory; resume from")) << refusal();
}

TEST_F(ACheckpoint, MustBeOneOfOurs) {
  AtomicFile file(path_);
  Hdf5Writer out(file);
  out.close();
  file.commit();
  EXPECT_TRUE(has(refusal(), "checkpoint.h5: not a checkpoint of Bake")) << refusal();
}

TEST_F(ACheckpoint, MustNotBeAFolder) {
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  EXPECT_TRUE(has(refusal(), "checkpoint.h5: ")) << refusal();
}

TEST_F(ACheckpoint, MustBeOfThisFormat) {
  auto text = contents(path_);
  text.replace(0, 17, "bake checkpoint 9");
  put(path_, text);
  EXPECT_TRUE(has(refusal(), "written in checkpoint format 9, this program reads format " + std::to_string(k_checkpoint_format)))
      << refusal();
}

TEST_F(ACheckpoint, MustFitSceneAndPrecision) {
  const CheckpointReader in(path_);
  const auto scene = message_of<InputError>([&] { in.expect("scene 0000", k_single); });
  EXPECT_TRUE(has(scene, "checkpoint.h5: belongs to another scene; resume from")) << scene;
  const auto key = message_of<InputError>([&] { in.expect("scene 0000", k_single, [] { return "grid.dx_m: found 1, there 2"; }); });
  EXPECT_TRUE(has(key, "belongs to another scene (grid.dx_m: found 1, there 2); resume from")) << key;
  const auto precision = message_of<InputError>([&] { in.expect("scene 5e1f", Precision::double_precision); });
  EXPECT_TRUE(has(precision, "written in single precision, the run asks for double; resume with precision = \"single\"")) << precision;
}

TEST_F(ACheckpoint, GivesArraysInTheirOwnTypeOnly) {
  const CheckpointReader in(path_);
  const auto type = message_of<InputError>([&] { in.array<double>("position"); });
  EXPECT_TRUE(has(type, "arrays/position: holds numbers of another type")) << type;
  const auto missing = message_of<InputError>([&] { in.array<double>("velocity"); });
  EXPECT_TRUE(has(missing, "arrays/velocity: there is no such dataset")) << missing;
  const auto value = message_of<InputError>([&] { in.value<double>("frame"); });
  EXPECT_TRUE(has(value, "values @frame: is of another type")) << value;
}

std::uint64_t checksum_of(std::string_view text) { return checksum(std::as_bytes(std::span(text))); }

TEST(Checksum, IsXxh64) {  // values of the reference implementation
  EXPECT_EQ(checksum_of(""), 0xEF46DB3751D8E999u);
  EXPECT_EQ(checksum_of("a"), 0xD24EC4F1A98C6E5Bu);
  EXPECT_EQ(checksum_of("abc"), 0x44BC2CF5AD770999u);
  EXPECT_EQ(checksum_of("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1u);
}

}  // namespace
}  // namespace bake

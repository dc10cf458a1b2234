// SPDX-License-Identifier: MIT
#include "solver/io/hdf5.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <omp.h>

#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <random>

#include "solver/scene/scene.h"
#include "tests/support/threads_restored.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

template <class T>
std::vector<T> awkward_numbers() {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    auto payload = Limits::quiet_NaN();
    reinterpret_cast<unsigned char*>(&payload)[0] = 0x5a;
    return {0,
            -T{0},
            Limits::denorm_min(),
            -Limits::min() / 2,
            Limits::max(),
            Limits::lowest(),
            Limits::infinity(),
            -Limits::infinity(),
            Limits::quiet_NaN(),
            -Limits::quiet_NaN(),
            payload,
            T(1) / 3};
  } else {
    return {0, 1, Limits::max(), Limits::min()};
  }
}

template <class Write>
void write_file(const std::filesystem::path& path, Write write) {
  AtomicFile file(path);
  Hdf5Writer out(file);
  write(out);
  out.close();
  file.commit();
}

template <class T>
class Hdf5Numbers : public testing::Test {};
using Numbers = testing::Types<float, double, std::int32_t, std::int64_t, std::uint64_t, std::uint8_t>;
TYPED_TEST_SUITE(Hdf5Numbers, Numbers);

TYPED_TEST(Hdf5Numbers, ComeBackBitForBit) {
  const TemporaryFolder scratch;
  const auto numbers = awkward_numbers<TypeParam>();
  for (const auto packing : {Packing::none, Packing::shuffle_gzip}) {
    write_file(scratch / "f.hdf", [&](Hdf5Writer& out) {
      out.array("deep/in/array", std::span<const TypeParam>(numbers), packing);
      out.table("table", std::span<const TypeParam>(numbers), 2, packing);
    });
    const Hdf5Reader in(scratch / "f.hdf");
    EXPECT_TRUE(same_bits(in.array<TypeParam>("deep/in/array"), numbers));
    EXPECT_TRUE(same_bits(in.table<TypeParam>("table", 2), numbers));
    EXPECT_EQ(in.stored_type("table"), element_type<TypeParam>());
    EXPECT_EQ(in.shape("table"), (std::vector<std::size_t>{numbers.size() / 2, 2}));
  }
}

TYPED_TEST(Hdf5Numbers, MayBeNone) {
  const TemporaryFolder scratch;
  write_file(scratch / "f.hdf", [](Hdf5Writer& out) {
    out.array("array", std::span<const TypeParam>(), Packing::shuffle_gzip);
    out.table("table", std::span<const TypeParam>(), 3, Packing::shuffle_gzip);
  });
  const Hdf5Reader in(scratch / "f.hdf");
  EXPECT_TRUE(in.array<TypeParam>("array").empty());
  EXPECT_TRUE(in.table<TypeParam>("table", 3).empty());
}

TEST(Hdf5, KeepsArraysOfManyPieces) {
  const TemporaryFolder scratch;
  std::vector<std::int32_t> numbers(200001);
  std::iota(numbers.begin(), numbers.end(), -7);
  write_file(scratch / "f.hdf", [&](Hdf5Writer& out) { out.array<std::int32_t>("n", numbers, Packing::shuffle_gzip); });
  EXPECT_EQ(Hdf5Reader(scratch / "f.hdf").array<std::int32_t>("n"), numbers);
  EXPECT_LT(std::filesystem::file_size(scratch / "f.hdf"), numbers.size() * 2);
}

std::vector<float> rough_numbers(std::size_t count) {
  std::mt19937 random(2019);
  std::vector<float> numbers(count);
  for (float& number : numbers) number = 1 + static_cast<float>(random() % 0x800000) / 0x800000;  // noise in all of the mantissa
  return numbers;
}

/// What each of a chunk's blocks begins with: whether it is the last one, and its kind (0: bytes as they are) [RFC 1951 Sec. 3.2.3].
/// Follows stored blocks only, so the list ends with the first that is not one.
std::vector<int> kinds_of_blocks(const std::string& zlib_stream) {
  std::vector<int> kinds;
  for (std::size_t at = 2; at < zlib_stream.size();) {
    const auto byte = [&](std::size_t i) { return std::size_t{static_cast<unsigned char>(zlib_stream.at(at + i))}; };
    kinds.push_back(static_cast<int>(byte(0) & 7));
    if (kinds.back() != 0) break;
    EXPECT_EQ(byte(1) + 256 * byte(2), 0xffff - (byte(3) + 256 * byte(4)));
    at += 5 + byte(1) + 256 * byte(2);
  }
  return kinds;
}

std::string first_chunk(const std::filesystem::path& path, const char* name) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle data(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  hsize_t bytes = 0;
  const hsize_t first = 0;
  H5Dget_chunk_storage_size(data, &first, &bytes);
  std::string chunk(bytes, '\0');
  std::uint32_t filters = 0;
  H5Dread_chunk(data, H5P_DEFAULT, &first, &filters, chunk.data());
  EXPECT_EQ(filters, 0u) << "a filter was left out";
  return chunk;
}

TEST(Hdf5, StoresBytesThatLookLikeNoiseAndDeflatesTheOthers) {
  const TemporaryFolder scratch;
  const std::vector<float> rough = rough_numbers(16384);
  std::vector<std::int64_t> counted(16384);
  std::iota(counted.begin(), counted.end(), 0);
  write_file(scratch / "f.hdf", [&](Hdf5Writer& out) {
    out.array<float>("rough", rough, Packing::shuffle_gzip);
    out.array<std::int64_t>("counted", counted, Packing::shuffle_gzip);
  });
  EXPECT_TRUE(same_bits(Hdf5Reader(scratch / "f.hdf").array<float>("rough"), rough));
  EXPECT_EQ(Hdf5Reader(scratch / "f.hdf").array<std::int64_t>("counted"), counted);
  const auto rough_kinds = kinds_of_blocks(first_chunk(scratch / "f.hdf", "rough"));
  ASSERT_EQ(rough_kinds.size(), 2u) << "the two low bytes of the mantissas in one block, then what is deflated";
  EXPECT_EQ(rough_kinds[0], 0);
  EXPECT_NE(kinds_of_blocks(first_chunk(scratch / "f.hdf", "counted"))[0], 0) << "each byte is as frequent as any other, and yet no noise";
}

TEST(Hdf5, KeepsMoreNoiseThanABlockHolds) {
  const TemporaryFolder scratch;
  const std::vector<float> rough = rough_numbers(5 * 40000);
  write_file(scratch / "f.hdf", [&](Hdf5Writer& out) { out.table<float>("rough", rough, 5, Packing::shuffle_gzip); });
  EXPECT_TRUE(same_bits(Hdf5Reader(scratch / "f.hdf").table<float>("rough", 5), rough));
}

TEST(Hdf5, DividesAnArrayIntoEvenPieces) {
  const TemporaryFolder scratch;
  write_file(scratch / "f.hdf",
             [&](Hdf5Writer& out) { out.array<float>("n", std::vector<float>(16384 + 2, 0.5f), Packing::shuffle_gzip); });
  const Hdf5Handle file(H5Fopen((scratch / "f.hdf").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle data(H5Dopen2(file, "n", H5P_DEFAULT), H5Dclose);
  hsize_t rows = 0;
  EXPECT_EQ(H5Pget_chunk(Hdf5Handle(H5Dget_create_plist(data), H5Pclose), 1, &rows), 1);
  EXPECT_EQ(rows, 8193u) << "not one of 16384 and one that is nearly empty";
}

/// Arrays of as many chunks as their number.
class Pack : public testing::Test {
 protected:
  Pack() {
    for (std::size_t a = 0; a < 12; ++a) numbers_.push_back(std::vector<float>(a * 16384, static_cast<float>(a)));
    for (const auto& numbers : numbers_) arrays_.push_back(array_view<float>(numbers));
    omp_set_num_threads(3);
  }

  std::vector<ArrayView> arrays_;

 private:
  std::vector<std::vector<float>> numbers_;
  const ThreadsRestored restored_;
};

TEST_F(Pack, GivesEachArrayInOrderAndOneAtATime) {
  std::vector<std::size_t> order, chunks;
  std::atomic<int> inside = 0;
  pack(arrays_, [&](std::size_t array, const PackedArray& packed) {
    EXPECT_EQ(++inside, 1);
    order.push_back(array);
    chunks.push_back(packed.chunks.size());
    --inside;
  });
  std::vector<std::size_t> rising(12);
  std::iota(rising.begin(), rising.end(), 0);
  EXPECT_EQ(order, rising);
  EXPECT_EQ(chunks, rising);
}

TEST_F(Pack, ThrowsWhatItsTakerThrewAndGivesNoMore) {
  std::size_t given = 0;
  const auto take = [&](std::size_t array, const PackedArray&) {
    ++given;
    if (array == 3) throw OutputError("the disk is full");
  };
  EXPECT_EQ(message_of<OutputError>([&] { pack(arrays_, take); }), "the disk is full");
  EXPECT_EQ(given, 4u);
}

/// As libgomp does if any thread may make the tasks (findings/libgomp_task_table.sh).
TEST_F(Pack, LosesNoMemory) {
  arrays_.resize(2);
  const auto grown = [&](int times) {
    const std::size_t before = mallinfo2().uordblks;
    for (int i = 0; i < times; ++i) pack(arrays_, [](std::size_t, const PackedArray&) {});
    return static_cast<long>(mallinfo2().uordblks - before);
  };
  grown(100);  // what threads keep for the next time
  EXPECT_LT(grown(2000), 10000);
}

TEST(Hdf5, KeepsAttributesExactly) {
  const TemporaryFolder scratch;
  const auto reals = awkward_numbers<double>();
  write_file(scratch / "f.hdf", [&](Hdf5Writer& out) {
    out.group("g");
    for (std::size_t i = 0; i < reals.size(); ++i) out.attribute("g", fmt::format("real{}", i), reals[i]);
    out.attribute("g", "whole", std::numeric_limits<std::int64_t>::min());
    out.attribute("g", "large", std::numeric_limits<std::uint64_t>::max());
    out.attribute("g", "text", "90 °C");
    out.attribute("/", "empty", "");
  });
  const Hdf5Reader in(scratch / "f.hdf");
  for (std::size_t i = 0; i < reals.size(); ++i) {
    const auto read = in.attribute<double>("g", fmt::format("real{}", i));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(reals[i]));
  }
  EXPECT_EQ(in.attribute<std::int64_t>("g", "whole"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(in.attribute<std::uint64_t>("g", "large"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(in.attribute<std::string>("g", "text"), "90 °C");
  EXPECT_EQ(in.attribute<std::string>("/", "empty"), "");
}

TEST(Hdf5, GivesTheSameBytesForTheSameContents) {
  const TemporaryFolder scratch;
  const std::vector<float> numbers(1000, 0.5f);
  for (const auto* name : {"a.hdf", "b.hdf"}) {
    write_file(scratch / name, [&](Hdf5Writer& out) { out.array<float>("g/n", numbers, Packing::shuffle_gzip); });
  }
  EXPECT_EQ(contents(scratch / "a.hdf"), contents(scratch / "b.hdf"));
}

TEST(Hdf5, LeavesNothingWhenGivenUp) {
  const TemporaryFolder scratch;
  {
    AtomicFile file(scratch / "f.hdf");
    Hdf5Writer out(file);
    out.array<float>("n", std::vector<float>(100));
  }
  EXPECT_EQ(files_in(scratch.path()), 0u);
}

TEST(Hdf5, RefusesTheSameNameTwice) {
  const TemporaryFolder scratch;
  AtomicFile file(scratch / "f.hdf");
  Hdf5Writer out(file);
  const std::vector<float> numbers(3);
  out.array<float>("n", numbers);
  const auto message = message_of<OutputError>([&] { out.array<float>("n", numbers); });
  EXPECT_TRUE(has(message, "f.hdf: n: cannot be written")) << message;
}

TEST(Hdf5, SaysInOneLineWhatCannotBeRead) {
  const TemporaryFolder scratch;
  const auto path = scratch / "f.hdf";
  write_file(path, [](Hdf5Writer& out) {
    out.array<float>("numbers", std::vector<float>(6));
    out.attribute("/", "text", "words");
  });
  const Hdf5Reader in(path);
  const auto refusal = [&](auto action) { return message_of<InputError>([&] { action(in); }); };
  EXPECT_TRUE(has(refusal([](auto& f) { f.template array<float>("group/none"); }), "f.hdf: group/none: there is no such dataset"));
  EXPECT_TRUE(has(refusal([](auto& f) { f.template table<float>("numbers", 3); }), "numbers: has shape [6], needs [n, 3]"));
  EXPECT_TRUE(has(refusal([](auto& f) { f.template attribute<double>("/", "text"); }), "/ @text: is of another type"));
  EXPECT_TRUE(has(refusal([](auto& f) { f.template attribute<double>("/", "none"); }), "/ @none: there is no such attribute"));
}

TEST(Hdf5, SaysWhichFileCannotBeOpened) {
  const TemporaryFolder scratch;
  put(scratch / "note.txt", "these are words");
  write_file(scratch / "f.hdf", [](Hdf5Writer& out) { out.array<float>("n", std::vector<float>(1000)); });
  std::filesystem::resize_file(scratch / "f.hdf", 3000);
  const auto refusal = [&](const char* name) { return message_of<InputError>([&] { Hdf5Reader(scratch / name); }); };
  EXPECT_TRUE(has(refusal("missing.hdf"), "missing.hdf: cannot open: No such file or directory"));
  EXPECT_TRUE(has(refusal("note.txt"), "note.txt: not an HDF5 file, or cut short"));
  EXPECT_TRUE(has(refusal("f.hdf"), "f.hdf: not an HDF5 file, or cut short"));
  EXPECT_TRUE(has(refusal("."), "not an HDF5 file, or cut short"));
}

TEST(Hdf5, PrintsNothingItself) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(Hdf5Reader("/nowhere/at/all"), InputError);
  EXPECT_THROW(Hdf5Reader("/"), InputError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace bake

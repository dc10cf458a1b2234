// SPDX-License-Identifier: MIT
// Everything that is written must survive a disk that runs full: the old file intact, nothing half-written, a clear error, and
// no crash of HDF5 when the program ends (CTest runs each test in a program of its own and looks at how it ended).
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <array>
#include <csignal>
#include <functional>
#include <random>

#include "solver/io/checkpoint.h"
#include "solver/io/frames.h"
#include "solver/io/ledger_file.h"
#include "tests/support/threads_restored.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

constexpr std::size_t k_room = 1 << 20;  ///< bytes

/// A file system of 1 MiB, seen by this thread and those that it starts, and gone with them. False where that is not allowed.
bool mount_small_disk(const std::filesystem::path& folder) {
  return unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         mount("none", folder.c_str(), "tmpfs", 0, "size=1m") == 0;
}

/// While it lives, no file can grow beyond `bytes`: the nearest thing to a full disk that needs no rights.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before_{};
};

/// Writes a file of so many numbers, 4 bytes each.
using Write = std::function<void(const std::filesystem::path&, std::size_t numbers)>;

std::vector<float> noise(std::size_t count) {
  std::mt19937 random(1);
  std::vector<float> numbers(count);
  for (auto& number : numbers) number = static_cast<float>(random());
  return numbers;
}

void write_text(const std::filesystem::path& path, std::size_t numbers) { write_text_atomically(path, std::string(4 * numbers, 'x')); }

void write_noisy_frame(const std::filesystem::path& path, std::size_t numbers) {
  const auto positions = noise(numbers / 3 * 3);
  write_frame(path, 0, {positions, {}});
}

void write_checkpoint(const std::filesystem::path& path, std::size_t numbers) {
  CheckpointWriter out(path, "scene", Precision::single_precision);
  out.add<float>("numbers", noise(numbers));
  out.commit();
}

/// Many tiny arrays: HDF5 holds all of them back until the file is closed, so that closing is what fails.
void write_metadata(const std::filesystem::path& path, std::size_t numbers) {
  CheckpointWriter out(path, "scene", Precision::single_precision);
  for (std::size_t i = 0; i < numbers / 200; ++i) out.add<float>(fmt::format("a{}", i), std::array{1.0f});
  out.commit();
}

struct Case {
  const char* name;
  Write write;
};

class FullDisk : public testing::TestWithParam<Case> {
 protected:
  void expect_old_file_intact(const std::filesystem::path& folder, const std::function<void()>& write_too_much, const char* reason) {
    const auto file = folder / "result";
    GetParam().write(file, 10000);
    const auto old = contents(file);
    ASSERT_FALSE(old.empty());
    const auto message = message_of<UnfinishedOutputError>(write_too_much);
    EXPECT_TRUE(has(message, "result: cannot write: ") && has(message, reason)) << message;
    EXPECT_EQ(contents(file), old);
    EXPECT_EQ(files_in(folder), 1u);
    GetParam().write(file, 20000);  // and it goes on when there is room again
    EXPECT_NE(contents(file), old);
  }
  const TemporaryFolder scratch_;
  const ThreadsRestored restored_;
};

TEST_P(FullDisk, LeavesTheOldFileAndNothingHalfWritten) {
  omp_set_num_threads(1);  // threads from before do not see the small disk
  if (!mount_small_disk(scratch_.path())) GTEST_SKIP() << "mounting a file system needs more rights";
  expect_old_file_intact(
      scratch_.path(), [&] { GetParam().write(scratch_ / "result", k_room); }, "No space left on device");
  umount(scratch_.path().c_str());
}

TEST_P(FullDisk, OrAFileSizeLimitLeavesTheOldFileAndNothingHalfWritten) {
  const auto write_too_much = [&] {
    const FileSizeLimit limit(k_room);
    GetParam().write(scratch_ / "result", k_room);
  };
  expect_old_file_intact(scratch_.path(), write_too_much, "File too large");
}

INSTANTIATE_TEST_SUITE_P(Writing, FullDisk,
                         testing::Values(Case{"Text", write_text}, Case{"Frame", write_noisy_frame}, Case{"Checkpoint", write_checkpoint},
                                         Case{"Metadata", write_metadata}),
                         [](const auto& info) { return info.param.name; });

TEST(FullDiskLedger, KeepsItsLastWholeRow) {
  const TemporaryFolder scratch;
  const auto path = scratch / "ledger.csv";
  auto ledger = LedgerFile::create(path, {"frame", "mass_kg"});
  ledger.append(std::array{0.0, 0.1});
  const auto old = contents(path);
  {
    const FileSizeLimit limit(old.size() + 3);
    const auto message = message_of<OutputError>([&] { ledger.append(std::array{1.0, 0.1}); });
    EXPECT_TRUE(has(message, "ledger.csv: cannot append: No space left on device")) << message;
  }
  EXPECT_EQ(contents(path), old);
  ledger.append(std::array{1.0, 0.2});
  EXPECT_EQ(read_ledger(path).rows.size(), 2u);
}

}  // namespace
}  // namespace bake

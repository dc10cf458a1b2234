// SPDX-License-Identifier: MIT
#include "solver/io/file_lock.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

bool is_free(const std::filesystem::path& file) {
  try {
    const FileLock lock(file);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(FileLock, KeepsOthersOutAndNamesItsProcess) {
  const TemporaryFolder folder;
  const FileLock lock(folder / "mark");
  const std::string message = message_of<InputError>([&] { FileLock(folder / "mark"); });
  EXPECT_TRUE(has(message, "a run of process " + std::to_string(::getpid()) + " writes here")) << message;
}

TEST(FileLock, StandsUntilItsFileIsRemovedOrReplaced) {
  const TemporaryFolder folder;
  const FileLock lock(folder / "mark");
  EXPECT_TRUE(lock.stands());
  std::filesystem::rename(folder / "mark", folder / "moved");
  EXPECT_FALSE(lock.stands());
  put(folder / "mark", "of another run");
  EXPECT_FALSE(lock.stands());
}

TEST(FileLock, IsGoneWithItsObject) {
  const TemporaryFolder folder;
  { const FileLock lock(folder / "mark"); }
  EXPECT_TRUE(std::filesystem::exists(folder / "mark"));
  EXPECT_TRUE(is_free(folder / "mark"));
}

TEST(FileLock, IsGoneWithItsProcessHoweverThatEnds) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    const FileLock lock(folder / "mark");
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(std::filesystem::exists(folder / "mark"));
  EXPECT_TRUE(is_free(folder / "mark"));
}

TEST(FileLock, ThatCannotBeMadeIsAnErrorOfOutput) {
  const TemporaryFolder folder;
  EXPECT_THROW(FileLock(folder / "nowhere/mark"), OutputError);
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
#include "solver/io/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/unit/io/files.h"

namespace bake {
namespace {

TEST(AtomicFile, HoldsExactlyTheTextItWasGiven) {
  const TemporaryFolder scratch;
  const std::string text("a\0b\r\n", 5);
  write_text_atomically(scratch / "note.txt", text);
  EXPECT_EQ(contents(scratch / "note.txt"), text);
  EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(AtomicFile, ReplacesAnOlderLongerFile) {
  const TemporaryFolder scratch;
  put(scratch / "note.txt", "a long text from yesterday");
  write_text_atomically(scratch / "note.txt", "new");
  EXPECT_EQ(contents(scratch / "note.txt"), "new");
}

TEST(AtomicFile, DoesNotPutAFileInPlaceOfAPipe) {
  const TemporaryFolder scratch;
  ASSERT_EQ(::mkfifo((scratch / "pipe").c_str(), 0600), 0);
  const std::string message = message_of<OutputError>([&] { AtomicFile(scratch / "pipe"); });
  EXPECT_TRUE(has(message, "pipe: found a device or a pipe, allowed: a file")) << message;
  EXPECT_TRUE(std::filesystem::is_fifo(scratch / "pipe"));
  EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(AtomicFile, LeavesTheOldFileAloneUntilItIsCommitted) {
  const TemporaryFolder scratch;
  put(scratch / "note.txt", "old");
  {
    AtomicFile file(scratch / "note.txt");
    file.write_at(0, std::as_bytes(std::span(std::string_view("half"))));
    EXPECT_EQ(contents(scratch / "note.txt"), "old");
  }
  EXPECT_EQ(contents(scratch / "note.txt"), "old");
  EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(AtomicFile, IsThereOncePutInPlace) {
  const TemporaryFolder scratch;
  AtomicFile file(scratch / "note.txt");
  file.write_at(0, std::as_bytes(std::span(std::string_view("new"))));
  file.put_in_place();
  EXPECT_EQ(contents(scratch / "note.txt"), "new");
  EXPECT_NO_THROW(flush_folder(scratch.path()));
  const auto message = message_of<OutputError>([&] { flush_folder(scratch / "missing"); });
  EXPECT_TRUE(has(message, "missing: what was written there cannot be flushed to disk: No such file or directory")) << message;
}

TEST(AtomicFile, EmptiesWhatAnInterruptedRunLeftAside) {
  const TemporaryFolder scratch;
  put(scratch / "note.txt.part", "left over by a crash");
  write_text_atomically(scratch / "note.txt", "new");
  EXPECT_EQ(contents(scratch / "note.txt"), "new");
  EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(AtomicFile, AnswersForAFolderThatIsNotThere) {
  const TemporaryFolder scratch;
  const auto message = message_of<OutputError>([&] { write_text_atomically(scratch / "missing/note.txt", "new"); });
  EXPECT_TRUE(has(message, "missing/note.txt: cannot create: No such file or directory")) << message;
}

TEST(AtomicFile, NeverReplacesAFolder) {
  const TemporaryFolder scratch;
  std::filesystem::create_directories(scratch / "note.txt/inside");
  const auto message = message_of<OutputError>([&] { write_text_atomically(scratch / "note.txt", "new"); });
  EXPECT_TRUE(has(message, "cannot put the new file in place: Is a directory")) << message;
  EXPECT_EQ(files_in(scratch.path()), 1u);
}

TEST(AtomicFile, AnswersForAFolderThatMayNotBeWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder scratch;
  std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const auto message = message_of<OutputError>([&] { write_text_atomically(scratch / "note.txt", "new"); });
  std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_all);
  EXPECT_TRUE(has(message, "Permission denied")) << message;
}

TEST(AtomicFile, RemembersTheFirstFailureOnly) {
  const TemporaryFolder scratch;
  put(scratch / "note.txt", "old");
  AtomicFile file(scratch / "note.txt");
  file.write_at(std::uint64_t{1} << 63, std::as_bytes(std::span(std::string_view("x"))));  // before the beginning
  file.write_at(0, std::as_bytes(std::span(std::string_view("x"))));
  const auto message = message_of<OutputError>([&] { file.commit(); });
  EXPECT_TRUE(has(message, "note.txt: cannot write: Invalid argument")) << message;
  EXPECT_EQ(contents(scratch / "note.txt"), "old");
}

}  // namespace
}  // namespace bake

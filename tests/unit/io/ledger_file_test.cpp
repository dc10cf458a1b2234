// SPDX-License-Identifier: MIT
#include "solver/io/ledger_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/scene/scene.h"
#include "tests/unit/io/files.h"

namespace bake {
namespace {

const std::vector<std::string> k_columns{"frame", "time_s", "water_kg"};

class ALedger : public testing::Test {
 protected:
  void write(int frames) {
    auto ledger = LedgerFile::create(path_, k_columns);
    for (int frame = 0; frame < frames; ++frame) ledger.append(row(frame));
  }
  static std::array<double, 3> row(int frame) { return {double(frame), frame / 24.0, 1.0 / (3 + frame)}; }
  const TemporaryFolder scratch_;
  const std::filesystem::path path_ = scratch_ / "ledger.csv";
};

TEST_F(ALedger, ComesBackBitForBit) {
  const std::vector<double> awkward{-0.0, 5e-324, 1.7976931348623157e308, INFINITY, -INFINITY, 0.1 + 0.2};
  {
    auto ledger = LedgerFile::create(path_, {"a", "b", "c", "d", "e", "f"});
    ledger.append(awkward);
    ledger.append(std::vector<double>(6, NAN));
  }
  const auto read = read_ledger(path_);
  EXPECT_EQ(read.columns, (std::vector<std::string>{"a", "b", "c", "d", "e", "f"}));
  ASSERT_EQ(read.rows.size(), 2u);
  EXPECT_TRUE(same_bits(read.rows[0], awkward));
  EXPECT_TRUE(std::isnan(read.rows[1][5]));
}

TEST_F(ALedger, OfAnOlderVersionIsReadUnderThePresentNamesWithOneLineOfNotice) {
  { auto ledger = LedgerFile::create(path_, {"time_s", "twist_x_kg_m2_per_s", "retired_heat_J"}); }
  testing::internal::CaptureStderr();
  EXPECT_EQ(read_ledger(path_).columns, (std::vector<std::string>{"time_s", "angular_impulse_x_kg_m2_per_s", "retired_heat_content_J"}));
  const std::string notice = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(notice.begin(), notice.end(), '\n'), 1) << notice;
  EXPECT_NE(notice.find("twist_x_kg_m2_per_s"), std::string::npos) << notice;
  EXPECT_EQ(present_column("time_s"), "time_s");
}

TEST_F(ALedger, ThatWasRemovedOrReplacedTakesNoMoreRows) {
  auto ledger = LedgerFile::create(path_, k_columns);
  ledger.append(row(0));
  std::filesystem::rename(path_, scratch_ / "elsewhere.csv");
  EXPECT_THROW(ledger.append(row(1)), OutputError);
  put(path_, contents(scratch_ / "elsewhere.csv"));
  EXPECT_THROW(ledger.append(row(1)), OutputError);
  std::filesystem::rename(scratch_ / "elsewhere.csv", path_);
  EXPECT_NO_THROW(ledger.append(row(1)));
}

TEST_F(ALedger, BeginsAnewOverAnOldFile) {
  write(5);
  write(0);
  EXPECT_EQ(contents(path_), "frame,time_s,water_kg\n");
}

TEST_F(ALedger, IsTheSameFileWhetherInterruptedOrNot) {
  write(6);
  const auto uninterrupted = contents(path_);
  write(5);  // the run went on to frame 4 after the checkpoint of frame 2, then stopped
  auto ledger = LedgerFile::resume(path_, k_columns, 2);
  for (int frame = 3; frame < 6; ++frame) ledger.append(row(frame));
  EXPECT_EQ(contents(path_), uninterrupted);
}

TEST_F(ALedger, LosesATornRowWhenResumed) {
  write(3);
  const auto whole = contents(path_);
  put(path_, whole + "3,0.125,0.1");
  EXPECT_EQ(read_ledger(path_).rows.size(), 3u);
  LedgerFile::resume(path_, k_columns, 9);
  EXPECT_EQ(contents(path_), whole);
}

TEST_F(ALedger, RefusesToResumeWithOtherColumns) {
  write(3);
  const auto message = message_of<InputError>([&] { LedgerFile::resume(path_, {"frame", "time_s"}, 2); });
  EXPECT_TRUE(has(message, "ledger.csv: its columns are not those of this run")) << message;
}

TEST_F(ALedger, RefusesRowsOfAnotherLength) {
  auto ledger = LedgerFile::create(path_, k_columns);
  EXPECT_THROW(ledger.append(std::array{1.0}), std::invalid_argument);
  EXPECT_EQ(contents(path_), "frame,time_s,water_kg\n");
}

TEST_F(ALedger, AnswersForFilesThatCannotBeReadOrWritten) {
  const auto read = message_of<InputError>([&] { read_ledger(path_); });
  EXPECT_TRUE(has(read, "ledger.csv: cannot open: No such file or directory")) << read;
  const auto resumed = message_of<InputError>([&] { LedgerFile::resume(path_, k_columns, 2); });
  EXPECT_TRUE(has(resumed, "ledger.csv: cannot open: No such file or directory")) << resumed;
  const auto created = message_of<OutputError>([&] { LedgerFile::create(scratch_ / "missing/ledger.csv", k_columns); });
  EXPECT_TRUE(has(created, "ledger.csv: cannot create: No such file or directory")) << created;
}

TEST_F(ALedger, NamesFileAndLineOfWhatIsWrong) {
  const auto refusal = [&](const char* text) {
    put(path_, text);
    return message_of<InputError>([&] { read_ledger(path_); });
  };
  EXPECT_TRUE(has(refusal(""), "ledger.csv: not a ledger: it has no heading line"));
  EXPECT_TRUE(has(refusal("a,b\n1,2\n1,x\n"), "ledger.csv:3: 'x' is not a number"));
  EXPECT_TRUE(has(refusal("a,b\n1,2x\n"), "ledger.csv:2: '2x' is not a number"));
  EXPECT_TRUE(has(refusal("a,b\n1\n"), "ledger.csv:2: 1 values, the heading has 2 columns"));
}

}  // namespace
}  // namespace bake

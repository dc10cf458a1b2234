// SPDX-License-Identifier: MIT
// Runs the real `bake` program as a user would.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace bake::test {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// A folder of its own for one test: the working folder of the program, with one small valid scene,
/// experiments/fig01_dough/dough.toml. Removed at the end.
class Workplace {
 public:
  Workplace();

  /// `arguments` as typed in a shell; `before` stands before the program's name (ulimit ...; or timeout ...).
  Outcome bake(const std::string& arguments, const std::string& before = "") const;
  void write(const std::filesystem::path& file, const std::string& text) const;
  const std::filesystem::path& folder() const { return folder_.path(); }
  /// From now on a copy of the program is called that stands in the folder bin/: what is put beside it is found beside it.
  void move_program_here();
  /// From now on this program is called.
  void use_program(const std::filesystem::path& program) { program_ = program; }
  std::string program_name() const { return program_.filename().string(); }

 private:
  std::filesystem::path program_ = BAKE_PROGRAM;
  TemporaryFolder folder_;
};

/// What succeeds says so on stdout and nothing on stderr.
void expect_success(const Workplace& place, const std::string& arguments, const std::string& said);

/// What fails is told in one line on stderr, which says why, and in nothing else. Wrong use (2) leaves no results. Returns the line.
std::string expect_refused(const Workplace& place, const std::string& arguments, const std::string& reason, const std::string& before = "",
                           int exit_code = 2);

}  // namespace bake::test

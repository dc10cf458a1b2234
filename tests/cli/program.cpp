// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace bake::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_dough = R"(title = "Dough at rest"
effects = ["motion", "elasticity"]

[run]
end_s = 0.01
frame_rate_per_s = 200

[grid]
dx_m = 0.01

[domain]
min_m = [0, 0, 0]
max_m = [0.2, 0.2, 0.2]

[[material]]
name = "dough"
density_kg_per_m3 = 1000
young_modulus_Pa = 1e4
poisson_ratio = 0.3

[[body]]
material = "dough"
shape = { box = { centre_m = [0.1, 0.1, 0.1], half_extents_m = [0.05, 0.05, 0.05] } }
)";

}  // namespace

Workplace::Workplace() { write("experiments/fig01_dough/dough.toml", k_dough); }

void Workplace::write(const fs::path& file, const std::string& text) const {
  fs::create_directories((folder() / file).parent_path());
  std::ofstream(folder() / file) << text;
}

void Workplace::move_program_here() {
  fs::create_directories(folder() / "bin");
  fs::copy_file(BAKE_PROGRAM, folder() / "bin/bake");
  program_ = folder() / "bin/bake";
}

Outcome Workplace::bake(const std::string& arguments, const std::string& before) const {
  const std::string command = fmt::format("cd '{}' && ({} '{}' {}) >.out 2>.err", folder().string(), before, program_.string(), arguments);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder() / ".out"), contents(folder() / ".err")};
}

void expect_success(const Workplace& place, const std::string& arguments, const std::string& said) {
  SCOPED_TRACE(fmt::format("{} {}", place.program_name(), arguments));
  const Outcome outcome = place.bake(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find(said), std::string::npos) << outcome.out;
}

std::string expect_refused(const Workplace& place, const std::string& arguments, const std::string& reason, const std::string& before,
                           int exit_code) {
  SCOPED_TRACE(fmt::format("{} {}", place.program_name(), arguments));
  const bool had_results = fs::exists(place.folder() / "results");
  const Outcome outcome = place.bake(arguments, before);
  EXPECT_EQ(outcome.exit_code, exit_code);
  EXPECT_TRUE(exit_code != 2 || fs::exists(place.folder() / "results") == had_results);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind(place.program_name() + ": ", 0), 0u) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  return outcome.err;
}

}  // namespace bake::test

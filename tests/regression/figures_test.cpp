// SPDX-License-Identifier: MIT
// Figures of the paper that need a simulation, made at draft by the real programs: which claims hold, and which are known not to.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

bool without_meshes() { return !std::filesystem::exists(std::filesystem::path(BAKE_PROGRAM).parent_path() / "bake-mesh"); }

/// A figure made in a folder of its own: exit code and claims.json.
class Made {
 public:
  Made(int number, const std::string& item) {
    const std::string command = fmt::format("cd '{}' && '{}' figure {} --quiet --no-pictures --threads 1 > out 2> errors",
                                            folder_.path().string(), BAKE_PROGRAM, number);
    const int status = std::system(command.c_str());
    exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    errors = contents(folder_ / "errors");
    item_ = folder_ / "results/items" / (item + "-draft");
    if (exit_code <= 1) claims = nlohmann::json::parse(contents(item_ / "claims.json"))["claims"];
  }
  /// The post-process of fracture at its last frame.
  nlohmann::json last_surface(const std::string& name) const {
    return nlohmann::json::parse(contents(item_ / name / "fracture.json"))["frames"].back();
  }
  int exit_code = -1;
  std::string errors;
  nlohmann::json claims;

 private:
  TemporaryFolder folder_;
  std::filesystem::path item_;
};

TEST(Figure15, LoavesExpandAndSlitsOpenButTheTopDoesNotCrack) {
  if (without_meshes()) GTEST_SKIP() << "bake-mesh is not built";
  const Made figure(15, "bread");
  ASSERT_LE(figure.exit_code, 1) << figure.errors;
  std::set<std::string> missed;
  for (const auto& claim : figure.claims)
    if (!claim["holds"].get<bool>()) missed.insert(claim["metric"].get<std::string>());
  // experiments/fig15_bread/README.md says why; should it hold one day, this line and that page are to be mended
  EXPECT_EQ(missed, (std::set<std::string>{"crack_share"}));
  EXPECT_EQ(figure.exit_code, 1);
  EXPECT_GE(figure.claims.size(), 6u);

  for (const char* name : {"surface_no", "surface_one", "surface_three"}) {
    SCOPED_TRACE(name);
    const auto surface = figure.last_surface(name);
    for (const auto& piece : surface["pieces"]) EXPECT_TRUE(piece["closed"].get<bool>());
  }
}

TEST(Figure16, LoafIsTornInTwo) {
  if (without_meshes()) GTEST_SKIP() << "bake-mesh is not built";
  const Made figure(16, "tearing");
  ASSERT_LE(figure.exit_code, 1) << figure.errors;
  for (const auto& claim : figure.claims) EXPECT_TRUE(claim["holds"].get<bool>()) << claim.dump(1);
  EXPECT_EQ(figure.exit_code, 0);
  EXPECT_GE(figure.claims.size(), 7u);
}

}  // namespace
}  // namespace bake

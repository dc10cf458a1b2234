// SPDX-License-Identifier: MIT
#include "solver/io/provenance.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <regex>

namespace bake {
namespace {

bool matches(const nlohmann::json& text, const char* pattern) { return std::regex_match(text.get<std::string>(), std::regex(pattern)); }

TEST(Provenance, NamesCommitOrSaysUnknown) {
  const auto program = provenance()["program"];
  EXPECT_TRUE(matches(program["commit"], "[0-9a-f]{40}|unknown")) << program;
  EXPECT_TRUE(program["dirty"].is_boolean() || program["commit"] == "unknown") << program;
}

TEST(Provenance, NamesCompilerFlagsAndLibraries) {
  const auto all = provenance();
  EXPECT_TRUE(matches(all["program"]["compiler"], "(clang|g\\+\\+) [0-9]+\\..*")) << all;
  EXPECT_TRUE(matches(all["program"]["flags"], ".*-fno-math-errno.*")) << all;
  for (const auto* library : {"hdf5", "eigen", "fmt"}) EXPECT_TRUE(matches(all["libraries"][library], "[0-9]+\\.[0-9]+\\.[0-9]+")) << all;
}

TEST(Provenance, DescribesTheMachineWithoutItsName) {
  const auto all = provenance();
  EXPECT_GT(all["machine"]["logical_cores"], 0);
  EXPECT_GT(all["machine"]["memory_bytes"], 1 << 20);
  EXPECT_FALSE(all["machine"]["cpu"].get<std::string>().empty());
  EXPECT_TRUE(matches(all["machine"]["os"], ".+, Linux .+")) << all;
  char host[256] = {};
  gethostname(host, sizeof host - 1);
  const std::regex as_a_word("(^|[^A-Za-z0-9_-])" + std::regex_replace(std::string(host), std::regex("[.]"), "\\.") + "([^A-Za-z0-9_-]|$)");
  EXPECT_FALSE(std::regex_search(all["machine"].dump(), as_a_word)) << all;
}

TEST(Provenance, IsDatedInUtc) { EXPECT_TRUE(matches(provenance()["date"], "20[0-9]{2}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z")); }

}  // namespace
}  // namespace bake

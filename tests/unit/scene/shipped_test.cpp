// SPDX-License-Identifier: MIT
// Scenes that come with Bake and say of each other what they share.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "solver/scene/reader.h"
#include "solver/scene/resolved.h"

namespace bake {
namespace {

nlohmann::json shipped(const std::string& name) { return resolved(read_scene(BAKE_SOURCE_DIR "/experiments/" + name + ".toml")); }

TEST(ShippedScene, TearIsBreadButForWhatItsFirstLinesSay) {
  std::set<std::string> differ;
  for (const auto& step : nlohmann::json::diff(shipped("fig15_bread/bread"), shipped("fig16_tearing/tear"))) differ.insert(step["path"]);
  EXPECT_EQ(differ, (std::set<std::string>{"/file", "/title", "/domain/min_m/0", "/domain/max_m/0", "/leavening/pores",
                                           "/material/0/viscosity_Pa_s/3", "/collider/0/until_s", "/collider/-", "/grip/-"}));
}

}  // namespace
}  // namespace bake

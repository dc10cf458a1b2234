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

/// The keys that differ between two scenes.
std::set<std::string> difference(const std::string& one, const std::string& other) {
  std::set<std::string> keys;
  for (const auto& step : nlohmann::json::diff(shipped(one), shipped(other))) keys.insert(step["path"]);
  return keys;
}

TEST(ShippedScene, TearIsBreadButForWhatItsFirstLinesSay) {
  EXPECT_EQ(difference("fig15_bread/bread", "fig16_tearing/tear"),
            (std::set<std::string>{"/file", "/title", "/domain/min_m/0", "/domain/max_m/0", "/leavening/pores",
                                   "/material/0/viscosity_Pa_s/3", "/collider/0/until_s", "/collider/-", "/grip/-"}));
}

TEST(ShippedScene, QuarterCookieIsDropCookieButForItsMirrors) {
  const auto keys = difference("fig03_cookies/drop_cookie", "fig03_cookies/quarter_cookie");
  EXPECT_EQ(keys, (std::set<std::string>{"/file", "/title", "/domain/min_m/0", "/domain/min_m/1", "/domain/x_min", "/domain/y_min",
                                         "/body/0/shape/sphere", "/body/0/shape/intersection"}));
}

}  // namespace
}  // namespace bake

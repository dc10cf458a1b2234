// SPDX-License-Identifier: MIT
// Scenes that come with Bake and say of each other what they share.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

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

/// Of `keys` those that neither `parts` of the scene hold.
std::set<std::string> outside(std::set<std::string> keys, const std::vector<std::string>& parts) {
  std::erase_if(keys, [&](const std::string& key) {
    return std::any_of(parts.begin(), parts.end(), [&](const std::string& part) { return key.starts_with(part); });
  });
  return keys;
}

/// A comparison of two models is fair if all but the models is alike.
const std::vector<std::string> k_laws = {"/file",
                                         "/title",
                                         "/effects",
                                         "/heat/water_specific_heat_J_per_kgK",
                                         "/leavening",
                                         "/water",
                                         "/material/0/initial_porosity",
                                         "/material/0/initial_saturation",
                                         "/material/0/expansion_per_K",
                                         "/material/0/transition",
                                         "/material/0/temperatures_C",
                                         "/material/0/yield_stress_Pa",
                                         "/material/0/viscosity_Pa_s",
                                         "/material/0/diffusivity",
                                         "/material/0/evaporation",
                                         "/material/0/pressure_Pa",
                                         "/material/0/production",
                                         "/material/0/leavener",
                                         "/material/0/peak_temperature_C",
                                         "/material/0/temperature_width_K"};

TEST(ShippedScene, MeltingCookieIsQuarterCookieButForItsLawsInertiaAndSteps) {
  EXPECT_EQ(outside(difference("fig03_cookies/quarter_cookie", "fig17_cookies_compared/quarter_melting_cookie"), k_laws),
            (std::set<std::string>{"/motion/inertia_scale", "/time/safety"}));
}

TEST(ShippedScene, MeltingBatterIsPancakeButForItsLawsTheTossAndSteps) {
  const auto keys = outside(difference("fig11_pancake/pancake", "fig19_pancake_compared/melting_batter"), k_laws);
  EXPECT_EQ(outside(keys, {"/collider/0/motion", "/collider/0/pivot_m"}), (std::set<std::string>{"/run/end_s", "/time/safety"}));
}

}  // namespace
}  // namespace bake

// SPDX-License-Identifier: MIT
// A run whose dough settles first says so, in its summary and its ledger.
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/io/ledger_file.h"
#include "solver/run/run.h"
#include "solver/scene/scene_builder.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// A weightless elastic ball that flies with 0.1 m/s.
RunSummary run(const TemporaryFolder& folder, const std::string& settling) {
  SceneBuilder builder;
  builder.effects = "motion, elasticity";
  builder.frame_s = 1e-3;
  builder.motion = settling;
  builder.material = "density_kg_per_m3 = 500\nyoung_modulus_Pa = 1e4";
  builder.shape = "sphere = { radius_m = 0.25 }";
  builder.body = "velocity_m_per_s = [0.1, 0, 0]";
  RunOptions options;
  options.out = folder / "run";
  options.quiet = true;
  options.frames = 2;
  options.replace = Replace::any_run;
  return run_scene(builder.scene(), options);
}

TEST(ARunThatSettles, SaysForHowLongAndWhatItTook) {
  const TemporaryFolder folder;
  const std::string text = run(folder, "settle_damping_per_s = 50\nsettle_still_m_per_s = 0.01").text;
  EXPECT_NE(text.find("  settled      for 0.07"), std::string::npos) << text;  // ln 10 / 50 + 1 / 50 = 0.066 s, and a step
  EXPECT_NE(text.find("J damped; then it was still"), std::string::npos) << text;
  const Ledger ledger = read_ledger(folder / "run/ledger.csv");
  const auto value = [&](std::size_t row, const char* column) {
    const auto found = std::find(ledger.columns.begin(), ledger.columns.end(), column);
    return ledger.rows.at(row).at(static_cast<std::size_t>(found - ledger.columns.begin()));
  };
  EXPECT_EQ(value(0, "settling_time_s"), 0) << "frame 0 is the dough as it was put";
  EXPECT_EQ(value(0, "damped_J"), 0);
  EXPECT_NEAR(value(1, "time_s"), 1e-3, 1e-12) << "it takes none of the scene's time";
  EXPECT_NEAR(value(1, "damped_J"), value(0, "kinetic_J"), 0.01 * value(0, "kinetic_J"));
  EXPECT_EQ(value(2, "damped_J"), value(1, "damped_J"));
}

TEST(ARunThatSettles, SaysSoIfTheDoughIsNotStillInTheEnd) {
  const TemporaryFolder folder;
  const std::string text = run(folder, "settle_damping_per_s = 50\nsettle_longest_s = 0.02").text;
  EXPECT_NE(text.find("it was NOT still then: see motion.settle_longest_s"), std::string::npos) << text;
}

TEST(ARunThatDoesNotSettle, SaysNothingOfIt) {
  const TemporaryFolder folder;
  EXPECT_EQ(run(folder, "").text.find("settled"), std::string::npos);
}

}  // namespace
}  // namespace bake

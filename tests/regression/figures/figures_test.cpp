// SPDX-License-Identifier: MIT
// Figures of the paper that need a simulation, made at draft by the real programs: which claims hold, which are known not to, and
// whether every picture is drawn. The pictures are small: what costs minutes is samples and pixels, which change no other step.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <Eigen/Core>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "analysis/image/image.h"
#include "experiments/make/figure_file.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

constexpr int k_width = 240, k_height = 180, k_samples = 4;

/// The mean sRGB of the pixels for which `counts(x, y)`, from 0 to 255.
template <class Counts>
Eigen::Vector3d mean_colour(const Image& image, Counts counts) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double pixels = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (counts(x, y)) {
        const auto& [r, g, b] = image.at(x, y);
        sum += Eigen::Vector3d(r, g, b);
        ++pixels;
      }
  return sum / pixels;
}

/// A figure made in a folder of its own: exit code, claims.json, pictures.
class Made {
 public:
  /// `sharing`: a figure in whose folder it is made, to use its runs again.
  Made(int number, const std::string& item, const Made* sharing = nullptr) : Made(std::to_string(number), item, sharing) {}
  Made(const std::string& asked, const std::string& item, const Made* sharing = nullptr)
      : home_(sharing ? sharing->home_ : std::make_shared<TemporaryFolder>()), folder_(*home_) {
    const std::string command = fmt::format("cd '{}' && '{}' figure {} --quiet --size {}x{} --samples {} --threads 1 > out 2> errors",
                                            folder_.path().string(), BAKE_PROGRAM, asked, k_width, k_height, k_samples);
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
  /// What the claims that do not hold have at these keys.
  std::set<std::string> missed(const std::vector<const char*>& keys) const {
    std::set<std::string> names;
    for (const auto& claim : claims) {
      if (claim["holds"].get<bool>()) continue;
      std::vector<std::string> words;
      for (const char* key : keys) words.push_back(claim[key].get<std::string>());
      names.insert(fmt::format("{}", fmt::join(words, " ")));
    }
    return names;
  }
  Image picture(const std::string& name) const { return read_png(item_ / (name + ".png")); }

  int exit_code = -1;
  std::string errors;
  nlohmann::json claims;

 private:
  std::shared_ptr<TemporaryFolder> home_;
  const TemporaryFolder& folder_;
  std::filesystem::path item_;
};

/// Every picture that the figure's file names is there, as large as asked for, and shows something in front of something else.
void check_pictures(const Made& made, const char* experiment) {
  const Figure figure = read_figure(std::filesystem::path(BAKE_SOURCE_DIR) / "experiments" / experiment / "figure.toml");
  EXPECT_FALSE(figure.pictures.empty());
  for (const FigurePicture& asked : figure.pictures) {
    SCOPED_TRACE(asked.name);
    const Image image = made.picture(asked.name);
    ASSERT_EQ(image.width, k_width);
    ASSERT_EQ(image.height, k_height);
    const auto in_the_middle = [](int x, int y) {
      return std::abs(2 * x - k_width) < k_width / 2 && std::abs(2 * y - k_height) < k_height / 2;
    };
    const auto at_the_rim = [](int x, int y) { return x < 8 || y < 8 || x >= k_width - 8 || y >= k_height - 8; };
    const Eigen::Vector3d contrast = mean_colour(image, in_the_middle) - mean_colour(image, at_the_rim);
    EXPECT_GT(contrast.cwiseAbs().maxCoeff(), 10);
  }
}

/// The claims that do not come out are those of these metrics; each item's README says why. There are at least so many claims in all.
void check_claims(const Made& made, const std::set<std::string>& expected_to_miss, std::size_t at_least) {
  ASSERT_LE(made.exit_code, 1) << made.errors;
  std::set<std::string> missed;
  for (const auto& claim : made.claims) {
    if (claim["holds"].get<bool>()) continue;
    const auto metric = claim["metric"].get<std::string>();
    missed.insert(metric);
    EXPECT_TRUE(expected_to_miss.count(metric)) << claim.dump(1);
  }
  EXPECT_EQ(missed, expected_to_miss);
  EXPECT_EQ(made.exit_code, expected_to_miss.empty() ? 0 : 1);
  EXPECT_GE(made.claims.size(), at_least);
}

TEST(LongFigure1, AMontageShowsOnlyWhatHolds) {
  const Made figure(1, "montage");
  check_claims(figure, {}, 5);
  const Image montage = figure.picture("montage");
  EXPECT_GT(montage.width, 1600);
  for (const auto& [x, y] : {std::pair{0.12, 0.25}, {0.12, 0.75}, {0.5, 0.5}, {0.88, 0.25}, {0.88, 0.75}}) {  // the middles of its tiles
    const auto in_the_tile = [&, x = x, y = y](int u, int v) {
      return std::abs(u - x * montage.width) < 60 && std::abs(v - y * montage.height) < 60;
    };
    const auto background = [](int u, int v) { return u > 440 && u < 460 && v < 20; };  // of the tile in the middle
    const Eigen::Vector3d contrast = mean_colour(montage, in_the_tile) - mean_colour(montage, background);
    EXPECT_GT(contrast.cwiseAbs().maxCoeff(), 10) << x << ", " << y;
  }
}

TEST(LongFigure2, AMuffinRisesToADomeItsChipsMeltAndItIsTornInTwoButDrawnOutWhereItTears) {
  const Made figure(2, "muffin");
  check_claims(figure, {"pieces_volume"}, 14);
  check_pictures(figure, "fig02_muffin");
}

TEST(LongFigure3, CookiesFallWithLeavenerAndSpreadInACoolOven) {
  const Made figure(3, "cookies");
  check_claims(figure, {}, 37);
  check_pictures(figure, "fig03_cookies");
}

TEST(Figure6, NeckAndTwistAreMonotoneInYieldStressAndViscosity) {
  const Made figure(6, "dough");
  check_claims(figure, {}, 40);
  check_pictures(figure, "fig06_dough");
}

TEST(Figure4, ACakeFlowsOutOfItsCentreAndOneThatBakedLongerDoesNot) {
  const Made figure(4, "lava_cake");
  check_claims(figure, {}, 10);
  check_pictures(figure, "fig04_lava_cake");
}

TEST(Figures9And10, GrapesDryFromOutsideAndTheirSkinsFold) {
  const Made grapes(9, "grapes");
  check_claims(grapes, {}, 12);
  check_pictures(grapes, "fig09_grapes");
  const Made saturation(10, "saturation", &grapes);
  check_claims(saturation, {}, 3);
  check_pictures(saturation, "fig10_saturation");
}

TEST(Figure13, SlicesOfApplesBuckleTheThinnestFirstAndTheControlStaysFlat) {
  const Made figure(13, "apple_slices");
  check_claims(figure, {}, 20);
  check_pictures(figure, "fig13_apple_slices");
}

TEST(Figure11, BatterIsPouredCooksFromBelowAndIsFlippedInOnePiece) {
  const Made figure(11, "pancake");
  check_claims(figure, {}, 13);
  check_pictures(figure, "fig11_pancake");
}

TEST(Figure18, ARawMarshmallowSpringsBackAndOneWithACrustBreaksAndOozes) {
  const Made figure(18, "marshmallow");
  check_claims(figure, {}, 16);
  check_pictures(figure, "fig18_marshmallow");
}

TEST(Figure5, AMarshmallowSwellsCrustsAndFlowsOutBetweenCrackers) {
  const Made figure(5, "smore");
  check_claims(figure, {}, 7);
  check_pictures(figure, "fig05_smore");
}

TEST(Figure15, LoavesExpandAndSlitsOpenButTheTopDoesNotCrack) {
  const Made figure(15, "bread");
  check_claims(figure, {"crack_share"}, 6);  // should it hold one day, this line and the README are to be mended

  for (const char* name : {"surface_no", "surface_one", "surface_three"}) {
    SCOPED_TRACE(name);
    const auto surface = figure.last_surface(name);
    for (const auto& piece : surface["pieces"]) EXPECT_TRUE(piece["closed"].get<bool>());
  }
  check_pictures(figure, "fig15_bread");
}

TEST(Figure16, LoafIsTornInTwo) {
  const Made figure(16, "tearing");
  check_claims(figure, {}, 7);
  check_pictures(figure, "fig16_tearing");
}

TEST(LongFigure17, CookiesAreDomedAndThoseThatMeltAndSetAreFlat) {
  const Made figure(17, "cookies_compared");
  check_claims(figure, {}, 11);
  check_pictures(figure, "fig17_cookies_compared");
}

TEST(LongMeltingScan, NoChoiceOfMeltingAndSettingGivesADome) {
  const Made figure("melting_scan", "melting_scan");
  check_claims(figure, {}, 27);
}

TEST(Figure19, AFluidSpreadsOverTheRimOfThePanAndBatterDoesNot) {
  const Made figure(19, "pancake_compared");
  check_claims(figure, {}, 9);
  check_pictures(figure, "fig19_pancake_compared");
}

/// Claims are known by metric and run here, since most compare one metric with measurements.
TEST(ValidationOfDrying, FollowsMeasuredCurvesOfApplesAndTimesOfGrapesButNotForEveryThicknessAndTemperature) {
  const Made made("validation_drying", "validation_drying");
  ASSERT_LE(made.exit_code, 1) << made.errors;
  const std::set<std::string> expected_to_miss{"slice_26rh", "slice_45c", "slice_40c", "slice_40c_as_printed",
                                               "slice_4mm",  "slice_8mm", "slice_10mm"};
  EXPECT_EQ(made.missed({"of"}), expected_to_miss);  // the README says why
  EXPECT_GE(made.claims.size(), 20);
}

/// Fick's law alone neither warms the core nor the surface as measured, nor loses the water at the measured pace. The width is missed with
/// vapour, too: the README says why.
TEST(LongValidationOfBread, FollowsTheMeasuredLoafWithVapourInItsPoresAndNotByFicksLaw) {
  const Made made("validation_bread", "validation_bread");
  ASSERT_LE(made.exit_code, 1) << made.errors;
  const std::set<std::string> expected_to_miss{"loaf_by_fick temperature_at", "loaf_by_fick surface_temperature", "loaf_by_fick water_left",
                                               "loaf_with_vapour distance_gain"};
  EXPECT_EQ(made.missed({"of", "metric"}), expected_to_miss);
  EXPECT_GE(made.claims.size(), 15);
}

/// Hotter ovens spread biscuits sooner, cooler ones farther, and hard wheat less, all as measured; the README says why the rest is missed.
TEST(LongValidationOfBiscuits, SpreadAsMeasuredOfTwoFloursAndInThreeOvensButNeitherShrinkNorDryAsMuch) {
  const Made made("validation_biscuits", "validation_biscuits");
  ASSERT_LE(made.exit_code, 1) << made.errors;
  const std::set<std::string> expected_to_miss{"biscuit_185 diameter_kept",  "biscuit_185 time_to_spread", "biscuit_205 diameter_kept",
                                               "biscuit_205 time_to_spread", "biscuit_205 water_left",     "biscuit_225 diameter_kept",
                                               "biscuit_225 time_to_spread", "biscuit_hard time_to_spread"};
  EXPECT_EQ(made.missed({"of", "metric"}), expected_to_miss);
  EXPECT_GE(made.claims.size(), 40);
}

}  // namespace
}  // namespace bake

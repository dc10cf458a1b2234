// SPDX-License-Identifier: MIT
// Metrics of what dries in a skin, on meshes, frames and ledgers that are written by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/claims/metric.h"
#include "solver/core/errors.h"
#include "solver/io/frames.h"
#include "solver/io/mesh_file.h"
#include "tests/unit/claims/written_run.h"

namespace bake {
namespace {

/// Five frames: the water halves from one to the next, the volume falls to an eighth, the skin keeps most of its area.
class SkinMetrics : public WrittenRun {
 protected:
  SkinMetrics()
      : WrittenRun(R"({"summary": {"state": "done"}, "scene": {"quality": "draft", "grid": {"dx_m": 0.125}}})",
                   "time_s,water_mass_kg,volume_m3,skin_area_m2,height_m\n0,16,8,6,1\n1,8,6,6,1\n2,4,4,5,1\n3,2,2,5,2\n4,0.5,1,4.5,1.5\n") {
    std::filesystem::create_directories(folder_ / "skins");
  }
  /// A square of 1 m and a triangle of half of it beside; `at_square` and `at_tip` are values at the corners of the square and at the tip.
  void skin(int number, const std::string& field, double at_square, double at_tip) const {
    Mesh mesh;
    mesh.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0};
    mesh.cells = {0, 1, 2, 0, 2, 3, 1, 4, 2};
    mesh.fields = {{field, "1", 1, {at_square, at_square, at_square, at_square, at_tip}}};
    mesh.time_s = number;
    write_mesh(folder_ / "skins" / frame_name(number), mesh);
  }
  void flesh(int number, const std::vector<float>& places, const std::vector<float>& saturation,
             const std::vector<std::int64_t>& ids) const {
    write_frame(folder_ / "frames" / frame_name(number), number, {places, {{"saturation", "1", saturation}, {"id", "1", ids}}});
  }
};

MetricPlace at(double time_s) { return {.time_s = time_s}; }

TEST_F(SkinMetrics, CompareTheSkinWithTheVolumeInIt) {
  EXPECT_DOUBLE_EQ(measure("skin_area_gain", {}), 0.75);
  EXPECT_DOUBLE_EQ(measure("skin_area_gain", at(1)), 1);
  EXPECT_DOUBLE_EQ(measure("skin_slack", {}), 0.75 / 0.25);
  EXPECT_DOUBLE_EQ(measure("skin_slack", at(0)), 1);
}

TEST_F(SkinMetrics, TakeTheCurvatureOverTheArea) {
  skin(4, "curvature", 3, 6);  // of nine thirds of a triangle one is the tip's
  EXPECT_NEAR(measure("skin_curvature", {}), std::sqrt((8 * 9 + 36) / 9.), 1e-6);
  skin(0, "curvature", 0, 0);
  EXPECT_EQ(measure("skin_curvature", at(0)), 0);
  skin(4, "curvature", 3, std::nan(""));
  EXPECT_FALSE(bake::measure(find_metric("skin_curvature"), Results(folder_.path()), {}).is_number());
  skin(4, "area_ratio", 1, 1);
  EXPECT_THROW(measure("skin_curvature", {}), InputError);
}

TEST_F(SkinMetrics, FindWhatIsGoneWhenFoldsBegin) {
  const double curvatures[] = {0, 1, 2, 8, 20};  // 15 % of the last is 3, a sixth of the way from 2 to 8
  for (int i = 0; i < 5; ++i) skin(i, "curvature", curvatures[i], curvatures[i]);
  EXPECT_NEAR(measure("fold_onset", {}), 1 - (4 - 2. / 6) / 16, 1e-6);
  for (int i = 0; i < 5; ++i) skin(i, "curvature", 1, 1);
  EXPECT_TRUE(std::isnan(measure("fold_onset", {}))) << "what is folded from the start has no onset";
}

TEST_F(SkinMetrics, FindTheShareOfVerticesThatHaveNoFlesh) {
  skin(4, "curvature", 0, 0);
  flesh(4, {0, 0, 0.4f, 1, 0, -0.4f, 1, 1.3f, 0.3f, -0.2f, 1, 0}, {1, 1, 1, 1}, {1, 2, 3, 4});  // the tip at x = 2 has none within dx
  EXPECT_DOUBLE_EQ(measure("skin_off_flesh", {}), 0.2);
  flesh(4, {0, 0, 0.6f, 1, 0, -0.4f, 1, 1.3f, 0.3f, -0.2f, 1, 0}, {1, 1, 1, 1}, {1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(measure("skin_off_flesh", {}), 0.4);
}

TEST_F(SkinMetrics, CompareTheSkinsWaterWithThatOfWhatStartedInside) {
  skin(4, "saturation", 0.2, 0.5);
  flesh(0, {0, 0, 0, 5, 0, 0, 6, 0, 0}, {1, 1, 1}, {7, 8, 9});
  flesh(4, {0, 0, 0, 0, 0, 0, 5, 0, 0}, {0.6f, 0.8f, 0.1f}, {9, 8, 7});  // those that are inside now started elsewhere
  MetricPlace core{.low_m = Vector3{4, -1, -1}, .high_m = Vector3{7, 1, 1}};
  EXPECT_NEAR(measure("skin_dryness", core), (0.2 * 8 + 0.5) / 9 / 0.7, 1e-6);
  core.low_m = Vector3{10, 10, 10};
  core.high_m = Vector3{11, 11, 11};
  EXPECT_TRUE(std::isnan(measure("skin_dryness", core))) << "nothing started there";
}

TEST_F(SkinMetrics, CompareTheHeightWithThatOfEvenShrinkage) {
  EXPECT_DOUBLE_EQ(measure("height_over_thickness", {}), 1.5 / 0.5);
  EXPECT_DOUBLE_EQ(measure("height_over_thickness", at(0)), 1);
}

TEST_F(SkinMetrics, TellHowStraightTheLogarithmOfTheWaterIs) {
  EXPECT_NEAR(measure("drying_straightness", {}), 1, 1e-12) << "it halves each second; the last one, 0.03, is left out";
  EXPECT_DOUBLE_EQ(measure("water_left", {}), 0.5 / 16);
  EXPECT_DOUBLE_EQ(measure("water_left", at(2)), 0.25);
}

class BentDrying : public WrittenRun {
 protected:
  BentDrying() : WrittenRun(R"({"summary": {"state": "done"}})", "time_s,water_mass_kg\n0,1\n1,0.9\n2,0.2\n") {}
};

TEST_F(BentDrying, IsAsFarFromMeasuredPointsAsTheRootMeanSquareOfItsDifferences) {
  const Results run(folder_.path());
  const Metric& water_left = find_metric("water_left");
  EXPECT_DOUBLE_EQ(distance(water_left, run, {}, {0, 1, 2}, {1, 0.9, 0.2}).value, 0);
  EXPECT_DOUBLE_EQ(distance(water_left, run, {}, {1, 2}, {0.9 - 0.03, 0.2 + 0.04}).value, 0.05 / std::sqrt(2.));
  EXPECT_FALSE(distance(water_left, run, {}, {1, 7}, {0.9, 0.1}).is_number()) << "there is no frame at 7 s";
}

TEST_F(BentDrying, IsLessStraight) {
  // y = 0, ln 0.9, ln 0.2 at -1, 0, 1
  const double a = std::log(0.9), b = std::log(0.2), mean = (a + b) / 3;
  const double all = mean * mean + (a - mean) * (a - mean) + (b - mean) * (b - mean);
  EXPECT_NEAR(measure("drying_straightness", {}), b * b / 2 / all, 1e-12);
  EXPECT_LT(measure("drying_straightness", {}), 0.9);
}

/// A ball of 30 cm that became an egg, with waves cos(10 phi) sin^10(theta): a spherical harmonic of degree 10, of wave number sqrt(110) /
/// R.
TEST_F(SkinMetrics, CountTheWavelengthOfFoldsAtRest) {
  constexpr int k_rings = 60, k_spokes = 120;
  constexpr double k_radius = 0.3;
  const auto ball = [&](int number, auto along_normal) {
    Mesh mesh;
    const auto add = [&](double theta, double phi) {
      const double r = k_radius + along_normal(theta, phi);
      mesh.points.insert(mesh.points.end(),
                         {r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi), r * std::cos(theta)});
    };
    const double pi = std::acos(-1);
    add(0, 0);
    for (int i = 1; i < k_rings; ++i)
      for (int j = 0; j < k_spokes; ++j) add(pi * i / k_rings, 2 * pi * j / k_spokes);
    add(pi, 0);
    const auto vertex = [&](int i, int j) -> std::int64_t {
      return i == 0 ? 0 : i == k_rings ? 1 + (k_rings - 1) * k_spokes : 1 + (i - 1) * k_spokes + j % k_spokes;
    };
    for (int i = 0; i < k_rings; ++i)
      for (int j = 0; j < k_spokes; ++j) {
        if (i > 0) mesh.cells.insert(mesh.cells.end(), {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + 1 < k_rings) mesh.cells.insert(mesh.cells.end(), {vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
      }
    mesh.time_s = number;
    write_mesh(folder_ / "skins" / frame_name(number), mesh);
  };
  ball(0, [](double, double) { return 0; });
  ball(4, [](double theta, double phi) {
    const double z = std::cos(theta);
    return -0.05 + 0.03 * z * z * z + 0.002 * std::pow(std::sin(theta), 10) * std::cos(10 * phi);
  });
  EXPECT_NEAR(measure("fold_wavelength", {}), 2 * std::acos(-1) * k_radius / std::sqrt(110), 0.002);
}

}  // namespace
}  // namespace bake

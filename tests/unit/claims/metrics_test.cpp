// SPDX-License-Identifier: MIT
// Metrics of frames and of fracture surfaces, on results that are written by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/core/errors.h"
#include "tests/unit/claims/written_run.h"

namespace bake {
namespace {

class FrameMetrics : public WrittenRun {
 protected:
  FrameMetrics() : WrittenRun(R"({"summary": {"state": "done"}})", "time_s,surface_m2\n0,1\n1,2\n2,2\n") {}
};

MetricPlace between(const Vector3& from, const Vector3& to) { return {.from_m = from, .to_m = to}; }

TEST_F(FrameMetrics, FollowTheSameParticlesInAnyOrder) {
  frame(0, {{7, {0, 0, 0}}, {8, {1, 0, 0}}, {9, {5, 0, 0}}});
  frame(1, {{9, {5, 0, 0}}, {8, {2, 0, 0}}, {7, {0, 0, 0}}});
  frame(2, {{8, {3, 0, 0}}, {9, {5, 0, 0}}, {7, {0, 0, 0}}});
  MetricPlace place = between({0.1, 0, 0}, {1.2, 0, 0});
  EXPECT_DOUBLE_EQ(measure("distance_gain", place), 3);
  place.time_s = 1.1;
  EXPECT_DOUBLE_EQ(measure("distance_gain", place), 2) << "of the nearest frame";
  EXPECT_TRUE(std::isnan(measure("distance_gain", between({0, 0, 0}, {0.1, 0, 0})))) << "one particle has no distance";
}

TEST_F(FrameMetrics, RefuseFramesOfAnotherRun) {
  frame(0, {{7, {0, 0, 0}}, {8, {1, 0, 0}}});
  frame(2, {{107, {0, 0, 0}}, {108, {1, 0, 0}}});
  const std::string message = message_of<InputError>([&] { measure("distance_gain", between({0, 0, 0}, {1, 0, 0})); });
  EXPECT_NE(message.find("0002.hdf: found no particle 7, allowed: frames of one run"), std::string::npos) << message;
}

TEST_F(FrameMetrics, FindTemperaturesAndWhenTheyAreReached) {
  frame(0, {{1, {0, 0, 0}, 20}, {2, {1, 0, 0}, 20}});
  frame(1, {{2, {1, 0, 0}, 60}, {1, {0, 0, 0}, 90}});
  frame(2, {{1, {0, 0, 0}, 95}, {2, {1, 0, 0}, 80}});
  const Vector3 point{0.9, 0, 0};
  EXPECT_EQ(measure("temperature_at", {.point_m = point}), 80);
  EXPECT_EQ(measure("time_to_reach", {.point_m = point, .temperature_C = 60}), 1);
  EXPECT_EQ(measure("time_to_reach", {.point_m = point, .temperature_C = 81}), k_infinity);
}

TEST_F(FrameMetrics, TellHowMuchHotterTheSurfaceIs) {
  frame(0, {{1, {0, 0, 0}, 20}, {2, {1, 0, 0}, 20}});
  frame(1, {{2, {1, 0, 0}, 60}, {1, {0, 0, 0}, 45}});
  frame(2, {{1, {0, 0, 0}, 95}, {2, {1, 0, 0}, 80}});
  MetricPlace place = between({0.9, 0, 0}, {0.1, 0, 0});
  EXPECT_EQ(measure("temperature_lead", place), -15);
  place.time_s = 1;
  EXPECT_EQ(measure("temperature_lead", place), 15);
}

class SurfaceTemperature : public WrittenRun {
 protected:
  explicit SurfaceTemperature(const std::string& oven = "190", const std::string& collider = "null")
      : WrittenRun(R"({"summary": {"state": "done"}, "scene": {"oven": {"heat_transfer_coefficient_W_per_m2K": 10, "temperature_C": )" +
                       oven + R"(}, "collider": [{"temperature_C": )" + collider + "}]}}",
                   "time_s,surface_m2,heat_exchanged_J\n0,2,0\n2,2,4000\n6,4,12000\n") {}
};
class SurfaceTemperatureInAnOvenThatWarms : public SurfaceTemperature {
 protected:
  SurfaceTemperatureInAnOvenThatWarms() : SurfaceTemperature("[[0, 20], [1, 190]]") {}
};
class SurfaceTemperatureOnAHotTray : public SurfaceTemperature {
 protected:
  SurfaceTemperatureOnAHotTray() : SurfaceTemperature("190", "180") {}
};

TEST_F(SurfaceTemperature, IsWhatTheHeatThatCameInAsksFor) {
  EXPECT_DOUBLE_EQ(measure("surface_temperature", {.time_s = 2}), 190 - 12000. / (10 * 2 * 6)) << "from the frames around";
  EXPECT_DOUBLE_EQ(measure("surface_temperature", {.time_s = 0}), 190 - 4000. / (10 * 2 * 2));
  EXPECT_DOUBLE_EQ(measure("surface_temperature", {}), 190 - 8000. / (10 * 4 * 4));
}
TEST_F(SurfaceTemperatureInAnOvenThatWarms, IsRefused) { EXPECT_THROW(measure("surface_temperature", {}), InputError); }
TEST_F(SurfaceTemperatureOnAHotTray, IsRefused) { EXPECT_THROW(measure("surface_temperature", {}), InputError); }

TEST_F(FrameMetrics, FollowTheWaterOfAParticle) {
  frame(0, {{1, {0, 0, 0}, 20, 20, 1, 4}, {2, {1, 0, 0}, 20, 20, 1, 2}, {3, {2, 0, 0}, 20, 20, 1, 0}});
  frame(2, {{2, {0, 0, 0}, 20, 20, 1, 3}, {3, {2, 0, 0}, 20, 20, 1, 1}, {1, {1, 0, 0}, 20, 20, 1, 1}});
  EXPECT_DOUBLE_EQ(measure("water_at", {.point_m = Vector3{0.9, 0, 0}}), 1.5) << "of the particle, not of the place";
  EXPECT_DOUBLE_EQ(measure("water_at", {.point_m = Vector3{0, 0, 0}}), 0.25);
  EXPECT_DOUBLE_EQ(measure("water_at", {.point_m = Vector3{0, 0, 0}, .time_s = 0}), 1);
  EXPECT_TRUE(std::isnan(measure("water_at", {.point_m = Vector3{2, 0, 0}}))) << "it had none";
}

TEST_F(FrameMetrics, ShareVolumesNotParticles) {
  frame(0, {{1, {-1, 0, 0}}, {2, {1, 0, 0}}});
  frame(2, {{1, {-1, 0, 0}, 20, 70, 1}, {2, {3, 0, 0}, 20, 90, 3}});
  EXPECT_DOUBLE_EQ(measure("heated_share", {.temperature_C = 80}), 0.75);
  EXPECT_DOUBLE_EQ(measure("outflow", {.radius_m = 2}), 0.75);
}

/// A slab under 2 m^2 of air, in layers that are not equally wet: once dry, exp(-z / l) of the water at depth z is gone.
std::vector<Dot> slab(int layers, double thickness, double l, bool dry) {
  std::vector<Dot> dots;
  for (int i = 0; i < layers; ++i) {
    const double z = thickness * (i + 0.5) / layers, share_left = dry ? 1 - std::exp(-z / l) : 1;
    Dot dot{i, {0, 0, z}};
    dot.volume = static_cast<float>(2 * thickness / layers);
    dot.water = static_cast<float>((1 + i % 3) * share_left);
    dots.push_back(dot);
  }
  if (dry) std::reverse(dots.begin(), dots.end());  // frames are in any order
  return dots;
}

TEST_F(FrameMetrics, FindTheThicknessOfACrust) {
  constexpr double thickness = 0.1, l = 0.02, share = 0.2;
  // all of it where more than 0.3 are lost, down to l ln(1 / 0.3); then in proportion, until 0.1 are
  const double full = l * std::log(1 / 0.3), edge = l * (0.3 - 0.1) / share - 0.5 * l * std::log(3);
  for (const int layers : {500, 20}) {
    frame(0, slab(layers, thickness, l, false));
    frame(2, slab(layers, thickness, l, true));
    EXPECT_NEAR(measure("crust_thickness", {.dried_share = share}), full + edge, layers == 500 ? 1e-6 : 4e-4) << layers << " layers";
  }
  EXPECT_EQ(measure("crust_thickness", {.dried_share = share, .time_s = 0}), 0) << "at the start nothing is dry";
}

TEST_F(FrameMetrics, RefuseACrustOfWhatWasPoured) {
  frame(0, {{1, {0, 0, 0}}});
  frame(2, {{1, {0, 0, 0}}, {2, {1, 0, 0}}});
  EXPECT_THROW(measure("crust_thickness", {.dried_share = 0.1}), InputError);
}

/// z = 1 - kappa r^2 / 2 on top of a block of lower particles, off the origin.
std::vector<Dot> dome(double kappa) {
  std::vector<Dot> dots;
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j) {
      const double x = 0.05 * i, y = 0.05 * j;
      for (const double depth : {0.0, 0.3}) {
        const auto id = static_cast<std::int64_t>(dots.size());
        dots.push_back({id, {3 + x, 4 + y, 1 - kappa * (x * x + y * y) / 2 - depth}});
      }
    }
  return dots;
}

TEST_F(FrameMetrics, TellADomeFromADent) {
  const MetricPlace place{.radius_m = 0.9};
  for (const double kappa : {0.5, -0.5}) {
    frame(0, dome(kappa));
    frame(2, dome(kappa));
    // rings are 8 of equal area; in each the highest particle stands for its place: an eighth of the whole r^2 at most, and exact here
    EXPECT_NEAR(measure("top_curvature", place), kappa, 1e-4);
    // rings hold no particle exactly at the axis or at the radius: the highest is within an eighth of r^2 of it
    EXPECT_NEAR(measure("dome_rise", place), kappa * 0.9 * 0.9 / 2 / 1.8, std::abs(kappa) * 0.9 * 0.9 / 2 / 1.8 / 4);
  }
}

/// A round body of the radius 2 about (3, 4): its top is 1 + rise (1 - (r / 2)^2), its bottom 0. Rows of a spacing of 0.02.
std::vector<Dot> crowned(double rise) {
  std::vector<Dot> dots;
  for (int i = -100; i <= 100; ++i)
    for (int j = -100; j <= 100; ++j) {
      const double x = 0.02 * i, y = 0.02 * j, r = std::hypot(x, y);
      if (r > 2) continue;
      for (const double height : {0.0, 1 + rise * (1 - r * r / 4)})
        dots.push_back({static_cast<std::int64_t>(dots.size()), {3 + x, 4 + y, height}});
    }
  return dots;
}

TEST_F(FrameMetrics, MeasureTheDomingOfRoundBodiesByTheirOwnSize) {
  for (const double rise : {-0.5, 0.0, 1.0, 1e6}) {
    frame(0, crowned(rise));
    frame(2, crowned(rise));
    // the highest particle of a ring stands at its inner edge, of a dent at its outer one; rings are an eighth of the radius in which 99 %
    // of the volume is, which is 0.995 of the whole
    const auto mean_square = [&](int from, int to) {
      double sum = 0;
      for (int ring = from; ring < to; ++ring) sum += std::pow(0.995 * (ring + (rise < 0 ? 1 : 0)) / 8, 2) / (to - from);
      return sum;
    };
    const double height = 1 + (rise > 0 ? rise : rise * (1 - std::pow(0.995 * 0.75, 2)));
    EXPECT_NEAR(measure("doming", {}), rise / height * (mean_square(4, 6) - mean_square(0, 4)), 4e-3) << rise;
    EXPECT_NEAR(measure("doming", {.point_m = Vector3{3, 4, 0}}), measure("doming", {}), 1e-4) << "places are in single precision";
  }
}

/// A disc off the origin of equally many particles per area, in equal layers, and one far away that is small.
std::vector<Dot> disc(double radius, float volume_of_stray) {
  std::vector<Dot> dots;
  for (int i = -50; i <= 50; ++i)
    for (int j = -50; j <= 50; ++j) {
      const double x = radius * i / 50, y = radius * j / 50;
      if (std::hypot(x, y) <= radius) dots.push_back({static_cast<std::int64_t>(dots.size()), {3 + x, 4 + y, 0}});
    }
  Dot stray{static_cast<std::int64_t>(dots.size()), {9, 4, 0}};
  stray.volume = volume_of_stray;
  dots.push_back(stray);
  return dots;
}

TEST_F(FrameMetrics, HaveNoDomingOfARingWithoutAMiddle) {
  std::vector<Dot> ring = disc(0.5, 1e-3f);
  std::erase_if(ring, [](const Dot& dot) { return std::hypot(dot.at[0] - 3, dot.at[1] - 4) < 0.4; });
  for (Dot& dot : ring) dot.at[2] = static_cast<double>(dot.id % 2);
  frame(0, ring);
  frame(2, ring);
  EXPECT_TRUE(std::isnan(measure("doming", {.point_m = Vector3{3, 4, 0}})));
}

TEST_F(FrameMetrics, MeasureADiameterWithoutItsStrays) {
  frame(0, disc(0.5, 1e-3f));
  frame(2, disc(0.8, 1e-3f));
  const Vector3 middle{3, 4, 7};  // its height does not matter
  // 99 % of a disc's area are within sqrt(0.99) of its radius; the lattice is a fiftieth of that
  EXPECT_NEAR(measure("diameter", {.point_m = middle}), 2 * 0.8 * std::sqrt(0.99), 0.01);
  EXPECT_NEAR(measure("diameter", {}), 2 * 0.8 * std::sqrt(0.99), 0.01) << "about the start's middle";
  EXPECT_NEAR(measure("diameter", {.time_s = 0}), 2 * 0.5 * std::sqrt(0.99), 0.01);
  frame(2, disc(0.8, 1e3f));
  EXPECT_GT(measure("diameter", {.time_s = 2}), 10) << "a stray that is an eighth of the volume is none";
}

TEST_F(FrameMetrics, TellHowFastADiscSpreadsUntilWhenAndWhatItKeeps) {
  std::ofstream(folder_ / "ledger.csv") << "time_s\n0\n10\n20\n30\n40\n";
  const double radii[] = {0.5, 0.5, 0.7, 0.9, 0.8};
  for (int number = 0; number < 5; ++number) frame(number, disc(radii[number], 1e-3f));
  const MetricPlace middle{.point_m = Vector3{3, 4, 0}};
  // 0.8 of the diameter in 20 s from the tenth second on
  EXPECT_NEAR(measure("spread_rate", middle), 0.04 * std::sqrt(0.99), 1e-3);
  EXPECT_NEAR(measure("time_to_spread", middle), 29, 0.2);
  EXPECT_NEAR(measure("diameter_kept", middle), 0.8 / 0.9, 0.01);
  EXPECT_NEAR(measure("set_time", middle), 25 + 10. / 3, 0.2) << "from 0.04 to -0.02 per second between 25 and 35 s";
  for (int number = 0; number < 5; ++number) frame(number, disc(0.5, 1e-3f));
  for (const char* metric : {"spread_rate", "time_to_spread", "set_time"})
    EXPECT_FALSE(std::isfinite(measure(metric, middle))) << metric << " of a disc that does not spread";
  EXPECT_EQ(measure("diameter_kept", middle), 1);
}

TEST_F(FrameMetrics, CompareHeightAndDiameter) {
  std::ofstream(folder_ / "ledger.csv") << "time_s,height_m\n0,2\n1,1\n2,0.4\n";
  frame(0, disc(0.5, 1e-3f));
  frame(2, disc(0.8, 1e-3f));
  EXPECT_NEAR(measure("height_over_diameter", {}), 0.4 / (1.6 * std::sqrt(0.99)), 0.003);
}

/// A bar of 5 x 5 particles across, from x = 0 to `length`, drawn out by `stretch` between 40 and 60 % of it and as much thinner there,
/// and turned by degrees(share of its length). Particles of a bar have one volume.
template <class Degrees>
std::vector<Dot> bar(double length, double stretch, Degrees degrees) {
  std::vector<Dot> dots;
  for (int i = 0; i < 400; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k) {
        const double share = (i + 0.5) / 400, neck = std::clamp(share - 0.4, 0.0, 0.2), thin = share > 0.4 && share < 0.6 ? 1 / stretch : 1;
        const double a = degrees(share) * std::numbers::pi / 180, y = 0.1 * j * std::sqrt(thin), z = 0.1 * k * std::sqrt(thin);
        Dot dot{static_cast<std::int64_t>(dots.size()),
                {length * (share + neck * (stretch - 1)), y * std::cos(a) - z * std::sin(a), y * std::sin(a) + z * std::cos(a)}};
        dot.volume = static_cast<float>(0.25 * length / 400 / 25);  // 0.5 by 0.5 across
        dots.push_back(dot);
      }
  return dots;
}

TEST_F(FrameMetrics, FindTheRadiusOfANeck) {
  const auto straight = [](double) { return 0.0; };
  frame(0, bar(2, 1, straight));
  const double radius = 0.5 / std::sqrt(std::numbers::pi);
  for (const double stretch : {1.0, 4.0}) {
    auto dots = bar(2, stretch, straight);
    std::reverse(dots.begin(), dots.end());
    frame(2, dots);
    // of 400 layers a twentieth holds 20 (of drawn ones 8) or one fewer: half of 1/20 of the radius (of 1/8)
    EXPECT_NEAR(measure("neck_radius", {}) / radius * std::sqrt(stretch), 1, stretch == 1 ? 0.03 : 0.07) << stretch;
  }
  auto parted = bar(2, 1, straight);
  for (Dot& dot : parted)
    if (dot.at[0] > 1) dot.at[0] += 0.5;
  frame(2, parted);
  EXPECT_EQ(measure("neck_radius", {}), 0);
}

TEST_F(FrameMetrics, FindTheSteepestTwist) {
  frame(0, bar(2, 1, [](double) { return 0.0; }));
  // 20 degrees a tenth of the length, and twice as steep from 40 to 60 %: 400 degrees per length of 2 m
  frame(2, bar(2, 3, [](double share) { return -100 + 200 * share + 200 * std::clamp(share - 0.4, 0.0, 0.2); }));
  EXPECT_NEAR(measure("twist_gradient", {}), 400 / 2, 1) << "the outermost layers are half a layer from the ends";
  EXPECT_NEAR(measure("twist_gradient", {.time_s = 0}), 0, 1e-9);
  frame(2, bar(2, 1, [](double share) { return share < 0.5 ? -90 : 89; }));
  EXPECT_NEAR(measure("twist_gradient", {}), 179 / 0.1, 5) << "all of it in one place";
}

TEST_F(FrameMetrics, RefuseTheTwistOfWhatWasPoured) {
  frame(0, {{1, {0, 0, 0}}, {2, {1, 1, 0}}});
  frame(2, {{1, {0, 0, 0}}, {2, {1, 1, 0}}, {3, {1, 0, 0}}});
  EXPECT_THROW(measure("twist_gradient", {}), InputError);
}

constexpr const char* k_fracture = R"({"mesh_volume_m3": 1, "frames": [
 {"frame": 0, "time_s": 0, "broken_edges": 0, "crack_area_m2": 0, "cracks": [],
  "volume_m3": 2, "cut_volume_m3": 1, "pieces": [{"vertices": 4, "volume_m3": 2, "closed": true}]},
 {"frame": 9, "time_s": 3, "broken_edges": 5, "crack_area_m2": 0.4, "volume_m3": 2.5, "cut_volume_m3": 0.75,
  "cracks": [{"area_m2": 0.3, "length_m": 1, "centre_m": [0, 0, 1], "low_m": [0, 0, 0], "high_m": [0, 0, 0]},
             {"area_m2": 0.1, "length_m": 0.5, "centre_m": [0, 0, 0], "low_m": [0, 0, 0], "high_m": [0, 0, 0]}],
  "pieces": [{"vertices": 1, "volume_m3": 0.625, "closed": false}, {"vertices": 3, "volume_m3": 1.5625, "closed": true},
             {"vertices": 1, "volume_m3": 0.3125, "closed": true}]}]})";

class SurfaceMetrics : public testing::Test {
 protected:
  double measure(const char* metric, const MetricPlace& place = {}, const std::string& json = k_fracture) const {
    std::ofstream(folder_ / "fracture.json") << json;
    return std::get<OfSurface>(find_metric(metric).of)(read_fracture(folder_ / "fracture.json"), place);
  }
  const TemporaryFolder folder_;
};

TEST_F(SurfaceMetrics, CountAndMeasureCracksAndPieces) {
  EXPECT_EQ(measure("cracks"), 2);
  EXPECT_DOUBLE_EQ(measure("crack_area"), 0.4);
  EXPECT_EQ(measure("crack_length"), 1.5);
  EXPECT_EQ(measure("pieces"), 3);
  EXPECT_EQ(measure("open_pieces"), 1);
  EXPECT_EQ(measure("pieces_volume"), 1.25);
  EXPECT_EQ(measure("cut_volume"), 0.75);
  EXPECT_EQ(measure("second_piece"), 0.25);
  EXPECT_EQ(measure("two_pieces"), 0.875);
}

TEST_F(SurfaceMetrics, ReadANumberThatIsNullAsNaN) {
  std::string json = k_fracture;
  json.replace(json.find("\"area_m2\": 0.1"), 14, "\"area_m2\": null");
  const std::string message = message_of<NoNumber>([&] { measure("cracks", {}, json); });
  EXPECT_NE(message.find("fracture.json: a crack's area_m2 at 3 s: found nan, allowed: a finite number"), std::string::npos) << message;
}

TEST_F(SurfaceMetrics, CompareNoVolumeWithItself) { EXPECT_THROW(measure("pieces_volume", {.time_s = 0}), NoNumber); }

TEST_F(SurfaceMetrics, LookAtTheFrameThatIsAskedFor) {
  const MetricPlace start{.time_s = 1};  // of frames at 0 and 3 s
  EXPECT_EQ(measure("cracks", start), 0);
  EXPECT_EQ(measure("second_piece", start), 0);
  EXPECT_EQ(measure("two_pieces", start), 1);
}

TEST_F(SurfaceMetrics, FindTheCracksInABoxAndTheirShare) {
  MetricPlace top{.low_m = Vector3{-1, -1, 0.5}};
  EXPECT_DOUBLE_EQ(measure("crack_area", top), 0.3);
  top.high_m = Vector3{1, 1, 2};
  EXPECT_DOUBLE_EQ(measure("crack_area", top), 0.3);
  EXPECT_DOUBLE_EQ(measure("crack_share", top), 0.75);
  top.time_s = 0;
  EXPECT_TRUE(std::isnan(measure("crack_share", top))) << "no crack has no share";
}

TEST_F(SurfaceMetrics, RefuseWhatIsNoFractureSurface) {
  EXPECT_THROW(read_fracture(folder_ / "nothing.json"), InputError);
  EXPECT_THROW(measure("cracks", {}, "{\"frames\": []}"), InputError);
  EXPECT_THROW(measure("cracks", {}, "{\"frames\": [{}]}"), InputError);
}

class ResultsOfARun : public testing::Test {
 protected:
  /// A run whose ledger has these columns and rows.
  Results results(const std::string& ledger, const char* state = "done") const {
    std::ofstream(folder_ / "run.json") << "{\"summary\": {\"state\": \"" << state << "\"}}";
    std::ofstream(folder_ / "ledger.csv") << ledger;
    return Results(folder_.path());
  }
  const TemporaryFolder folder_;
};

TEST_F(ResultsOfARun, AreNotThereBeforeItIsDone) {
  EXPECT_THROW(results("time_s,volume_m3\n0,1\n", "interrupted"), InputError);
  EXPECT_THROW(results("time_s,volume_m3\n"), InputError);
  EXPECT_THROW(results("time_s\n0\n").column("volume_m3"), InputError);
}

using Booking = std::pair<std::string, double>;  ///< a column, and whether what it holds adds to the content or takes from it

/// A ledger whose content is 100 and what was booked; every booking is another power of two, and doubled in the last row.
std::string closed_books(const std::string& content, const std::vector<Booking>& bookings, const std::string& more = "") {
  std::string heading = "time_s," + content, rows;
  for (const auto& [column, sign] : bookings) heading += "," + column;
  for (const int row : {0, 1, 2}) {
    double sum = 100, booked = row;
    std::string line;
    for (const auto& [column, sign] : bookings) {
      sum += sign * booked;
      line += "," + std::to_string(booked);
      booked *= 2;
    }
    rows += std::to_string(row) + "," + std::to_string(sum) + line + (more.empty() ? "" : ",1,1,0,0") + "\n";
  }
  return heading + more + "\n" + rows;
}

TEST_F(ResultsOfARun, CloseTheBooksOfEveryContentWithEveryBookingsSign) {
  const auto drift = [&](const char* metric, const std::string& ledger) {
    return std::get<OfRun>(find_metric(metric).of)(results(ledger), {});
  };
  EXPECT_EQ(drift("heat_drift", closed_books("heat_content_J", {{"heat_exchanged_J", 1},
                                                                {"latent_heat_J", -1},
                                                                {"vapour_heat_J", -1},
                                                                {"expansion_heat_J", -1},
                                                                {"water_remap_heat_J", 1},
                                                                {"retired_heat_content_J", -1},
                                                                {"emitted_heat_content_J", 1}})),
            0);
  EXPECT_EQ(drift("water_drift", closed_books("water_mass_kg",
                                              {{"water_evaporated_kg", -1}, {"retired_water_mass_kg", -1}, {"emitted_water_mass_kg", 1}})),
            0);
  EXPECT_EQ(drift("solid_drift", closed_books("solid_mass_kg", {{"retired_solid_mass_kg", -1}, {"emitted_solid_mass_kg", 1}})), 0);
  for (const char axis : {'x', 'y', 'z'}) {
    const auto name = [&](const char* what) { return std::string(what) + "_" + axis + "_kg_m_per_s"; };
    const std::vector<Booking> bookings{
        {name("impulse"), 1}, {name("water_remap_momentum"), 1}, {name("retired_momentum"), -1}, {name("emitted_momentum"), 1}};
    EXPECT_EQ(drift((std::string("momentum_drift_") + axis).c_str(),
                    closed_books(name("momentum"), bookings, ",solid_mass_kg,water_mass_kg,emitted_solid_mass_kg,emitted_water_mass_kg")),
              0);
  }
}

TEST_F(ResultsOfARun, DriftAsFarAsTheyEverWereFromTheStart) {
  const Results run = results("time_s,solid_mass_kg,retired_solid_mass_kg,emitted_solid_mass_kg\n0,2,0,0\n1,5,0,0\n2,3,0,0\n");
  EXPECT_EQ(std::get<OfRun>(find_metric("solid_drift").of)(run, {}), 1.5);
}

TEST_F(ResultsOfARun, TellWhatEveryColumnWasAtTheEndOrOnTheWay) {
  const Results run = results(
      "time_s,height_m,extent_x_m,extent_y_m,surface_m2,water_evaporated_kg,water_mass_kg,gas_mol,temperature_min_C,temperature_mean_C,"
      "temperature_max_C,dissipated_J,retired_particles,emitted_water_mass_kg,emitted_solid_mass_kg\n0,4,5,8,1,0,10,0,9,20,30,0,0,0,0\n"
      "1,7,1,1,2,1,9,1,3,25,95,2,1,2,1\n2,6,10,2,3,3,8,5,6,40,50,11,7,5,4\n");
  const std::vector<std::pair<const char*, double>> all{
      {"height_gain", 1.5},     {"extent_x_gain", 2},     {"extent_y_gain", 0.25}, {"height", 6},
      {"largest_height", 7},    {"surface", 3},           {"gas_made", 5},         {"water_lost_share", 0.2},
      {"coldest", 6},           {"coldest_ever", 3},      {"hottest_ever", 95},    {"dissipated", 11},
      {"mean_temperature", 40}, {"retired_particles", 7}, {"poured_mass", 4}};
  for (const auto& [metric, value] : all) EXPECT_DOUBLE_EQ(std::get<OfRun>(find_metric(metric).of)(run, {}), value) << metric;
}

TEST_F(ResultsOfARun, TellHowMuchOfTheHeightComesBack) {
  const Results run = results("time_s,height_m\n0,3\n1,4\n2,2\n3,2.5\n");
  const auto springback = [&](const MetricPlace& place) { return std::get<OfRun>(find_metric("springback").of)(run, place); };
  EXPECT_DOUBLE_EQ(springback({.time_s = 2}), 0.5) << "of what was there at the start";
  EXPECT_DOUBLE_EQ(springback({.reference_time_s = 1, .time_s = 2}), 0.25);
  EXPECT_FALSE(std::isfinite(springback({.reference_time_s = 2, .time_s = 2}))) << "no height was lost";
}

TEST_F(ResultsOfARun, TellGainsAndWhatTheBooksDoNotExplain) {
  const Results run = results(
      "time_s,volume_m3,solid_mass_kg,retired_solid_mass_kg,emitted_solid_mass_kg,emitted_volume_m3\n0,1,2,0,0,0\n1,2,1.5,0.5,0,0\n"
      "2,3,2.25,0.5,0.5,1\n");
  EXPECT_DOUBLE_EQ(std::get<OfRun>(find_metric("solid_drift").of)(run, {}), 0.25 / 2.5);
  EXPECT_EQ(std::get<OfRun>(find_metric("volume_gain").of)(run, {}), 1.5);
  const Results nothing = results("time_s,volume_m3,emitted_volume_m3\n0,0,0\n1,1,0\n");
  EXPECT_FALSE(std::isfinite(std::get<OfRun>(find_metric("volume_gain").of)(nothing, {}))) << "a gain over nothing";
}

}  // namespace
}  // namespace bake

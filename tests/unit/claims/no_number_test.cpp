// SPDX-License-Identifier: MIT
// NaN fails: no metric passes over a number that is none, wherever in the results it stands, and no claim holds of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "analysis/claims/claim.h"
#include "solver/io/frames.h"
#include "solver/io/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// Results of a body that all metrics can be measured of: a ledger and three frames of 40 particles, which move and heat up.
struct Body {
  std::vector<std::string> columns{"time_s"};
  std::vector<std::vector<double>> rows;
  std::vector<FrameData> frames;

  Body() {
    std::istringstream names(
        "volume_m3 height_m extent_x_m extent_y_m surface_m2 skin_area_m2 water_evaporated_kg water_mass_kg gas_mol "
        "temperature_min_C temperature_mean_C temperature_max_C dissipated_J solid_mass_kg retired_solid_mass_kg "
        "emitted_solid_mass_kg retired_water_mass_kg emitted_water_mass_kg heat_content_J heat_exchanged_J latent_heat_J "
        "vapour_heat_J expansion_heat_J water_remap_heat_J retired_heat_content_J emitted_heat_content_J emitted_volume_m3 "
        "retired_particles");
    for (std::string name; names >> name;) columns.push_back(name);
    for (const char axis : {'x', 'y', 'z'})
      for (const char* what : {"momentum", "impulse", "water_remap_momentum", "retired_momentum", "emitted_momentum"})
        columns.push_back(fmt::format("{}_{}_kg_m_per_s", what, axis));
    for (int row = 0; row < 3; ++row) {
      std::vector<double> numbers{static_cast<double>(row)};
      while (numbers.size() < columns.size()) numbers.push_back(10 + row + 0.25 * static_cast<double>(numbers.size() % 7));
      rows.push_back(numbers);
      frames.push_back(frame(row));
    }
  }
  std::size_t at(const char* column) const {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
  }
  static FrameData frame(int number) {
    FrameData data;
    std::vector<double> positions;
    std::vector<float> temperature, peak, volume, water;
    std::vector<std::int64_t> material, id;
    for (int i = 0; i < 40; ++i) {
      const double x = 0.1 * i, turn = 0.1 * number * i;
      for (const double place : {x * (1 + 0.1 * number), std::cos(turn) + 0.01 * i, std::sin(turn) - 0.02 * i}) positions.push_back(place);
      temperature.push_back(static_cast<float>(20 + 30 * number + i));
      peak.push_back(temperature.back());
      volume.push_back(1 + 0.01f * static_cast<float>(i));
      water.push_back(1 / static_cast<float>(1 + number));
      material.push_back(0);
      id.push_back(i);
    }
    data.positions = std::move(positions);
    data.columns = {{"temperature", "C", temperature}, {"peak_temperature", "C", peak}, {"volume", "m^3", volume},
                    {"water_mass", "kg", water},       {"material", "1", material},     {"id", "1", id},
                    {"saturation", "1", water}};
    return data;
  }
  /// `keeps`: the frames that are in the folder; what differs is written.
  Results written(const std::filesystem::path& folder, const std::vector<FrameData>* keeps = nullptr) const {
    std::filesystem::create_directories(folder / "frames");
    std::ofstream(folder / "run.json") << R"({"summary": {"state": "done"}, "scene": {"quality": "draft", "grid": {"dx_m": 0.1},
      "oven": {"heat_transfer_coefficient_W_per_m2K": 10, "temperature_C": 190}, "material": [{"name": "batter",
      "initial_temperature_C": 5, "temperatures_C": [4, 20, 45, 120], "yield_stress_Pa": [20, 20, 2, 2000]}]}})";
    std::ofstream ledger(folder / "ledger.csv");
    ledger << fmt::format("{}\n", fmt::join(columns, ","));
    for (const auto& row : rows) ledger << fmt::format("{:.17g}\n", fmt::join(row, ","));
    ledger.close();
    for (std::size_t i = 0; i < frames.size(); ++i)
      if (!keeps || i >= keeps->size() || differ((*keeps)[i], frames[i])) {
        write_frame(folder / "frames" / frame_name(static_cast<int>(i)), static_cast<double>(i), frames[i]);
        write_skin(folder, i);
      }
    return Results(folder);
  }
  /// A triangle at two particles that bends as they become hot.
  void write_skin(const std::filesystem::path& folder, std::size_t i) const {
    const auto& x = std::get<std::vector<double>>(frames[i].positions);
    const auto& temperature = std::get<std::vector<float>>(frames[i].columns[0].values);
    const double bent = static_cast<double>(temperature[0]) - 20;
    Mesh mesh;
    mesh.points = {x[0], x[1], x[2], x[30], x[31], x[32], x[30], x[31] + 0.5, x[32]};
    mesh.cells = {0, 1, 2};
    mesh.fields = {{"curvature", "1/m", 1, {bent, bent, bent}}, {"saturation", "1", 1, {0.5, 0.5, 0.5}}};
    std::filesystem::create_directories(folder / "skins");
    write_mesh(folder / "skins" / frame_name(static_cast<int>(i)), mesh);
  }
  static bool differ(const FrameData& a, const FrameData& b) {  // as NaN does from itself
    for (std::size_t i = 0; i < a.columns.size(); ++i)
      if (a.columns[i].values != b.columns[i].values) return true;
    return a.positions != b.positions;
  }
};

Fracture torn() {
  const Fracture::Frame before{0, 0, 2, 1, {}, {{2, true}}};
  const Fracture::Frame after{1, 0.4, 2.5, 0.75, {{0.3, 1, {1, 0, 1}}, {0.1, 0.5, {0, 0, 0}}}, {{0.625, false}, {1.875, true}}};
  return {"fracture.json", 1, {before, after}};
}

/// A place that every metric accepts; those of surfaces look at a box, too.
MetricPlace place_for(const Metric& metric) {
  MetricPlace place{.from_m = Vector3{0, 1, 0},
                    .to_m = Vector3{3.9, 1, 0},
                    .point_m = Vector3{1, 1, 0},
                    .low_m = Vector3{-0.5, -2, -2},
                    .high_m = Vector3{2.5, 2, 2},
                    .radius_m = 2.5,
                    .temperature_C = std::string_view(metric.name) == "heating_window" ? 60 : 70,
                    .dried_share = 0.5,
                    .material = "batter",
                    .softened_to = 0.5};
  if (std::string_view(metric.name) == "springback") place.time_s = 1;
  if (std::string_view(metric.name) == "doming") place.point_m = Vector3{2.4, -0.45, 0};  // particles in all rings around it
  return place;
}

class NoMetric : public testing::Test {
 protected:
  /// Each metric of runs by its name.
  std::map<std::string, Measurement> measured(const Body& body) const {
    const Results run = body.written(folder_.path(), &kept_);
    kept_ = body.frames;
    std::map<std::string, Measurement> all;
    for (const Metric& metric : all_metrics())
      if (metric.is_of_run()) all.emplace(metric.name, measure(metric, run, place_for(metric)));
    return all;
  }
  /// Those whose number is another one now, but is a number.
  std::string fooled(const Body& body, const std::map<std::string, Measurement>& before, int& misses) const {
    std::string names;
    for (const auto& [name, now] : measured(body)) {
      misses += !now.is_number();
      if (now.is_number() && now.value != before.at(name).value) names += name + " ";
      EXPECT_TRUE(now.is_number() || now.problem.find(", allowed: ") != std::string::npos) << now.problem;
    }
    return names;
  }
  const TemporaryFolder folder_;

 private:
  mutable std::vector<FrameData> kept_;  ///< frames are slow to write
};

TEST_F(NoMetric, LacksANumberOfAWholeBody) {
  for (const auto& [name, m] : measured(Body())) EXPECT_TRUE(m.is_number()) << name << ": " << m.problem;
  for (const Metric& metric : all_metrics())
    EXPECT_TRUE(metric.is_of_run() || measure(metric, torn(), place_for(metric)).is_number()) << metric.name;
}

TEST_F(NoMetric, HasANumberWhereAllAreNaN) {
  Body body;
  for (auto& row : body.rows) std::fill(row.begin() + 1, row.end(), k_nan);
  for (FrameData& frame : body.frames) {
    auto& positions = std::get<std::vector<double>>(frame.positions);
    std::fill(positions.begin(), positions.end(), k_nan);
    for (FrameColumn& column : frame.columns)
      if (auto* values = std::get_if<std::vector<float>>(&column.values)) std::fill(values->begin(), values->end(), std::nanf(""));
  }
  for (const auto& [name, m] : measured(body)) EXPECT_FALSE(m.is_number()) << name << " = " << m.value;
}

TEST_F(NoMetric, PassesOverOneNumberOfTheLedgerThatIsNone) {
  const auto before = measured(Body());
  for (const double none : {k_nan, k_infinity, -k_infinity})
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < Body().columns.size(); ++column) {
        Body body;
        body.rows[row][column] = none;
        int misses = 0;
        const std::string& name = body.columns[column];
        EXPECT_EQ(fooled(body, before, misses), "") << none << " in row " << row << " of " << name;
        EXPECT_TRUE(row < 2 || misses > 0) << "nothing reads the last row of " << name;
      }
}

TEST_F(NoMetric, PassesOverOneParticleThatIsNowhere) {
  const auto before = measured(Body());
  for (const float none : {std::nanf(""), static_cast<float>(k_infinity)})
    for (std::size_t frame = 0; frame < 3; ++frame)
      for (std::size_t column = 0; column < 5; ++column) {
        Body body;
        FrameData& data = body.frames[frame];
        if (column == 4)
          std::get<std::vector<double>>(data.positions)[3 * 17 + 1] = none;
        else
          std::get<std::vector<float>>(data.columns[column].values)[17] = none;
        int misses = 0;
        EXPECT_EQ(fooled(body, before, misses), "") << none << " in frame " << frame << ", column " << column;
        EXPECT_TRUE(frame < 2 || misses > 0) << "nothing reads column " << column;
      }
}

TEST_F(NoMetric, OfASurfacePassesOverNaN) {
  using Change = std::function<void(Fracture&)>;
  const std::vector<Change> changes{
      [](Fracture& f) { f.mesh_volume_m3 = k_nan; },
      [](Fracture& f) { f.frames[1].time_s = k_nan; },
      [](Fracture& f) { f.frames[1].crack_area_m2 = k_nan; },
      [](Fracture& f) { f.frames[1].volume_m3 = k_infinity; },
      [](Fracture& f) { f.frames[1].cut_volume_m3 = k_nan; },
      [](Fracture& f) { f.frames[1].cracks[1].area_m2 = k_nan; },
      [](Fracture& f) { f.frames[1].cracks[1].length_m = k_nan; },
      [](Fracture& f) { f.frames[1].cracks[1].centre_m[2] = k_nan; },
      [](Fracture& f) { f.frames[1].pieces[1].volume_m3 = k_nan; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
    for (const Metric& metric : all_metrics()) {
      if (metric.is_of_run()) continue;
      Fracture fracture = torn();
      changes[i](fracture);
      const Measurement m = measure(metric, fracture, place_for(metric));
      EXPECT_FALSE(m.is_number()) << metric.name << " = " << m.value << " after change " << i;
      EXPECT_EQ(m.problem.rfind("fracture.json: ", 0), 0u) << m.problem;
    }
}

TEST_F(NoMetric, IsMeasuredOfAnEmptySurface) {
  using Change = std::function<void(Fracture&)>;
  for (const Change& change : {Change([](Fracture& f) { f.frames.clear(); }), Change([](Fracture& f) { f.frames[1].pieces.clear(); }),
                               Change([](Fracture& f) { f.frames[1].volume_m3 = 0; }), Change([](Fracture& f) { f.mesh_volume_m3 = 0; })})
    for (const Metric& metric : all_metrics()) {
      if (metric.is_of_run()) continue;
      Fracture fracture = torn();
      change(fracture);
      EXPECT_FALSE(measure(metric, fracture, place_for(metric)).is_number()) << metric.name;
    }
}

TEST_F(NoMetric, IsMeasuredBeyondTheLastFrame) {
  const Results run = Body().written(folder_.path());
  for (const Metric& metric : all_metrics()) {
    MetricPlace place = place_for(metric);
    const auto number_at = [&](double time) {
      place.time_s = time;
      return (metric.is_of_run() ? measure(metric, run, place) : measure(metric, torn(), place)).is_number();
    };
    if (std::find(metric.knows.begin(), metric.knows.end(), "time_s") == metric.knows.end()) continue;
    const double last = metric.is_of_run() ? 2 : 1;
    EXPECT_TRUE(number_at(last + 0.5)) << metric.name << ": half a frame";
    EXPECT_FALSE(number_at(last + 0.51)) << metric.name;
    EXPECT_FALSE(number_at(-0.51)) << metric.name;
  }
}

TEST_F(NoMetric, TellsAGainOrADriftOfARunThatHasNotBegun) {
  Body body;
  body.rows.resize(1);
  const Results run = body.written(folder_.path());
  for (const char* name : {"volume_gain", "height_gain", "extent_x_gain", "extent_y_gain", "solid_drift", "water_drift", "heat_drift",
                           "momentum_drift_x", "momentum_drift_y", "momentum_drift_z"}) {
    const Measurement m = measure(find_metric(name), run, {});
    EXPECT_FALSE(m.is_number()) << name << " = " << m.value;
    EXPECT_NE(m.problem.find("ledger.csv: found one row, allowed: a run of some time"), std::string::npos) << m.problem;
  }
}

TEST_F(NoMetric, LeavesUnsaidWhereItMetNaN) {
  Body body;
  body.rows[1][body.at("heat_content_J")] = k_nan;
  std::get<std::vector<float>>(body.frames[2].columns[0].values)[17] = std::nanf("");
  const auto all = measured(body);
  EXPECT_EQ(all.at("heat_drift").problem, (folder_ / "ledger.csv").string() + ":3: heat_content_J: found nan, allowed: a finite number");
  EXPECT_EQ(all.at("temperature_at").problem,
            (folder_ / "frames/0002.hdf").string() + ": temperature in row 17: found nan, allowed: a finite number");
}

TEST_F(NoMetric, TakesANegativeHeatContentForASmallDrift) {
  Body body;
  for (auto& row : body.rows) std::fill(row.begin() + 1, row.end(), 0), row[body.at("heat_content_J")] = -100;
  body.rows[2][body.at("heat_content_J")] = -150;
  EXPECT_DOUBLE_EQ(measured(body).at("heat_drift").value, 50. / 150) << "the content is below zero at temperatures below 0 C";
}

TEST_F(NoMetric, LeadsByNothingBetweenOneParticleAndItself) {
  const Results run = Body().written(folder_.path());
  const Measurement m = measure(find_metric("temperature_lead"), run, {.from_m = Vector3{0, 1, 0}, .to_m = Vector3{0.01, 1, 0}});
  EXPECT_NE(m.problem.find("found one particle nearest to from_m and to_m, allowed: two"), std::string::npos) << m.problem;
}

TEST_F(NoMetric, SharesAVolumeThatIsNone) {
  Body body;
  for (FrameData& frame : body.frames) {
    auto& volumes = std::get<std::vector<float>>(frame.columns[2].values);
    std::fill(volumes.begin(), volumes.end(), 0.f);
  }
  const auto all = measured(body);
  for (const char* name :
       {"diameter", "height_over_diameter", "outflow", "share_in_box", "heated_share", "heating_window", "softened_share"})
    EXPECT_FALSE(all.at(name).is_number()) << name << " = " << all.at(name).value;
}

TEST_F(NoMetric, TellsATwistOfPartsWithoutParticlesOffTheAxis) {
  Body body;
  for (FrameData& frame : body.frames) {
    auto& positions = std::get<std::vector<double>>(frame.positions);
    for (const std::size_t particle : {20u, 21u}) positions[3 * particle + 1] = positions[3 * particle + 2] = 0;
  }
  EXPECT_FALSE(measured(body).at("twist_gradient").is_number());
}

TEST_F(NoMetric, ComparesAYieldStressWithNone) {
  Body().written(folder_.path());
  std::ofstream(folder_ / "run.json") << R"({"summary": {"state": "done"}, "scene": {"material": [{"name": "batter",
    "initial_temperature_C": 5, "temperatures_C": [4, 20, 45, 120], "yield_stress_Pa": [0, 0, 0, 0]}]}})";
  const Measurement m = measure(find_metric("softened_share"), Results(folder_.path()), place_for(find_metric("softened_share")));
  EXPECT_NE(m.problem.find("found a yield stress of 0 Pa at the start, allowed: above 0"), std::string::npos) << m.problem;
}

TEST(TheLargerAndTheSmaller, OfNaNAndANumberIsNaN) {
  EXPECT_EQ(larger(1, 2), 2);
  EXPECT_EQ(larger(2, 1), 2);
  EXPECT_EQ(smaller(1, -2), -2);
  EXPECT_EQ(smaller(-2, 1), -2);
  EXPECT_EQ(largest_of({1, 3, 2}), 3);
  EXPECT_EQ(smallest_of({2, 1, 3}), 1);
  for (const auto& [a, b] : {std::pair(k_nan, 1.0), std::pair(1.0, k_nan)}) {
    EXPECT_TRUE(std::isnan(larger(a, b)));
    EXPECT_TRUE(std::isnan(smaller(a, b)));
    EXPECT_TRUE(std::isnan(largest_of({0, a, b, 0})));
    EXPECT_TRUE(std::isnan(smallest_of({0, a, b, 0})));
  }
  EXPECT_TRUE(std::isnan(largest_of({})));
  EXPECT_TRUE(std::isnan(smallest_of({})));
}

}  // namespace
}  // namespace bake

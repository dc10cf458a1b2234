// SPDX-License-Identifier: MIT
// A run whose results are written by hand, for tests of metrics.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "analysis/claims/metric.h"
#include "solver/io/frames.h"
#include "tests/support/temporary_folder.h"

namespace bake {

/// A particle of a frame: where, how hot now and ever, how large, how wet, of which material, how broken.
struct Dot {
  std::int64_t id;
  Vector3 at;
  float temperature = 20, peak = 20, volume = 1, water = 1;
  std::int64_t material = 0;
  float broken = 0;
};

class WrittenRun : public testing::Test {
 protected:
  WrittenRun(const std::string& description, const std::string& ledger) {
    std::filesystem::create_directories(folder_ / "frames");
    std::ofstream(folder_ / "run.json") << description;
    std::ofstream(folder_ / "ledger.csv") << ledger;
  }
  void frame(int number, const std::vector<Dot>& dots) const {
    std::vector<float> places, temperature, peak, volume, water, broken;
    std::vector<std::int64_t> ids, material;
    for (const Dot& dot : dots) {
      for (const double x : dot.at) places.push_back(static_cast<float>(x));
      temperature.push_back(dot.temperature);
      peak.push_back(dot.peak);
      volume.push_back(dot.volume);
      water.push_back(dot.water);
      broken.push_back(dot.broken);
      material.push_back(dot.material);
      ids.push_back(dot.id);
    }
    write_frame(folder_ / "frames" / frame_name(number), number,
                {places,
                 {{"temperature", "C", temperature},
                  {"peak_temperature", "C", peak},
                  {"volume", "m^3", volume},
                  {"water_mass", "kg", water},
                  {"broken", "1", broken},
                  {"material", "1", material},
                  {"id", "1", ids}}});
  }
  double measure(const char* metric, const MetricPlace& place) const {
    return std::get<OfRun>(find_metric(metric).of)(Results(folder_.path()), place);
  }
  const TemporaryFolder folder_;
};

}  // namespace bake

// SPDX-License-Identifier: MIT
// Metrics of frames: what share of the volume is somewhere, has been hot, or has become soft.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"
#include "analysis/claims/volume_share.h"
#include "solver/core/curve.h"

namespace bake {
namespace {

double share_in_box(const Results& run, const MetricPlace& at) {
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto positions = frame.positions();
  return volume_share(frame, [&](std::size_t row) { return is_in_box(position(positions, row), at); });
}

/// For each particle of `now` whether it was in the box at the start; what was poured later was not.
std::vector<bool> started_in_box(const CheckedFrame& start, const CheckedFrame& now, const MetricPlace& at) {
  const auto positions = start.positions();
  std::vector<bool> inside;
  for (const std::int64_t row : rows_in(start, now))
    inside.push_back(row >= 0 && is_in_box(position(positions, static_cast<std::size_t>(row)), at));
  return inside;
}

double heated_share_of(const Results& run, int number, const MetricPlace& at) {
  const CheckedFrame frame = run.frame(number);
  const auto peak = frame.column("peak_temperature");
  const auto is_hot = [&](std::size_t row) { return static_cast<double>(peak[row]) >= *at.temperature_C; };
  if (!at.low_m) return volume_share(frame, is_hot);
  const auto inside = started_in_box(run.frame(at.reference_time_s ? run.frame_at(at.reference_time_s) : 0), frame, at);
  return volume_share(
      frame, [&](std::size_t row) { return inside[row]; }, is_hot);
}

double heated_share(const Results& run, const MetricPlace& at) {
  if (at.low_m.has_value() != at.high_m.has_value()) throw InputError("heated_share: found one corner of a box, allowed: both or none");
  return heated_share_of(run, run.frame_at(at.time_s), at);
}

double heating_window(const Results& run, const MetricPlace& at) {
  const auto times = run.column("time_s");
  std::vector<double> shares;
  for (std::size_t i = 0; i < times.size(); ++i) {
    shares.push_back(heated_share_of(run, static_cast<int>(i), at));
    expect_finite(shares.back(), [&] { return fmt::format("{}: heated share at {} s", run.folder().string(), times[i]); });
  }
  const double first = time_of_share(times, shares, 0.1);
  return (time_of_share(times, shares, 0.9) - first) / first;
}

constexpr double k_broken = 0.9;  ///< share of its fracture energy after which dough counts as broken: a third of its strength is left

/// For each particle whether it is crust: has it been at temperature_C, and has it not broken since?
std::vector<bool> whole_crust(const CheckedFrame& frame, const MetricPlace& at) {
  const auto peak = frame.column("peak_temperature");
  const auto broken = frame.has("broken") ? frame.column("broken") : std::vector<float>(peak.size(), 0);
  std::vector<bool> crust;
  for (std::size_t row = 0; row < peak.size(); ++row)
    crust.push_back(static_cast<double>(peak[row]) >= *at.temperature_C && static_cast<double>(broken[row]) < k_broken);
  return crust;
}

double broken_share(const Results& run, const MetricPlace& at) {
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto peak = frame.column("peak_temperature");
  const auto whole = whole_crust(frame, at);
  return volume_share(
      frame, [&](std::size_t row) { return static_cast<double>(peak[row]) >= *at.temperature_C; },
      [&](std::size_t row) { return !whole[row]; });
}

/// Looks at the body from its side, through windows as wide and high as two particles: what has not been hot and is in front of all crust
/// in its window has come through it.
double oozed_share(const Results& run, const MetricPlace& at) {
  constexpr double k_window = 2;
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto positions = frame.positions();
  const auto volumes = frame.column("volume"), peak = frame.column("peak_temperature");
  const auto crust = whole_crust(frame, at);
  const double all = std::accumulate(volumes.begin(), volumes.end(), 0.0),
               width = k_window * std::cbrt(all / static_cast<double>(volumes.size()));
  std::vector<double> radius;
  for (std::size_t row = 0; row < volumes.size(); ++row) radius.push_back(std::hypot(positions[3 * row], positions[3 * row + 1]));
  const double angle = width / *std::max_element(radius.begin(), radius.end());
  std::vector<std::pair<long, long>> window;
  std::map<std::pair<long, long>, double> reach;  // of the crust
  for (std::size_t row = 0; row < volumes.size(); ++row) {
    const Vector3 x = position(positions, row);
    window.emplace_back(std::lround(std::floor(std::atan2(x[1], x[0]) / angle)), std::lround(std::floor(x[2] / width)));
    if (crust[row]) reach[window[row]] = std::max(reach[window[row]], radius[row]);
  }
  return volume_share(frame, [&](std::size_t row) {
    return static_cast<double>(peak[row]) < *at.temperature_C && radius[row] > std::max(reach[window[row]], at.radius_m.value_or(0));
  });
}

/// The yield stress of fig. 8 of each particle, over that at its material's start temperature.
class RelativeYieldStress {
 public:
  RelativeYieldStress(const nlohmann::json& material, const std::filesystem::path& run) {
    try {
      const auto theta = material.at("temperatures_C").get<std::array<double, 4>>();
      const auto tau_y = material.at("yield_stress_Pa").get<std::array<double, 4>>();
      for (std::size_t i = 0; i < 4; ++i) curve_.points.push_back({theta[i], tau_y[i]});
      at_start_ = curve_(material.at("initial_temperature_C").get<double>());
    } catch (const nlohmann::json::exception&) {
      throw InputError(fmt::format("{}: found a material without yield stress, allowed: a run with plasticity", run.string()));
    }
    if (!(at_start_ > 0))
      throw NoNumber(fmt::format("{}: found a yield stress of {} Pa at the start, allowed: above 0", run.string(), at_start_));
  }
  /// Frozen once it has passed the last temperature.
  double operator()(double theta, double peak) const { return curve_(peak >= curve_.points.back().at ? peak : theta) / at_start_; }

 private:
  Curve curve_;
  double at_start_ = 0;
};

/// The number and the table of the material with that name.
std::pair<std::size_t, nlohmann::json> find_material(const Results& run, const std::string& name) {
  const auto& scene = run.description().at("scene");
  const auto materials = scene.value("material", nlohmann::json::array());
  std::vector<std::string> known;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (materials[i].at("name") == name) return {i, materials[i]};
    known.push_back(materials[i].at("name"));
  }
  throw InputError(fmt::format("{}: found no material '{}', allowed: {}", run.folder().string(), name, fmt::join(known, ", ")));
}

double softened_share(const Results& run, const MetricPlace& at) {
  const auto [number, material] = find_material(run, *at.material);
  const RelativeYieldStress yield_stress(material, run.folder());
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto materials = frame.column("material"), temperatures = frame.column("temperature"), peaks = frame.column("peak_temperature");
  return volume_share(
      frame, [&, own = static_cast<float>(number)](std::size_t row) { return materials[row] == own; },
      [&](std::size_t row) {
        return yield_stress(static_cast<double>(temperatures[row]), static_cast<double>(peaks[row])) <= *at.softened_to;
      });
}

}  // namespace

std::vector<Metric> region_metrics() {
  return {
      {"share_in_box", "1", fraction, "share of the volume that is in the box from low_m to high_m", share_in_box, needs("low_m", "high_m"),
       knows("time_s")},
      {"heated_share", "1", fraction,
       "share of the volume that has been at temperature_C: gelatinised, for dough; with low_m and high_m of what was in that box at the "
       "start, or at reference_time_s",
       heated_share, needs("temperature_C"), knows("reference_time_s", "time_s", "low_m", "high_m")},
      {"heating_window", "1", non_negative,
       "time from which a tenth of the volume has been at temperature_C until nine tenths have, over the time until that tenth has",
       heating_window, needs("temperature_C")},
      {"broken_share", "1", fraction, "share of the volume that has been at temperature_C, the crust, which has broken", broken_share,
       needs("temperature_C"), knows("time_s")},
      {"oozed_share", "1", fraction,
       "share of the volume that has not been at temperature_C and is farther from the z axis than radius_m (0 unless given) and than all "
       "whole crust, which has, in the same direction and at the same height: what has come through the crust",
       oozed_share, needs("temperature_C"), knows("radius_m", "time_s")},
      {"softened_share", "1", fraction,
       "share of the material's volume whose yield stress is at most softened_to of that at the start: melted, for chocolate",
       softened_share, needs("material", "softened_to"), knows("time_s")},
  };
}

}  // namespace bake

// SPDX-License-Identifier: MIT
// Metrics: named numbers that are measured of a run, or of the fracture surface that was made from one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/claims/fracture.h"
#include "analysis/claims/results.h"
#include "solver/scene/describe.h"

namespace bake {

/// Where and when a metric is taken. Each metric says which of these it needs and which it knows; the others are refused.
struct MetricPlace {
  std::optional<Vector3> from_m = {}, to_m = {};
  std::optional<Vector3> point_m = {};
  std::optional<Vector3> low_m = {}, high_m = {};
  std::optional<double> radius_m = {};
  std::optional<double> temperature_C = {};
  std::optional<double> dried_share = {};
  std::optional<double> time_s = {};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"from_m", &MetricPlace::from_m, "m", any_number, "where the one particle is at the start"},
        Parameter{"to_m", &MetricPlace::to_m, "m", any_number, "where the other particle is at the start"},
        Parameter{"point_m", &MetricPlace::point_m, "m", any_number, "where the particle is at the start"},
        Parameter{"low_m", &MetricPlace::low_m, "m", any_number, "lower corner of a box, in places of the start"},
        Parameter{"high_m", &MetricPlace::high_m, "m", any_number, "upper corner of a box, in places of the start"},
        Parameter{"radius_m", &MetricPlace::radius_m, "m", positive, "distance from the upright axis through the middle of the start"},
        Parameter{"temperature_C", &MetricPlace::temperature_C, "C", above_absolute_zero, "temperature that is reached"},
        Parameter{"dried_share", &MetricPlace::dried_share, "1", open_fraction, "share of its water that has left what is called dry"},
        Parameter{"time_s", &MetricPlace::time_s, "s", non_negative, "time of the frame; the last one unless given"},
    };
  }
};

/// A number that can be measured. One of the two functions is there: it says of what.
struct Metric {
  const char* name;
  const char* unit;
  const char* meaning;
  double (*of_run)(const Results&, const MetricPlace&) = nullptr;
  double (*of_surface)(const Fracture&, const MetricPlace&) = nullptr;
  std::vector<std::string> needs = {};  ///< keys of MetricPlace
  std::vector<std::string> knows = {};  ///< further keys, that have a default
};

/// All metrics, one list after the other: of the ledger, of frames, of fracture surfaces.
const std::vector<Metric>& all_metrics();
std::vector<Metric> ledger_metrics();
std::vector<Metric> frame_metrics();
std::vector<Metric> surface_metrics();

/// The metric of that name. Throws InputError, with the nearest known name.
const Metric& find_metric(std::string_view name);

}  // namespace bake

// SPDX-License-Identifier: MIT
// Metrics: named numbers that are measured of a run or of its fracture surface.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/claims/finite.h"
#include "analysis/claims/fracture.h"
#include "analysis/claims/results.h"
#include "solver/scene/describe.h"

namespace bake {

/// Where and when a metric is measured. Each metric lists the keys that it needs and those that it knows; others are refused.
struct MetricPlace {
  std::optional<Vector3> from_m = {}, to_m = {};
  std::optional<Vector3> point_m = {};
  std::optional<Vector3> low_m = {}, high_m = {};
  std::optional<double> radius_m = {};
  std::optional<double> temperature_C = {};
  std::optional<double> dried_share = {};
  std::optional<std::string> material = {};
  std::optional<double> softened_to = {};
  std::optional<double> reference_time_s = {};
  std::optional<double> time_s = {};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"from_m", &MetricPlace::from_m, "m", any_number, "position of one particle at the start"},
        Parameter{"to_m", &MetricPlace::to_m, "m", any_number, "position of the other particle at the start"},
        Parameter{"point_m", &MetricPlace::point_m, "m", any_number,
                  "position of the particle at the start, or a point of an upright axis"},
        Parameter{"low_m", &MetricPlace::low_m, "m", any_number, "lower corner of a box"},
        Parameter{"high_m", &MetricPlace::high_m, "m", any_number, "upper corner of a box"},
        Parameter{"radius_m", &MetricPlace::radius_m, "m", positive,
                  "distance from the upright axis through the centre of the particles at the start"},
        Parameter{"temperature_C", &MetricPlace::temperature_C, "C", above_absolute_zero, "temperature that is reached"},
        Parameter{"dried_share", &MetricPlace::dried_share, "1", open_fraction,
                  "share of its water that a particle must have lost to count as dry"},
        Parameter{"material", &MetricPlace::material, "", any_number, "name of a material"},
        Parameter{"softened_to", &MetricPlace::softened_to, "1", open_fraction, "yield stress that counts as soft, over that at the start"},
        Parameter{"reference_time_s", &MetricPlace::reference_time_s, "s", non_negative,
                  "time of the frame that counts as the start; the first one unless given"},
        Parameter{"time_s", &MetricPlace::time_s, "s", non_negative, "time of the frame; the last one unless given"},
    };
  }
};

/// Whether a point is in the box of the place, which has no end where no corner is given.
bool is_in_box(const Vector3& point, const MetricPlace& at);

/// How a number is found in a run, or on a surface. It returns what is not finite or throws NoNumber where there is no number: call it by
/// `measure`.
using OfRun = std::function<double(const Results&, const MetricPlace&)>;
using OfSurface = std::function<double(const Fracture&, const MetricPlace&)>;
/// Names of keys of MetricPlace.
using Keys = std::vector<std::string>;

/// A number that can be measured.
struct Metric {
  const char* name;
  const char* unit;
  Range range;  ///< where it can be: a condition that all of this range fulfils claims nothing
  const char* meaning;
  std::variant<OfRun, OfSurface> of;
  Keys needs = {};
  Keys knows = {};  ///< further keys, which have defaults

  bool is_of_run() const { return std::holds_alternative<OfRun>(of); }
};

/// The last two words of a metric's entry.
template <class... Names>
Keys needs(Names... names) {
  return {names...};
}
template <class... Names>
Keys knows(Names... names) {
  return {names...};
}

/// What was measured: a finite number, or why there is none.
struct Measurement {
  double value;
  std::string problem = {};  ///< one line: where the number is missing and what was found; empty if `value` is finite

  Measurement(double number);  // NOLINT(google-explicit-constructor): a number is what was measured
  explicit Measurement(const NoNumber& why);
  bool is_number() const { return problem.empty(); }
};

/// Measures a run or a surface. What is no number is told in the result. Throws InputError if a file, frame, particle or column is missing.
Measurement measure(const Metric& metric, const Results& run, const MetricPlace& place);
Measurement measure(const Metric& metric, const Fracture& surface, const MetricPlace& place);
/// Root mean square of the differences between a metric of a run, at the frames nearest to `times_s`, and as many `values` from elsewhere.
Measurement distance(const Metric& metric, const Results& run, MetricPlace place, const std::vector<double>& times_s,
                     const std::vector<double>& values);

/// All metrics: of the ledger, of frames, of fracture surfaces.
const std::vector<Metric>& all_metrics();
std::vector<Metric> body_metrics();
std::vector<Metric> ledger_metrics();
std::vector<Metric> frame_metrics();
std::vector<Metric> neck_metrics();
std::vector<Metric> region_metrics();
std::vector<Metric> skin_metrics();
std::vector<Metric> surface_metrics();

/// The metric `name`. Throws InputError with the nearest known name if there is none.
const Metric& find_metric(std::string_view name);

}  // namespace bake

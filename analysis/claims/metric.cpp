// SPDX-License-Identifier: MIT
#include "analysis/claims/metric.h"

#include <fmt/format.h>

#include <cmath>

#include "solver/scene/nearest.h"

namespace bake {

Measurement::Measurement(double number)
    : value(number), problem(std::isfinite(number) ? "" : fmt::format("found {}, allowed: a finite number", number)) {}

Measurement::Measurement(const NoNumber& why) : value(std::nan("")), problem(why.what()) {}

namespace {

template <class Function, class Of>
Measurement measured(const Metric& metric, const Of& what, const std::string& where, const MetricPlace& place) {
  try {
    Measurement m = std::get<Function>(metric.of)(what, place);
    if (!m.is_number()) m.problem = fmt::format("{}: {}: {}", where, metric.name, m.problem);
    return m;
  } catch (const NoNumber& why) {
    return Measurement(why);
  }
}

}  // namespace

Measurement measure(const Metric& metric, const Results& run, const MetricPlace& place) {
  return measured<OfRun>(metric, run, run.folder().string(), place);
}

Measurement measure(const Metric& metric, const Fracture& surface, const MetricPlace& place) {
  return measured<OfSurface>(metric, surface, surface.file.string(), place);
}

Measurement distance(const Metric& metric, const Results& run, MetricPlace place, const std::vector<double>& times_s,
                     const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    place.time_s = times_s[i];
    Measurement m = measure(metric, run, place);
    if (!m.is_number()) return m;
    sum += (m.value - values[i]) * (m.value - values[i]);
  }
  return std::sqrt(sum / static_cast<double>(times_s.size()));
}

bool is_in_box(const Vector3& point, const MetricPlace& at) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((at.low_m && point[axis] < (*at.low_m)[axis]) || (at.high_m && point[axis] > (*at.high_m)[axis])) return false;
  return true;
}

const std::vector<Metric>& all_metrics() {
  static const std::vector<Metric> all = [] {
    std::vector<Metric> list = ledger_metrics();
    for (const auto& more : {body_metrics(), frame_metrics(), neck_metrics(), region_metrics(), skin_metrics(), surface_metrics()})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

const Metric& find_metric(std::string_view name) {
  std::vector<std::string> names;
  for (const Metric& metric : all_metrics()) {
    if (metric.name == name) return metric;
    names.emplace_back(metric.name);
  }
  throw InputError(fmt::format("unknown metric '{}'; {}", name, suggestion(name, names)));
}

}  // namespace bake

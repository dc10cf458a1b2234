// SPDX-License-Identifier: MIT
#include "analysis/claims/metric.h"

#include <fmt/format.h>

#include "solver/core/errors.h"
#include "solver/scene/nearest.h"

namespace bake {

const std::vector<Metric>& all_metrics() {
  static const std::vector<Metric> all = [] {
    std::vector<Metric> list = ledger_metrics();
    for (const auto& more : {frame_metrics(), neck_metrics(), region_metrics(), surface_metrics()})
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

// SPDX-License-Identifier: MIT
// Work-precision charts: settled errors against particle-steps and against time; the front in grey, its points numbered as in the page's
// table.
#include <algorithm>

#include "analysis/charts/chart.h"
#include "experiments/accuracy/result.h"

namespace bake::studies::accuracy {

namespace {

using namespace charts;

constexpr Marker k_markers[] = {Marker::disc, Marker::circle, Marker::square, Marker::triangle, Marker::diamond, Marker::cross};

/// Six colours, and with every round of them another marker.
Series series_of(const Curve& curve, std::size_t index, Cost cost) {
  Series s;
  s.name = curve.label;
  s.kind = Kind::line_and_points;
  s.colour = palette(index % 6);
  s.marker = k_markers[(index / 6 + index % 6) % 6];
  s.dash = index < 6 ? Dash::solid : index < 12 ? Dash::dashed : Dash::dotted;
  s.width = index == 0 ? 2.5 : 1;
  for (const Point& p : curve.points)
    if (!p.failed() && p.error > 0 && cost(p) > 0) {
      s.x.push_back(cost(p));
      s.y.push_back(100 * p.error);
    }
  return s;
}

Panel panel_of(const CaseResult& result, const char* title, const Axis& x, Cost cost) {
  Panel panel;
  panel.title = title;
  panel.x = x;
  panel.x.scale = Scale::logarithmic;
  panel.y = {"error", "%", Scale::logarithmic};
  for (std::size_t i = 0; i < result.curves().size(); ++i) {
    Series s = series_of(result.curves()[i], i, cost);
    if (!s.x.empty()) panel.series.push_back(std::move(s));
  }
  Series best;
  best.name = "front";
  best.kind = Kind::line;
  best.colour = "#888888";
  best.width = 4;
  for (const Point* p : front(result.curves(), cost)) {
    if (p->settled <= 0 || cost(*p) <= 0) continue;
    best.x.push_back(cost(*p));
    best.y.push_back(100 * p->settled);
  }
  int number = 0;  // as in the table of the page, in both panels
  for (const Point* p : front(result.curves(), particle_steps))
    if (p->error > 0 && cost(*p) > 0) panel.marks.push_back({cost(*p), 100 * p->error, std::to_string(++number), Side::free, false});
  panel.legend = Legend::right;
  if (!best.x.empty()) panel.series.insert(panel.series.begin(), best);
  return panel;
}

}  // namespace

void write_charts(const CaseResult& result, const std::filesystem::path& folder) {
  Chart chart{result.of().name,
              "Error against particle-steps and against processor time: " + result.of().measured,
              {panel_of(result, "error against particle-steps", {"particle-steps"}, particle_steps),
               panel_of(result, "error against processor time", {"processor time", "s"}, cpu_seconds)},
              1};
  chart.panel_height_in = std::max(3.2, 0.7 + 0.19 * static_cast<double>(chart.panels[0].series.size()));  // one column of names
  if (!chart.panels[0].series.empty() && !chart.panels[1].series.empty()) write_chart(chart, folder);
}

}  // namespace bake::studies::accuracy

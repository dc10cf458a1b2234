// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "experiments/make/pipeline.h"
#include "solver/io/atomic_file.h"

namespace bake {
namespace {

/// Splits "volume_m3" into the quantity and its unit as charts write it.
charts::Axis axis_of_column(const std::string& column) {
  constexpr std::pair<const char*, const char*> k_units[] = {{"_m3", "m$^3$"}, {"_m2", "m$^2$"}, {"_m", "m"},     {"_s", "s"},
                                                             {"_kg", "kg"},    {"_C", "°C"},     {"_mol", "mol"}, {"_J", "J"}};
  std::string name = column;
  std::string unit;
  for (const auto& [suffix, written] : k_units)
    if (unit.empty() && name.ends_with(suffix)) {
      name.resize(name.size() - std::string_view(suffix).size());
      unit = written;
    }
  std::replace(name.begin(), name.end(), '_', ' ');
  return {name, unit};
}

std::string words_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// A metric of each frame.
std::vector<double> metric_over_time(const Results& run, const Metric& metric, MetricPlace place) {
  std::vector<double> values;
  for (const double time : run.column("time_s")) {
    place.time_s = time;
    values.push_back(measure(metric, run, place).value);
  }
  return values;
}

charts::Axis axis_of_metric(const Metric& metric) {
  return {words_of(metric.name), std::string_view(metric.unit) == "1" ? "" : metric.unit};
}

/// Each run as one point: a scan.
charts::Chart chart_of_ends(const FigurePaths& paths, const FigureChart& chart) {
  const Metric &upright = find_metric(chart.metric), &along = find_metric(chart.against);
  charts::Panel panel{"", axis_of_metric(along), axis_of_metric(upright)};
  if (!chart.label.empty()) panel.y.label = chart.label;
  for (const std::string& name : chart.of) {
    const Results run(paths.run(name));
    charts::Series point{words_of(name), charts::Kind::points};
    point.x = {measure(along, run, chart.place).value};
    point.y = {measure(upright, run, chart.place).value};
    point.marker = static_cast<charts::Marker>(panel.series.size() / 6 % 6);  // after six the colours come again
    panel.series.push_back(std::move(point));
  }
  panel.legend = charts::Legend::right;
  return {chart.name, chart.shows, {panel}, 1, 5.2, 3.4};
}

charts::Chart chart_over_time(const FigurePaths& paths, const FigureChart& chart) {
  const std::string column = present_column(chart.column);
  if (column != chart.column) say(paths.options, fmt::format("{} is now called {}; the old name is read until 1.0", chart.column, column));
  const Metric* metric = chart.metric.empty() ? nullptr : &find_metric(chart.metric);
  charts::Panel panel{"", {"time", "s"}, axis_of_column(column)};
  if (metric) panel.y = axis_of_metric(*metric);
  if (!chart.label.empty()) panel.y.label = chart.label;
  for (const std::string& name : chart.of) {
    const Results run(paths.run(name));
    panel.series.push_back({words_of(name), charts::Kind::line, run.column("time_s"),
                            metric ? metric_over_time(run, *metric, chart.place) : run.column_as_it_is(column)});
  }
  for (std::size_t i = 0; i < chart.measured.size(); ++i) {
    const FigureMeasured& measured = *find_named(paths.figure.measured, chart.measured[i]);
    panel.series.push_back({words_of(measured.name), charts::Kind::points, measured.times_s, measured.values});
    panel.series.back().colour = charts::palette(i);
    panel.series.back().marker = charts::Marker::circle;
  }
  panel.legend = panel.series.size() > 1 ? charts::Legend::right : charts::Legend::none;
  return {chart.name, chart.shows, {panel}, 1, 4.4, 2.8};
}

}  // namespace

void make_charts(const FigurePaths& paths, const Computed& computed) {
  for (const FigureChart& chart : paths.figure.charts) {
    say(paths.options, fmt::format("chart {}", chart.name));
    charts::write_chart(chart.of.empty()         ? *find_named(computed.charts, chart.name)
                        : !chart.against.empty() ? chart_of_ends(paths, chart)
                                                 : chart_over_time(paths, chart),
                        paths.item_folder());
  }
}

void write_tables(const FigurePaths& paths, const Computed& computed) {
  std::filesystem::create_directories(paths.item_folder());
  for (const ComputedTable& table : computed.tables) {
    write_text_atomically(paths.item_folder() / (table.name + ".csv"), csv_of(table));
    write_text_atomically(paths.item_folder() / (table.name + ".md"), markdown_of(table));
  }
}

}  // namespace bake

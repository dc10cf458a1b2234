// SPDX-License-Identifier: MIT
// This file decides the style of all charts: sizes, lines, colours, tics.
#include "analysis/charts/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "analysis/charts/labels.h"
#include "analysis/charts/text.h"

namespace bake::charts {
namespace {

constexpr const char* k_font = "Liberation Sans";
constexpr double k_font_pt = 8;
constexpr double k_px_per_in = 96, k_px_per_pt = k_px_per_in / 72;

/// Matplotlib's viridis at nine places: even steps to the eye, in grey and for the colour-blind, too.
constexpr std::array k_viridis{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"};

constexpr int point_type(Marker marker) {
  switch (marker) {
    case Marker::disc:
      return 7;
    case Marker::circle:
      return 6;
    case Marker::square:
      return 5;
    case Marker::triangle:
      return 9;
    case Marker::diamond:
      return 13;
    case Marker::cross:
      return 2;
  }
  return 7;
}

constexpr const char* dash_type(Dash dash) { return dash == Dash::solid ? "1" : dash == Dash::dashed ? "(12,6)" : "(3,4)"; }

constexpr const char* key_place(Legend legend) {
  switch (legend) {
    case Legend::none:
      return "";
    case Legend::top_left:
      return "inside left top Left reverse";
    case Legend::top_right:
      return "inside right top Left reverse";
    case Legend::bottom_left:
      return "inside left bottom Left reverse";
    case Legend::bottom_right:
      return "inside right bottom Left reverse";
    case Legend::right:
      return "outside right top Left reverse";
    case Legend::below:
      return "outside bottom center horizontal Left reverse height 1";  // else it touches the axis' label
  }
  return "";
}

constexpr const char* label_place(Side side) {
  switch (side) {
    case Side::right:
      return "left offset character 0.8,0";
    case Side::left:
      return "right offset character -0.8,0";
    case Side::above:
      return "center offset character 0,0.8";
    case Side::below:
      return "center offset character 0,-0.8";
    case Side::centre:
    case Side::free:  // has been replaced by one of the others
      return "center";
  }
  return "";
}

std::string colour_words(const std::string& colour) { return colour.empty() ? "black" : fmt::format("rgb '{}'", colour); }

Extent shown(const Axis& axis, const Extent& data) { return axis.range ? Extent{axis.range->first, axis.range->second} : data; }

/// A round step that divides the axis into four to eight parts: gnuplot's own steps are too fine for the labels.
double step_of(const Extent& extent) {
  const double length = extent.high > extent.low ? extent.high - extent.low : 1;
  const double ten = std::pow(10, std::floor(std::log10(length / 4)));
  const double steps = length / 4 / ten;  // from 1 to 10
  return steps < 2 ? ten : steps < 5 ? 2 * ten : 5 * ten;
}

/// An axis without a range of its own ends at its next tics.
Extent to_tics(const Axis& axis, const Extent& extent) {
  if (axis.range) return extent;
  if (axis.scale == Scale::logarithmic)
    return {std::pow(10, std::floor(std::log10(extent.low))), std::pow(10, std::ceil(std::log10(extent.high)))};
  const double step = step_of(extent);
  return {step * std::floor(extent.low / step), step * std::ceil(extent.high / step)};
}

std::pair<Extent, Extent> extents(const Panel& panel) {
  Extent x, y;
  for (const Series& series : panel.series) {
    for (const auto* column : {&series.x, &series.x_end}) x.include(*column);
    for (const auto* column : {&series.y, &series.low, &series.high, &series.y_end}) y.include(*column);
  }
  if (panel.heat_map) {
    x.include(panel.heat_map->x_edges);
    y.include(panel.heat_map->y_edges);
  }
  return {x, y};
}

class Script {
 public:
  explicit Script(const Chart& chart) : chart_(chart) {}

  std::string text() {
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) add_data(chart_.panels[i], i);
    add("set encoding utf8\nset minussign\nset datafile missing 'NaN'\n");
    const int columns = std::min<int>(chart_.columns, static_cast<int>(chart_.panels.size()));
    const int rows = (static_cast<int>(chart_.panels.size()) + columns - 1) / columns;
    const double width = columns * chart_.panel_width_in, height = rows * chart_.panel_height_in;
    add("set terminal pdfcairo enhanced color size {}in,{}in font '{},{}' fontscale 0.75 linewidth 1.5 dashlength 0.6\n", width, height,
        k_font, k_font_pt);
    add("set output 'chart.pdf'\n");
    key_spacing_ = 1.15;
    add_panels(rows, columns);
    add("set terminal svg enhanced size {:.0f},{:.0f} font '{},{}' background '#ffffff' linewidth {} dashlength 0.6\n", width * k_px_per_in,
        height * k_px_per_in, k_font, k_font_pt * k_px_per_pt, k_px_per_pt * 0.75);
    add("set output 'chart.svg'\n");
    key_spacing_ = 0.8;  // this terminal overestimates the height of letters
    add_panels(rows, columns);
    return std::move(text_);
  }

 private:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  static std::string number(double value) { return std::isnan(value) ? "NaN" : fmt::format("{}", value); }

  void add_data(const Panel& panel, std::size_t p) {
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      const Series& series = panel.series[s];
      add("$p{}s{} << EOD\n", p, s);
      for (std::size_t i = 0; i < series.x.size(); ++i) {
        add("{}", number(series.x[i]));
        for (const auto* column : {&series.y, &series.low, &series.high, &series.x_end, &series.y_end})
          if (!column->empty()) add(" {}", number((*column)[i]));
        add("\n");
      }
      add("EOD\n");
    }
    if (!panel.heat_map) return;
    const HeatMap& map = *panel.heat_map;
    const std::size_t columns = map.x_edges.size() - 1;
    add("$p{}h << EOD\n", p);
    for (std::size_t i = 0; i < map.value.size(); ++i) {
      const std::size_t row = i / columns, column = i % columns;
      add("{} {} {} {} {}\n", map.x_edges[column], map.y_edges[row], map.x_edges[column + 1], map.y_edges[row + 1], number(map.value[i]));
    }
    add("EOD\n");
  }

  void add_panels(int rows, int columns) {
    if (chart_.panels.size() > 1) add("set multiplot layout {},{}\n", rows, columns);
    for (std::size_t i = 0; i < chart_.panels.size(); ++i) add_panel(chart_.panels[i], i);
    if (chart_.panels.size() > 1) add("unset multiplot\n");
    add("unset output\n");
  }

  void add_axis(const char* name, const Axis& axis, const Extent& extent) {
    const std::string unit = axis.unit.empty() ? "" : " [" + axis.unit + "]";
    add("set {}label {} offset {}\n", name, gnuplot_text(axis.label + unit), name[0] == 'x' ? "0,0.5" : name[0] == 'c' ? "0.8,0" : "0,0");
    if (axis.scale == Scale::logarithmic)
      add("set logscale {0}\nset format {0} '10^{{%L}}'\n", name);
    else
      add("set format {0} '%h'\nset {0}tics {1}\n", name, step_of(extent));
    if (!axis.tics.empty()) {
      std::string tics;
      for (const Tick& tick : axis.tics) tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ", gnuplot_text(tick.text), tick.at);
      add("set {}tics ({})\n", name, tics);
    }
    if (axis.range) add("set {}range [{}:{}]\n", name, axis.range->first, axis.range->second);
  }

  /// Uses estimated sizes in points, because only gnuplot knows the room that axes, tics and legend take.
  std::vector<Side> sides_of(const Panel& panel, const Extent& across, const Extent& up) const {
    constexpr double k_pt_per_in = 72, k_axis = 45, k_legend_below = 25, k_title = 20, k_sample = 35, k_letter = 0.5 * k_font_pt;
    double width = k_pt_per_in * chart_.panel_width_in - k_axis, height = k_pt_per_in * chart_.panel_height_in - k_axis;
    if (!panel.title.empty()) height -= k_title;
    if (panel.legend == Legend::below) height -= k_legend_below;
    if (panel.legend == Legend::right) {
      std::size_t longest = 0;
      for (const Series& series : panel.series) longest = std::max(longest, series.name.size());
      width -= k_sample + k_letter * static_cast<double>(longest);
    }
    return label_sides(panel, to_tics(panel.x, across), to_tics(panel.y, up), width, height, k_font_pt);
  }

  void add_marks(const Panel& panel, const Extent& across, const Extent& up) {
    for (const Rule& rule : panel.rules) {
      if (rule.upright)
        add("set arrow from first {0},graph 0 to first {0},graph 1 nohead back lc rgb '#808080' lw 0.75 dt (4,4)\n"
            "set label {1} at first {0},graph 1 center offset character 0,0.6\n",
            rule.at, gnuplot_text(rule.text));
      else
        add("set arrow from graph 0,first {0} to graph 1,first {0} nohead back lc rgb '#808080' lw 0.75 dt (4,4)\n"
            "set label {1} at graph 1,first {0} left offset character 0.5,0\n",
            rule.at, gnuplot_text(rule.text));
    }
    const std::vector<Side> sides = sides_of(panel, across, up);
    for (std::size_t i = 0; i < panel.marks.size(); ++i) {
      const Mark& mark = panel.marks[i];
      const std::string colour = colour_words(mark.colour);
      add("set label {} at {},{} {} front tc {}", gnuplot_text(mark.text), mark.x, mark.y, label_place(sides[i]), colour);
      if (mark.point) add(" point pt 7 ps 0.6 lc {}", colour);
      add("\n");
    }
  }

  void add_panel(const Panel& panel, std::size_t p) {
    add("reset\nset encoding utf8\nset minussign\nset border 3 lw 0.75\nset tics nomirror out scale 0.6,0.35\nset xtics offset 0,0.3\nset "
        "mxtics default\n");
    add("set style fill noborder\n");
    if (!panel.title.empty()) add("set title {} offset 0,{}\n", gnuplot_text(panel.title), panel.rules.empty() ? -0.4 : 0.6);
    const auto [data_across, data_up] = extents(panel);
    const Extent across = shown(panel.x, data_across), up = shown(panel.y, data_up);
    add_axis("x", panel.x, across);
    add_axis("y", panel.y, up);
    if (panel.equal_aspect) add("set size ratio -1\n");
    if (panel.legend == Legend::none)
      add("unset key\n");
    else
      add("set key {} samplen 2 spacing {} noautotitle\n", key_place(panel.legend), key_spacing_);
    add_marks(panel, across, up);
    std::vector<std::string> curves;
    if (panel.heat_map) curves.push_back(heat_map(*panel.heat_map, p));
    std::size_t next_colour = 0;
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      const Series& series = panel.series[s];
      curves.push_back(curve(series, fmt::format("$p{}s{}", p, s), series.colour.empty() ? palette(next_colour++) : series.colour));
    }
    add("plot {}\n", fmt::join(curves, ", \\\n  "));
  }

  std::string heat_map(const HeatMap& map, std::size_t p) {
    std::string stops;
    for (std::size_t i = 0; i < k_viridis.size(); ++i) stops += fmt::format("{}{} '{}'", i ? ", " : "", i, k_viridis[i]);
    add("set palette defined ({})\nset border 15\n", stops);
    add("set xrange [{}:{}]\nset yrange [{}:{}]\n", map.x_edges.front(), map.x_edges.back(), map.y_edges.front(), map.y_edges.back());
    add("set colorbox vertical noborder\nset cbtics scale 0.6,0.35\n");
    Extent values;
    values.include(map.value);
    add_axis("cb", map.colour, shown(map.colour, values));
    // boxes, not an image: also right on logarithmic axes, and sharp in every viewer
    return fmt::format("$p{}h using (0.5*($1+$3)):(0.5*($2+$4)):1:3:2:4:5 with boxxyerror fs solid 1 noborder lc palette", p);
  }

  static std::string curve(const Series& series, const std::string& data, const std::string& colour) {
    const std::string title = series.in_legend ? "title " + gnuplot_text(series.name) : "notitle";
    const std::string line = fmt::format("lc rgb '{}' lw {} dt {}", colour, series.width, dash_type(series.dash));
    const std::string points = fmt::format("pt {} ps 0.6", point_type(series.marker));
    switch (series.kind) {
      case Kind::line:
        return fmt::format("{} using 1:2 with lines {} {}", data, line, title);
      case Kind::points:
        return fmt::format("{} using 1:2 with points lc rgb '{}' {} {}", data, colour, points, title);
      case Kind::line_and_points:
        return fmt::format("{} using 1:2 with linespoints {} {} {}", data, line, points, title);
      case Kind::error_bars:
        return fmt::format("{} using 1:2:3:4 with yerrorlines {} {} {}", data, line, points, title);
      case Kind::band:
        return fmt::format("{} using 1:2:3 with filledcurves fs transparent solid 0.25 lc rgb '{}' {}", data, colour, title);
      case Kind::arrows:
        return fmt::format("{} using 1:2:($3-$1):($4-$2) with vectors head filled size character 0.7,20,60 {} {}", data, line, title);
    }
    return {};
  }

  const Chart& chart_;
  std::string text_;
  double key_spacing_ = 1;  ///< of the terminal that is being written
};

}  // namespace

std::string palette(std::size_t index) {
  static constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
  return colours[index % colours.size()];
}

std::string ramp(double share) {
  constexpr double k_first = 1.7, k_last = 7.2;  // the ends would be invisible on a dark or on a light page
  const double place = k_first + std::clamp(share, 0., 1.) * (k_last - k_first);
  const auto stop = static_cast<std::size_t>(place);
  const double into = place - static_cast<double>(stop);
  std::string result = "#";
  for (int channel = 0; channel < 3; ++channel) {
    const auto of = [&](const char* colour) { return std::stoi(std::string(colour + 1 + 2 * channel, 2), nullptr, 16); };
    result += fmt::format("{:02x}", static_cast<int>(std::lround((1 - into) * of(k_viridis[stop]) + into * of(k_viridis[stop + 1]))));
  }
  return result;
}

std::string gnuplot_script(const Chart& chart) { return Script(chart).text(); }

}  // namespace bake::charts

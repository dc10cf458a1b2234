// SPDX-License-Identifier: MIT
#include "experiments/report/time_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <sstream>

#include "solver/scene/entry.h"

namespace bake::report {
namespace {

constexpr double k_width = 380, k_height = 200, k_left = 48, k_right = 14, k_top = 28, k_bottom = 28, k_letters = 13;
constexpr std::size_t k_points = 160;  ///< most points of a line

/// The cells of a line of CSV [RFC 4180], without line breaks in cells.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

struct Heading {
  std::string name, label, unit;
};

/// "<name>: <label> [<unit>]", the unit being optional.
std::optional<Heading> heading_of(const std::string& cell) {
  const std::size_t colon = cell.find(": ");
  if (colon == std::string::npos) return std::nullopt;
  Heading heading{cell.substr(0, colon), cell.substr(colon + 2), ""};
  if (const std::size_t bracket = heading.label.rfind(" ["); bracket != std::string::npos && heading.label.ends_with(']')) {
    heading.unit = heading.label.substr(bracket + 2, heading.label.size() - bracket - 3);
    heading.label.resize(bracket);
  }
  return heading;
}

/// Where a chart of these headings has its lines; none if it is not one over time.
std::optional<TimeChart> chart_of(const std::vector<std::string>& cells) {
  if (cells.size() < 2 || cells.size() % 2 != 0) return std::nullopt;
  TimeChart chart;
  for (std::size_t c = 0; c < cells.size(); c += 2) {
    const auto time = heading_of(cells[c]), value = heading_of(cells[c + 1]);
    if (!time || !value || time->label != "time" || time->unit != "s" || value->label == "text") return std::nullopt;
    if (c > 0 && (value->label != chart.label || value->unit != chart.unit)) return std::nullopt;  // panels of several quantities
    chart.label = value->label;
    chart.unit = value->unit;
    chart.lines.push_back({value->name, {}, {}});
  }
  return chart;
}

double number_in(const std::string& cell) {
  double value = std::nan("");
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

/// From numbers to places in the picture.
struct Axes {
  double low, high, end;
  double right = k_right;  ///< room for the names of lines
  double x(double time) const { return k_left + (k_width - k_left - right) * time / end; }
  double y(double value) const { return k_height - k_bottom - (k_height - k_bottom - k_top) * (value - low) / (high - low); }
};

std::string path_of(const TimeLine& line, const Axes& axes) {
  std::string path;
  bool is_down = false;
  const auto go_to = [&](std::size_t i) {
    const bool is_there = std::isfinite(line.value[i]) && std::isfinite(line.time_s[i]);
    if (is_there) path += fmt::format("{}{:.1f} {:.1f}", is_down ? "L" : "M", axes.x(line.time_s[i]), axes.y(line.value[i]));
    is_down = is_there;
  };
  const std::size_t every = std::max<std::size_t>(1, line.time_s.size() / k_points);
  for (std::size_t i = 0; i < line.time_s.size(); i += every) go_to(i);
  if (!line.time_s.empty()) go_to(line.time_s.size() - 1);
  return path;
}

double last_value(const TimeLine& line) {
  for (std::size_t i = line.value.size(); i-- > 0;)
    if (std::isfinite(line.value[i])) return line.value[i];
  return 0;
}

/// Heights of the names beside the ends of their lines, far enough from each other to be read.
std::vector<double> heights_of_names(const TimeChart& chart, const Axes& axes) {
  std::vector<std::size_t> order(chart.lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto end = [&](std::size_t i) { return axes.y(last_value(chart.lines[i])); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return end(a) < end(b); });
  std::vector<double> heights(chart.lines.size());
  double lowest = k_height - k_bottom - k_letters * static_cast<double>(order.size() - 1), above = k_top;
  for (const std::size_t i : order) {
    heights[i] = std::max(above, std::min(end(i) + 4, lowest + 4));
    above = heights[i] + k_letters;
    lowest += k_letters;
  }
  return heights;
}

Axes axes_of(const TimeChart& chart) {
  double low = INFINITY, high = -INFINITY, end = 0;
  for (const TimeLine& line : chart.lines) {
    for (const double value : line.value)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    for (const double time : line.time_s)
      if (std::isfinite(time)) end = std::max(end, time);
  }
  if (!(high >= low)) low = high = 0;
  if (low > 0 && low < 0.5 * high) low = 0;
  if (high == low) high = low + 1;
  return {low, high, end > 0 ? end : 1};
}

}  // namespace

std::optional<TimeChart> read_time_chart(const std::filesystem::path& csv) {
  std::istringstream in(read_text_file(csv));
  std::string line;
  std::getline(in, line);
  auto chart = chart_of(cells_of(line));
  while (chart && std::getline(in, line)) {
    const std::vector<std::string> cells = cells_of(line);
    for (std::size_t c = 0; c + 1 < cells.size() && c / 2 < chart->lines.size(); c += 2) {
      if (cells[c].empty()) continue;
      chart->lines[c / 2].time_s.push_back(number_in(cells[c]));
      chart->lines[c / 2].value.push_back(number_in(cells[c + 1]));
    }
  }
  return chart;
}

std::vector<double> round_numbers(double low, double high) {
  const double power = std::pow(10, std::floor(std::log10((high - low) / 4)));
  std::vector<double> numbers;
  for (const double s : {10.0, 5.0, 2.5, 2.0, 1.0}) {
    const double step = s * power;
    numbers.clear();
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) numbers.push_back(k * step + 0.0);  // never -0
    if (numbers.size() >= 4) break;
  }
  return numbers;
}

std::string common_start(const std::vector<std::string>& names) {
  if (names.size() < 2) return "";
  std::string common = names.front();
  for (const std::string& name : names) {
    const auto end = std::mismatch(common.begin(), common.end(), name.begin(), name.end()).first;
    common.erase(end, common.end());
  }
  const std::size_t last = common.find_last_of("_ ");
  return last == std::string::npos ? "" : common.substr(0, last + 1);
}

std::string short_name(const std::string& name, const std::string& common) {
  std::string words = name.starts_with(common) && name.size() > common.size() ? name.substr(common.size()) : name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

Html drawn(const TimeChart& chart, std::string_view shows, std::string_view follows) {
  std::vector<std::string> names;
  for (const TimeLine& line : chart.lines) names.push_back(line.name);
  const std::string common = common_start(names);
  Axes axes = axes_of(chart);
  const std::vector<double> values = round_numbers(axes.low, axes.high);
  if (!values.empty()) axes.high = std::max(axes.high, values.back());
  if (names.size() > 1) {
    std::size_t longest = 0;
    for (const std::string& name : names) longest = std::max(longest, short_name(name, common).size());
    axes.right = std::min(130.0, 12 + 6.2 * static_cast<double>(longest));
  }
  const double right = k_width - axes.right, bottom = k_height - k_bottom;
  std::string code = fmt::format("<text class=\"title\" x=\"4\" y=\"14\">{}{}</text>", text(chart.label).code,
                                 chart.unit.empty() ? "" : " [" + text(chart.unit).code + "]");
  for (const double value : values)
    code += fmt::format(
        "<line class=\"rule\" x1=\"{0}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/><text class=\"end\" x=\"{3}\" "
        "y=\"{4:.1f}\">{5}</text>",
        k_left, right, axes.y(value), k_left - 6, axes.y(value) + 4, text(with_signs(fmt::format("{:.3g}", value))).code);
  for (const double time : round_numbers(0, axes.end))
    code += fmt::format("<text class=\"middle\" x=\"{:.1f}\" y=\"{}\">{:.3g}{}</text>", axes.x(time), k_height - 10, time,
                        time > 0 ? " s" : "");
  const std::vector<double> heights = heights_of_names(chart, axes);
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    code += fmt::format("<path class=\"line colour{}\" d=\"{}\"/>", i % 6, path_of(chart.lines[i], axes));
    if (names.size() > 1)
      code += fmt::format("<text class=\"name colour{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", i % 6, right + 6, heights[i],
                          text(short_name(names[i], common)).code);
  }
  if (!follows.empty())
    code += fmt::format(
        "<line class=\"cursor\" y1=\"{}\" y2=\"{}\" x1=\"{:.1f}\" x2=\"{:.1f}\" data-left=\"{}\" data-right=\"{:.1f}\" data-end=\"{}\"/>",
        k_top - 4, bottom, right, right, k_left, right, axes.end);
  return element("svg", {code},
                 fmt::format("class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\"{}", k_width, k_height, text(shows).code,
                             follows.empty() ? "" : fmt::format(" data-follows=\"{}\"", follows)));
}

}  // namespace bake::report

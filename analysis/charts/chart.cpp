// SPDX-License-Identifier: MIT
#include "analysis/charts/chart.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "analysis/charts/gnuplot.h"
#include "analysis/charts/text.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/io/scratch_folder.h"
#include "solver/scene/entry.h"

namespace bake::charts {
namespace {

namespace fs = std::filesystem;

// --- is it well-formed? ---------------------------------------------------------------------------------------------

[[noreturn]] void refuse(const Chart& chart, const std::string& what) {
  throw std::invalid_argument(fmt::format("chart {}: {}", chart.name, what));
}

void check_axis(const Chart& chart, const Axis& axis, const std::string& series, const std::vector<double>& column) {
  if (axis.scale != Scale::logarithmic) return;
  for (const double value : column)
    if (value <= 0) refuse(chart, fmt::format("{}: {} cannot stand on the logarithmic axis '{}'", series, value, axis.label));
}

void check_series(const Chart& chart, const Panel& panel, const Series& series) {
  const std::size_t n = series.x.size();
  const bool bars = series.kind == Kind::error_bars || series.kind == Kind::band, arrows = series.kind == Kind::arrows;
  if (n == 0) refuse(chart, fmt::format("{}: no numbers", series.name));
  if (series.y.size() != (series.kind == Kind::band ? 0 : n) || series.low.size() != (bars ? n : 0) ||
      series.high.size() != (bars ? n : 0) || series.x_end.size() != (arrows ? n : 0) || series.y_end.size() != (arrows ? n : 0))
    refuse(chart, fmt::format("{}: columns of unequal length", series.name));
  for (const auto* column : {&series.x, &series.x_end}) check_axis(chart, panel.x, series.name, *column);
  for (const auto* column : {&series.y, &series.low, &series.high, &series.y_end}) check_axis(chart, panel.y, series.name, *column);
}

void check(const Chart& chart) {
  if (chart.panels.empty() || chart.columns < 1) refuse(chart, "no panels");
  for (const Panel& panel : chart.panels) {
    if (panel.series.empty() && !panel.heat_map) refuse(chart, "a panel has nothing to draw");
    for (const Series& series : panel.series) check_series(chart, panel, series);
    if (!panel.heat_map) continue;
    const HeatMap& map = *panel.heat_map;
    if (map.x_edges.size() < 2 || map.y_edges.size() < 2 || map.value.size() != (map.x_edges.size() - 1) * (map.y_edges.size() - 1))
      refuse(chart, "a heat map needs a value for each cell between its edges");
    check_axis(chart, map.colour, "heat map", map.value);
  }
}

// --- CSV ------------------------------------------------------------------------------------------------------------

struct Column {
  std::string heading;
  std::vector<std::string> cells;
};

std::string heading(const std::string& group, const Axis& axis, const char* which = "") {
  return fmt::format("{}: {}{}{}", group, plain_text(axis.label), which, axis.unit.empty() ? "" : " [" + plain_text(axis.unit) + "]");
}

void add_numbers(std::vector<Column>& columns, std::string heading, const std::vector<double>& values) {
  if (values.empty()) return;
  Column column{std::move(heading), {}};
  for (const double value : values) column.cells.push_back(std::isnan(value) ? "" : fmt::format("{}", value));
  columns.push_back(std::move(column));
}

void add_heat_map(std::vector<Column>& columns, const std::string& group, const Panel& panel) {
  const HeatMap& map = *panel.heat_map;
  const std::size_t across = map.x_edges.size() - 1;
  std::vector<double> ends[4];
  for (std::size_t i = 0; i < map.value.size(); ++i) {
    const std::size_t row = i / across, column = i % across;
    ends[0].push_back(map.x_edges[column]);
    ends[1].push_back(map.x_edges[column + 1]);
    ends[2].push_back(map.y_edges[row]);
    ends[3].push_back(map.y_edges[row + 1]);
  }
  add_numbers(columns, heading(group, panel.x, " from"), ends[0]);
  add_numbers(columns, heading(group, panel.x, " to"), ends[1]);
  add_numbers(columns, heading(group, panel.y, " from"), ends[2]);
  add_numbers(columns, heading(group, panel.y, " to"), ends[3]);
  add_numbers(columns, heading(group, map.colour), map.value);
}

void add_marks(std::vector<Column>& columns, const std::string& group, const Panel& panel) {
  Column text{group + ": text", {}};
  std::vector<double> x, y;
  for (const Mark& mark : panel.marks) {
    text.cells.push_back(plain_text(mark.text));
    x.push_back(mark.x);
    y.push_back(mark.y);
  }
  for (const Rule& rule : panel.rules) {
    text.cells.push_back(plain_text(rule.text));
    x.push_back(rule.upright ? rule.at : NAN);
    y.push_back(rule.upright ? NAN : rule.at);
  }
  if (text.cells.empty()) return;
  columns.push_back(std::move(text));
  add_numbers(columns, heading(group, panel.x), x);
  add_numbers(columns, heading(group, panel.y), y);
}

std::vector<Column> csv_columns(const Chart& chart) {
  std::vector<Column> columns;
  for (std::size_t p = 0; p < chart.panels.size(); ++p) {
    const Panel& panel = chart.panels[p];
    const std::string name = panel.title.empty() ? fmt::format("panel {}", p + 1) : plain_text(panel.title);
    const std::string prefix = chart.panels.size() > 1 ? name + ": " : "";
    for (const Series& series : panel.series) {
      const std::string group = prefix + plain_text(series.name);
      add_numbers(columns, heading(group, panel.x), series.x);
      add_numbers(columns, heading(group, panel.y), series.y);
      add_numbers(columns, heading(group, panel.y, " low"), series.low);
      add_numbers(columns, heading(group, panel.y, " high"), series.high);
      add_numbers(columns, heading(group, panel.x, " end"), series.x_end);
      add_numbers(columns, heading(group, panel.y, " end"), series.y_end);
    }
    if (panel.heat_map) add_heat_map(columns, prefix + "heat map", panel);
    add_marks(columns, prefix + "marks", panel);
  }
  return columns;
}

// --- gnuplot --------------------------------------------------------------------------------------------------------

std::string shell_word(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += "'\\'";  // ends the quotation, adds an escaped quote, begins again
    result += c;
  }
  return result + "'";
}

/// Gnuplot's message in one line. Gnuplot prints the place, a caret below it, then "chart.gp" line 7: message.
std::string gist(const std::string& said) {
  const std::size_t place = said.find("line ");
  std::string words = said.substr(place == std::string::npos ? 0 : place);
  std::replace(words.begin(), words.end(), '\n', ' ');
  words.erase(words.find_last_not_of(' ') + 1);
  return words.empty() ? "no message" : words;
}

void run_gnuplot(const ScratchFolder& scratch, const Chart& chart) {
  {
    std::ofstream script(scratch / "chart.gp", std::ios::binary);
    script << gnuplot_script(chart);
    if (!script.flush()) throw OutputError((scratch / "chart.gp").string() + ": cannot be written");
  }
  FILE* pipe = ::popen(fmt::format("cd {} && exec gnuplot chart.gp 2>&1", shell_word(scratch.path().string())).c_str(), "r");
  if (pipe == nullptr) throw OutputError(chart.name + ": gnuplot could not be started");
  std::string said;
  std::array<char, 512> part;
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), pipe)) said.append(part.data(), got);
  const int status = ::pclose(pipe);
  constexpr int k_not_found = 127;  // the shell's exit code for a missing command
  if (WIFEXITED(status) && WEXITSTATUS(status) == k_not_found)
    throw InputError("gnuplot is missing: apt-get install gnuplot-nox fonts-liberation");
  if (status != 0 || !fs::exists(scratch / "chart.svg") || !fs::exists(scratch / "chart.pdf"))
    throw OutputError(fmt::format("{}: gnuplot failed: {}", chart.name, gist(said)));
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
}

std::string xml_escaped(std::string text) {
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, ">", "&gt;");
  return text;
}

/// Adds to gnuplot's SVG the title for screen readers, fonts for machines without ours, and colours for dark pages.
std::string finished_svg(std::string svg, const Chart& chart) {
  constexpr std::string_view k_dark =
      "<style>@media (prefers-color-scheme: dark) { rect[fill=\"#ffffff\"] { fill: #16191d } [color=\"black\"] { color: #e8e8e8 } "
      "[fill=\"black\"] { fill: #e8e8e8 } [stroke=\"black\"] { stroke: #e8e8e8 } }</style>";
  replace_all(svg, "font-family=\"Liberation Sans\"", "font-family=\"Liberation Sans, Arial, Helvetica, sans-serif\"");
  replace_all(svg, "<text>", "<text xml:space=\"preserve\">");  // spaces before and after a change of letters
  replace_all(svg, "<title>Gnuplot</title>", fmt::format("<title>{}</title>\n{}", xml_escaped(chart.title), k_dark));
  return svg;
}

}  // namespace

std::string csv_of(const Chart& chart) {
  const std::vector<Column> columns = csv_columns(chart);
  std::size_t rows = 0;
  std::string text;
  for (const Column& column : columns) {
    rows = std::max(rows, column.cells.size());
    if (!text.empty()) text += ',';
    text += csv_cell(column.heading);
  }
  text += '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) text += ',';
      if (row < columns[c].cells.size()) text += csv_cell(columns[c].cells[row]);
    }
    text += '\n';
  }
  return text;
}

void write_chart(const Chart& chart, const fs::path& folder) {
  check(chart);
  const ScratchFolder scratch;
  run_gnuplot(scratch, chart);
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw OutputError(fmt::format("{}: cannot create: {}", folder.string(), failed.message()));
  const auto write = [&](const char* extension, const std::string& text) {
    write_text_atomically(folder / (chart.name + extension), text);
  };
  write(".csv", csv_of(chart));
  write(".svg", finished_svg(read_text_file(scratch / "chart.svg"), chart));
  write(".pdf", read_text_file(scratch / "chart.pdf"));
}

}  // namespace bake::charts

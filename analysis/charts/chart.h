// SPDX-License-Identifier: MIT
// Charts as plain data, and their files: <name>.csv, <name>.svg for the page, <name>.pdf for print.
//
// Texts are UTF-8 and appear as they are; only between dollar signs they are mathematics: letters become italic, `_` and `^` lower
// and raise the next character or {group}, and a group of several letters stays upright: "$τ_y$", "$p_{tr}$", "m$^2$". "$$" is a dollar.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bake::charts {

enum class Scale { linear, logarithmic };

struct Tick {
  double at = 0;
  std::string text;
};

struct Axis {
  std::string label;                                    ///< "yield stress $τ_y$"
  std::string unit = {};                                ///< "Pa"; stands in brackets behind the label; "" for numbers without one
  Scale scale = Scale::linear;                          ///< logarithmic: every value is above zero
  std::optional<std::pair<double, double>> range = {};  ///< default: the range of the data
  std::vector<Tick> tics = {};                          ///< the tics; empty: at round numbers
};

enum class Kind { line, points, line_and_points, error_bars, band, arrows };
enum class Dash { solid, dashed, dotted };
enum class Marker { disc, circle, square, triangle, diamond, cross };

/// A series of numbers with one name and one style. NaN makes a gap.
struct Series {
  std::string name;  ///< in the legend and in the CSV
  Kind kind = Kind::line;
  std::vector<double> x = {}, y = {};
  std::vector<double> low = {}, high = {};     ///< error_bars: ends of the bars about y; band: filled between the two (y stays empty)
  std::vector<double> x_end = {}, y_end = {};  ///< arrows: from (x, y) to here
  std::string colour = {};                     ///< "#rrggbb"; default: the next colour of the palette
  Dash dash = Dash::solid;
  Marker marker = Marker::disc;
  double width = 1.5;     ///< of lines [pt]
  bool in_legend = true;  ///< false: it is named elsewhere, for instance by a Mark
};

/// Cells between x_edges and y_edges, coloured by value[row * columns + column]; rows go along y. NaN leaves a cell empty.
struct HeatMap {
  std::vector<double> x_edges, y_edges;
  std::vector<double> value;
  Axis colour = {};  ///< of the colour bar
};

/// On which side of its point a text stands; free: where it covers least of what else is drawn.
enum class Side { right, left, above, below, centre, free };

/// A text at a position in the panel, with or without a point there.
struct Mark {
  double x = 0, y = 0;
  std::string text = {};
  Side side = Side::right;
  bool point = true;
  std::string colour = {};  ///< of point and text; default: black on a light page
};

/// A thin dashed line across the whole panel, at x = at (upright) or y = at, with its text at the far end.
struct Rule {
  bool upright = true;
  double at = 0;
  std::string text = {};
};

enum class Legend { none, top_left, top_right, bottom_left, bottom_right, right, below };

struct Panel {
  std::string title;  ///< above the panel; "" for none
  Axis x, y;
  std::vector<Series> series = {};
  std::optional<HeatMap> heat_map = {};
  std::vector<Mark> marks = {};
  std::vector<Rule> rules = {};
  Legend legend = Legend::none;
  bool equal_aspect = false;  ///< one unit is as long on both axes
};

struct Chart {
  std::string name;           ///< of the files, without extension
  std::string title;          ///< what it shows, in one line without mathematics: for the page; not drawn
  std::vector<Panel> panels;  ///< side by side, row by row
  int columns = 2;            ///< panels per row
  double panel_width_in = columns == 1 ? 6 : columns == 2 ? 3.3 : 2.35;  ///< three as wide as a page
  double panel_height_in = columns <= 2 ? 2.6 : 2.2;
};

/// The palette for categories: six colours that colour-blind readers can tell apart (Okabe and Ito), on light and dark pages.
std::string palette(std::size_t index);
/// Colours for an ordered quantity: from the blue (0) to the yellow-green (1) of viridis. The ends are cut off so that all are visible.
std::string ramp(double share);

/// All numbers of the chart as CSV: a group of columns for each series, heat map, marks and rules, with labels and units in the headings.
std::string csv_of(const Chart& chart);

/// Writes <folder>/<name>.csv, .svg and .pdf, all or none, and creates the folder if it is missing. Throws InputError if gnuplot is missing
/// (it tells what to install), OutputError with gnuplot's message if gnuplot fails or a file cannot be written, and std::invalid_argument
/// if the chart is not well-formed (columns of unequal length, nothing to draw, a number that a logarithmic axis cannot show).
void write_chart(const Chart& chart, const std::filesystem::path& folder);

}  // namespace bake::charts

// SPDX-License-Identifier: MIT
// Charts over time, drawn for the page from their CSV: they share its colours, and the time that the body beside them shows.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/report/html.h"

namespace bake::report {

/// A quantity over time.
struct TimeLine {
  std::string name;
  std::vector<double> time_s, value;
};
struct TimeChart {
  std::string label, unit;  ///< of the quantity
  std::vector<TimeLine> lines;
};

/// The chart in a file of charts::csv_of if all of its columns come in pairs "<name>: time [s]" and "<name>: <label> [<unit>]"; else none.
/// Throws InputError if the file cannot be read.
std::optional<TimeChart> read_time_chart(const std::filesystem::path& csv);

/// The chart as SVG with the alternative text `shows`. `follows`: the anchor of the body whose time it shows; "" for none.
Html drawn(const TimeChart& chart, std::string_view shows, std::string_view follows);

/// Round numbers from low to high, about four.
std::vector<double> round_numbers(double low, double high);

/// What names have in common at their start, up to a `_`: "bread_" of "bread_one" and "bread_two"; nothing of a single name.
std::string common_start(const std::vector<std::string>& names);
/// The name as words, without what it has in common with the others.
std::string short_name(const std::string& name, const std::string& common);

}  // namespace bake::report

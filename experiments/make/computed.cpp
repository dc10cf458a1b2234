// SPDX-License-Identifier: MIT
#include "experiments/make/computed.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/charts/text.h"

namespace bake {

const std::vector<ComputedItem>& computed_items() {
  static const std::vector<ComputedItem> items{
      {"fig07_yield_surface", fig07_yield_surface}, {"fig08_curves", fig08_curves},       {"fig12_co2_rate", fig12_co2_rate},
      {"fig14_return_map", fig14_return_map},       {"table01_timings", table01_timings}, {"table02_parameters", table02_parameters},
  };
  return items;
}

const ComputedItem* find_computed(std::string_view experiment) {
  for (const ComputedItem& item : computed_items())
    if (item.experiment == experiment) return &item;
  return nullptr;
}

ComputedNames names_of(const Computed& computed) {
  ComputedNames names;
  for (const auto& chart : computed.charts) names.charts.push_back(chart.name);
  for (const auto& number : computed.numbers) names.numbers.push_back({number.name, number.range});
  return names;
}

namespace {

/// The width on the terminal: the number of bytes that begin a UTF-8 character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string row_of(const std::vector<std::string>& cells, const char* before, const char* between, const char* after) {
  return fmt::format("{}{}{}\n", before, fmt::join(cells, between), after);
}

std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

template <class Change>
std::vector<std::string> changed(std::vector<std::string> cells, Change change) {
  std::transform(cells.begin(), cells.end(), cells.begin(), change);
  return cells;
}

}  // namespace

std::string text_of(const ComputedTable& table) {
  auto all = table.rows;
  all.insert(all.begin(), table.header);
  std::vector<std::size_t> widths(table.header.size());
  for (const auto& row : all)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  std::string text = table.title + "\n";
  for (const auto& row : all) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += "  " + row[i] + std::string(widths[i] - width_of(row[i]), ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string csv_of(const ComputedTable& table) {
  std::string text = row_of(changed(table.header, charts::csv_cell), "", ",", "");
  for (const auto& row : table.rows) text += row_of(changed(row, charts::csv_cell), "", ",", "");
  return text;
}

std::string markdown_of(const ComputedTable& table) {
  std::string text = table.title + "\n\n" + row_of(changed(table.header, markdown_cell), "| ", " | ", " |");
  text += row_of(std::vector<std::string>(table.header.size(), "---"), "|", "|", "|");
  for (const auto& row : table.rows) text += row_of(changed(row, markdown_cell), "| ", " | ", " |");
  return text;
}

}  // namespace bake

// SPDX-License-Identifier: MIT
#include "figures/computed.h"

#include <fmt/format.h>

#include <algorithm>

namespace bake {

const std::vector<ComputedItem>& computed_items() {
  static const std::vector<ComputedItem> items{};
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
  for (const auto& number : computed.numbers) names.numbers.push_back(number.name);
  return names;
}

std::string text_of(const ComputedTable& table) {
  std::vector<std::size_t> widths(table.header.size());
  auto all = table.rows;
  all.insert(all.begin(), table.header);
  for (const auto& row : all)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text = table.title + "\n";
  for (const auto& row : all) {
    for (std::size_t i = 0; i < row.size(); ++i) text += fmt::format("  {:<{}}", row[i], widths[i]);
    text += "\n";
  }
  return text;
}

}  // namespace bake

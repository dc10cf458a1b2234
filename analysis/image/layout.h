// SPDX-License-Identifier: MIT
// Grids of cells that are written as a drawing of names. A name in cells that touch fills all of them:
//
//     apples   loaf  loaf  cookies
//     pancake  loaf  loaf  bread
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace bake {

/// The cells that one name fills, counted from the upper left corner.
struct Place {
  std::string name;
  int column, row, columns, rows;
};

/// The names of one row.
inline std::vector<std::string> names_of_row(const std::string& row) {
  std::istringstream in(row);
  std::vector<std::string> names;
  for (std::string name; in >> name;) names.push_back(name);
  return names;
}

/// A grid's places in the order in which their names appear, or what is wrong with it.
struct Layout {
  std::vector<Place> places;
  int columns = 0, rows = 0;
  std::string problem;  ///< one line; empty if the grid is one
};

/// Every name must fill a rectangle, and all rows must have as many cells.
inline Layout layout_of(const std::vector<std::string>& rows) {
  Layout layout;
  layout.rows = static_cast<int>(rows.size());
  std::vector<std::vector<std::string>> cells;
  cells.reserve(rows.size());
  for (const std::string& row : rows) cells.push_back(names_of_row(row));
  if (cells.empty() || cells.front().empty()) return {{}, 0, 0, "found no cell, allowed: rows of names"};
  layout.columns = static_cast<int>(cells.front().size());
  for (std::size_t y = 0; y < cells.size(); ++y) {
    if (cells[y].size() != cells.front().size())
      return {{},
              0,
              0,
              "found rows of " + std::to_string(cells.front().size()) + " and " + std::to_string(cells[y].size()) +
                  " cells, allowed: as many in each"};
    for (std::size_t x = 0; x < cells[y].size(); ++x) {
      const int column = static_cast<int>(x), row = static_cast<int>(y);
      const auto known = std::find_if(layout.places.begin(), layout.places.end(), [&](const Place& p) { return p.name == cells[y][x]; });
      if (known == layout.places.end()) {
        layout.places.push_back({cells[y][x], column, row, 1, 1});
        continue;
      }
      known->columns = std::max(known->columns, column - known->column + 1);
      known->rows = row - known->row + 1;
    }
  }
  for (const Place& place : layout.places)
    for (int y = 0; y < layout.rows; ++y)
      for (int x = 0; x < layout.columns; ++x) {
        const bool is_inside = x >= place.column && x < place.column + place.columns && y >= place.row && y < place.row + place.rows;
        if (is_inside != (cells[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == place.name))
          return {{}, 0, 0, "found cells of '" + place.name + "' that are no rectangle, allowed: cells that fill one"};
      }
  return layout;
}

}  // namespace bake

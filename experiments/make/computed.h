// SPDX-License-Identifier: MIT
// Items without a simulation: their charts, tables and numbers are computed by a function in experiments/<item>/*.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/charts/chart.h"
#include "experiments/make/figure_file.h"

namespace bake {

/// A number that claims refer to by its name.
struct ComputedNumber {
  std::string name;
  std::string unit;
  std::string meaning;
  double value;
  Range range = any_number;  ///< where it can be: a claim that all of this range fulfils is refused
};

/// A table whose cells are formatted for the terminal and the page.
struct ComputedTable {
  std::string name;
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header
};

struct Computed {
  std::vector<charts::Chart> charts;
  std::vector<ComputedNumber> numbers;
  std::vector<ComputedTable> tables;
};

/// An experiment's function.
struct ComputedItem {
  const char* experiment;
  Computed (*compute)();
};

/// All of them. To add one, add a line in computed.cpp.
const std::vector<ComputedItem>& computed_items();

/// Figure 7: the yield surface for several porosities, as the solver's return mapping without viscosity finds it.
Computed fig07_yield_surface();
/// Figure 8: yield stress and viscosity against temperature, on the way up and, past gelatinisation, on the way down.
Computed fig08_curves();
/// Figure 12: rate of the leavening against temperature, and the gas that the solver makes of it in a block that is warmed.
Computed fig12_co2_rate();
/// Figure 14: trial stresses and their images, without and with viscosity, without and with pores.
Computed fig14_return_map();
/// Table 1: published timings beside those of the runs that are in ./results, or stored in experiments/table01_timings/measured; or with
/// the published numbers of the sources in `root` and the runs in the folder `results`. Throws InputError.
Computed table01_timings();
Computed compare_timings(const std::filesystem::path& root, const std::filesystem::path& results);
/// Table 2: every published parameter beside what the scene of that column states; or that of the sources in `root`:
/// reference/published/table2.toml and table2_scenes.toml, and experiments/. Throws InputError.
Computed table02_parameters();
Computed compare_parameters(const std::filesystem::path& root);

/// The function of the experiment in that folder, or nullptr if it has none.
const ComputedItem* find_computed(std::string_view experiment);

/// The names that a figure.toml may use.
ComputedNames names_of(const Computed& computed);

/// The table in columns, for the terminal.
std::string text_of(const ComputedTable& table);
/// The table as CSV (RFC 4180), for programs.
std::string csv_of(const ComputedTable& table);
std::string markdown_of(const ComputedTable& table);

}  // namespace bake

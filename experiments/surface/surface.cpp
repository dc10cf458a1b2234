// SPDX-License-Identifier: MIT
#include "experiments/surface/surface.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "experiments/common/study.h"

namespace bake::studies {

namespace {

std::string ratios(const Areas& a) {
  std::vector<std::string> words;
  for (const double r : a.ratios) words.push_back(fmt::format("{:.3f}", r));
  return fmt::format("{}", fmt::join(words, " | "));
}

std::string claim(const Areas& a) {
  if (a.form == "published") return "none: as it is";
  return fmt::format("largest error {:.4f}, at most {}: {}", largest_error(a), claim_of(a).most, holds(a) ? "holds" : "MISSED");
}

nlohmann::json as_json(const std::vector<Areas>& all) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Areas& a : all) {
    nlohmann::json row{{"body", a.body},
                       {"form", a.form},
                       {"particles_per_cell", a.particles_per_cell},
                       {"cells_per_m", a.cells},
                       {"area_over_true_area", a.ratios},
                       {"largest_error", largest_error(a)}};
    if (a.form == "standard") {
      row["at_most"] = claim_of(a).most;
      row["why"] = claim_of(a).why;
      row["holds"] = holds(a);
    }
    rows.push_back(row);
  }
  return {{"study", "surface"}, {"areas", rows}};
}

std::string as_markdown(const std::vector<Areas>& all) {
  const auto& cells = all.front().cells;
  std::string text = fmt::format(
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study surface --out paper writes it anew. -->\n"
      "# The area that the surface measure finds\n\nArea found over true area, for bodies about two metres across and so many cells in a "
      "metre; "
      "particles on a jittered lattice. The published form is that of Sec. 6.6 of the paper.\n\n| body | form | particles a cell | {} | "
      "claim |\n|---|---|---|{}---|\n",
      fmt::join(cells, " | "), fmt::join(std::vector<std::string>(cells.size(), "---|"), ""));
  for (const Areas& a : all) text += fmt::format("| {} | {} | {} | {} | {} |\n", a.body, a.form, a.particles_per_cell, ratios(a), claim(a));
  text += "\n";
  for (const bool smooth : {true, false})
    for (const Areas& a : all)
      if (a.form == "standard" && a.smooth == smooth) {
        text += fmt::format("- {}: {}.\n", smooth ? "Smooth bodies" : "Bodies with edges", claim_of(a).why);
        break;
      }
  return text;
}

}  // namespace

bool run_surface(const StudyOptions& options) {
  const std::vector<Areas> all = measure_areas(options.quick);
  bool held = true;
  for (const Areas& a : all) held &= holds(a);
  const std::string text = as_markdown(all);
  fmt::print("{}", text);
  write_tables(options, "surface", as_json(all), text);
  fmt::print("\n{}; written to {}\n", held ? "every band holds" : "NOT every band holds", options.out.string());
  return held;
}

}  // namespace bake::studies

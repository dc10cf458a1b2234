// SPDX-License-Identifier: MIT
// The study of convergence: every case at its resolutions, in one table.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/common/study.h"
#include "experiments/convergence/cases.h"
#include "solver/core/errors.h"
#include "solver/core/tell.h"
#include "solver/io/provenance.h"

namespace bake::studies {

namespace {

using nlohmann::json;

/// One row of the table for each quantity of the case.
json measure(const ConvergenceCase& c, bool quick) {
  json rows = json::array();
  fmt::print("{}: {}\n", c.name, c.solution);
  for (const Errors& e : c.measure(quick)) {
    fmt::print("  {}\n", in_words(e));
    json row = as_json(e);
    row["case"] = c.name;
    row["exact_solution"] = c.solution;
    row["measured_by"] = provenance();
    row["quick"] = quick;
    rows.push_back(row);
  }
  return rows;
}

/// The rows of a case in a table that was written before.
json stored(const std::filesystem::path& file, const ConvergenceCase& c) {
  json rows = json::array();
  std::ifstream in(file);
  if (!in) return rows;
  const json table = json::parse(in);
  for (json row : table.at("orders"))
    if (row.at("case") == c.name) {
      if (!row.contains("measured_by")) row["measured_by"] = table.at("provenance");
      rows.push_back(std::move(row));
    }
  return rows;
}

std::string band(const json& row) {
  Errors e;
  e.figure = row["figure"] == "order" ? Errors::Figure::order : Errors::Figure::largest_error;
  e.low = row["low"], e.high = row["high"];
  return band_in_words(e);
}

std::string as_markdown(const json& rows) {
  std::string text =
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study convergence --out paper writes it anew. -->\n"
      "# Orders of convergence\n\nRelative errors against exact solutions. An order is the least-squares slope of the errors in double "
      "logarithmic scale.\n\n| case | quantity | refined | errors | figure | band | verdict |\n|---|---|---|---|---|---|---|\n";
  const auto word = [](const json& row, const char* key) { return row[key].get<std::string>(); };
  for (const json& row : rows)
    text += fmt::format("| {} | {} | {} {} | {} | {} {:.3g} | {} | {} |\n", word(row, "case"), word(row, "quantity"),
                        fmt::join(row["refinements"].get<std::vector<double>>(), ", "), word(row, "refined"),
                        fmt::join(short_numbers(row["errors"].get<std::vector<double>>()), ", "),
                        row["figure"] == "order" ? "order" : "largest", row["value"].get<double>(), band(row),
                        row["holds"].get<bool>() ? "holds" : "MISSED");
  text += "\n## The cases, and why the bands are what they are\n";
  json last;
  for (const json& row : rows) {
    if (row["case"] != last) text += fmt::format("\n**{}**: {}.\n", word(row, "case"), word(row, "exact_solution"));
    last = row["case"];
    text += fmt::format("- {}: {}.\n", word(row, "quantity"), word(row, "why"));
  }
  return text;
}

void expect_known(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (std::none_of(all_cases().begin(), all_cases().end(), [&](const ConvergenceCase& c) { return c.name == name; })) {
      std::vector<std::string> known;
      for (const ConvergenceCase& c : all_cases()) known.push_back(c.name);
      throw InputError(fmt::format("--case: found \"{}\", allowed: {}", name, fmt::join(known, ", ")));
    }
}

}  // namespace

bool run_convergence(const StudyOptions& options) {
  expect_known(options.cases);
  const auto file = options.out / "orders.json";
  json rows = json::array();
  bool held = true;
  for (const ConvergenceCase& c : all_cases()) {
    const bool asked = options.cases.empty() || std::find(options.cases.begin(), options.cases.end(), c.name) != options.cases.end();
    const auto start = std::chrono::steady_clock::now();
    for (json& row : asked ? measure(c, options.quick) : stored(file, c)) {
      held &= row["holds"].get<bool>();
      rows.push_back(std::move(row));
    }
    if (asked) tell_user("{}: {:.1f} s", c.name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  write_tables(options, "orders", {{"study", "convergence"}, {"orders", rows}}, as_markdown(rows));
  fmt::print("{}; written to {}\n", held ? "every band holds" : "NOT every band holds", options.out.string());
  return held;
}

}  // namespace bake::studies
